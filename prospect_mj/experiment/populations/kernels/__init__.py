"""The learners compiled: whole runs, trial after trial, on a graph of outcomes.

Each does what its readable twin in `prospect_mj.agent` does, given the same random
numbers, to the last bit: early on, many values are equal, and a tie that is rounded
away is another action. All of them have one face,

    run(state, graph, trials, rule, outcomes, rng) -> (ended, trial),

where `state` is the learner's own tuple of arrays, changed in place, `rng` the
generator that it learns with (choices have the numbers of `trials.draws`), and `ended`
is DONE, or says what ended the run in that trial. A module's `run` is compiled by
`cache.kept`; what it calls, here or in `walk`, `sums` and `ring`, by plain `njit`.
"""
