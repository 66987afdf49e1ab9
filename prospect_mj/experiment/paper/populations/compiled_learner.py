"""The compiled learner: whole runs of trials, as fast as the processor allows."""

from typing import get_args

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import (
    N_BINS,
    N_FEATURES,
    FeatureSettings,
    Holding,
    StateFeatureGenerator,
)
from prospect_mj.agent.settings import LearnerSettings
from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.experiment.paper.populations import kernel
from prospect_mj.experiment.paper.populations.kernel import (
    N_ACTIONS,
    PARTS,
    Graph,
    Memory,
    Outcomes,
    Rule,
    Trials,
)


def run_trials(
    weights: NDArray[np.float64],
    graph: Graph,
    trials: Trials,
    settings: LearnerSettings,
    one_hot: bool = False,
    bootstrap_at_truncation: bool = True,
) -> Outcomes:
    """Learn from every trial in turn.

    Args:
        weights: theta, (6, 303), updated in place.
        graph: what actions lead to.
        trials: what is presented.
        settings: the learner's.
        one_hot: the reading of the features (see `agent.features`).
        bootstrap_at_truncation: whether a cut-off trial's last action counts the value
            of what would follow.

    Raises:
        InvalidValue: if an array is of the wrong size, there is a state without any
            choice, or the learner diverges.
        RecordingError: if an action's outcome is not known.
    """
    rule = Rule(
        settings.step_size,
        settings.epsilon,
        settings.discount,
        one_hot,
        bootstrap_at_truncation,
    )
    return _run(weights, graph, trials, rule)


def run_frozen(
    weights: NDArray[np.float64], graph: Graph, trials: Trials, one_hot: bool = False
) -> Outcomes:
    """Follow the greedy policy without learning; arguments and result as above."""
    return _run(weights, graph, trials, Rule(0.0, 0.0, 0.0, one_hot, False))


def _run(
    weights: NDArray[np.float64], graph: Graph, trials: Trials, rule: Rule
) -> Outcomes:
    _check_sizes(weights, graph, trials)
    _check_choices(graph.choices)
    shape = trials.draws.shape[:2]
    outcomes = Outcomes(
        np.full(shape[0], shape[1], np.int8),
        np.zeros(shape[0], np.bool_),
        np.full(shape, -1, np.int8),
        np.full(shape, -1, np.int32),
    )
    memory = _memory(weights, rule.one_hot)
    ended, trial = kernel.walk_trials(memory, graph, trials, rule, outcomes)
    if ended == kernel.UNKNOWN_OUTCOME:
        raise RecordingError(f"an outcome of trial {trial} was not recorded")
    if ended == kernel.DIVERGED:
        raise InvalidValue(
            f"temporal-difference error of trial {trial}",
            "NaN or infinite",
            "a finite number (step size x |features|^2 must stay below 2)",
        )
    return outcomes


def _memory(weights: NDArray[np.float64], one_hot: bool) -> Memory:
    """The weights, and room for what is known in a trial."""
    settings = FeatureSettings(reading="one_hot" if one_hot else "product")
    generate = StateFeatureGenerator(settings).generate
    full = np.stack([generate(np.ones(N_BINS), hand) for hand in get_args(Holding)])
    busy = [full[:, begin:end].any(axis=1) for begin, end in PARTS]
    return Memory(
        weights=weights,
        features=np.zeros(full.shape),
        busy=np.stack(busy, axis=1),
        values=np.empty((len(full), N_ACTIONS)),
        known=np.zeros(len(full), np.bool_),
    )


def _check_sizes(weights: NDArray[np.float64], graph: Graph, trials: Trials) -> None:
    """Refuse what the compiled code would read beyond its end."""
    n_trials, max_actions, _ = trials.draws.shape
    n, n_images = len(graph.child), len(trials.visual)
    n_phases, n_states, _ = graph.choices.shape
    check_integer("actions per trial", max_actions, 1, np.iinfo(np.int8).max)
    for what, array, shape in (
        ("weights", weights, (N_ACTIONS, N_FEATURES)),
        ("children", graph.child, (n, N_ACTIONS)),
        ("choices", graph.choices, (n_phases, n_states, N_ACTIONS)),
        ("scaled histograms", trials.visual, (n_images, N_BINS)),
        ("draws", trials.draws, (n_trials, max_actions, 2)),
    ):
        if array.shape != shape:
            raise InvalidValue(f"shape of {what}", array.shape, str(shape))
    for what, numbers, length, end in (
        ("situations", graph.situation, n, n),
        ("insertions", graph.inserted, n, 2),
        ("holding hands", graph.holding, n, 3),
        ("states", graph.state, n, n_states),
        ("roots", trials.root, n_trials, n),
        ("images", trials.image, n_trials, n_images),
        ("phases", trials.phase, n_trials, n_phases),
    ):
        if numbers.shape != (length,):
            raise InvalidValue(f"shape of {what}", numbers.shape, f"({length},)")
        if length and not 0 <= numbers.min() <= numbers.max() < end:
            wrong = numbers.min() if numbers.min() < 0 else numbers.max()
            raise InvalidValue(what, int(wrong), f"0 to {end - 1}")


def _check_choices(choices: NDArray[np.bool_]) -> None:
    """Refuse a graph that leaves the learner nothing to choose from."""
    for phase, state in np.argwhere(~choices.any(axis=2)):
        raise InvalidValue(
            f"choice set of state {state} in phase {phase}", [], "an action at least"
        )
