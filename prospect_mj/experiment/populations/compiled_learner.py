"""Compiled learners: whole runs of trials, as fast as the processor allows."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import AnyLearnerSettings, Learner, LinearQ
from prospect_mj.agent.failed_actions import FailedActions
from prospect_mj.agent.features import N_BINS
from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue, RecordingError
from prospect_mj.experiment.populations.kernels.graph import (
    DIVERGED,
    N_ACTIONS,
    UNKNOWN_OUTCOME,
    Graph,
    Outcomes,
    Rule,
    Trials,
)
from prospect_mj.experiment.populations.twins import linear_twin
from prospect_mj.experiment.populations.twins.twin import State, Twin
from prospect_mj.experiment.populations.twins.twins import TWINS


class Walked(NamedTuple):
    """What a learner did in a run."""

    outcomes: Outcomes
    """In every trial."""
    splits: NDArray[np.int64]
    """(h, 6): trial in which each context was first split, or -1 (see `Twin.splits`)"""


def rule_of(
    settings: AnyLearnerSettings,
    one_hot: bool = False,
    bootstrap_at_truncation: bool = True,
    failed_actions: FailedActions = "allowed",
) -> Rule:
    """What a learner's run keeps to.

    Args:
        settings: the learner's.
        one_hot: the reading of the linear features (see `agent.features`).
        bootstrap_at_truncation: whether a cut-off trial's last action counts the value
            of what would follow.
        failed_actions: the rule for them (see `agent.failed_actions`).
    """
    suppress = failed_actions == "suppressed"
    return Rule(
        settings.epsilon, settings.discount, one_hot, bootstrap_at_truncation, suppress
    )


def run_trials(
    learner: Learner,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    rng: np.random.Generator,
    take_over: bool = True,
) -> Walked:
    """Learn from every trial in turn.

    Args:
        learner: without experience yet; it is another one afterwards.
        graph: what actions lead to.
        trials: what is presented.
        rule: what is kept to.
        rng: for learning.
        take_over: whether the learner is told all that was learned, as if it had
            learned it itself. Without, it is fit for nothing afterwards.

    Raises:
        InvalidValue: if an array is of the wrong size, there is a state without any
            choice, or the learner diverges.
        RecordingError: if an action's outcome is not known.
    """
    twin = TWINS[type(learner.settings)]
    state = twin.begin(learner, trials)
    outcomes = _run(twin, state, graph, trials, rule, rng)
    if take_over:
        twin.end(learner, state, int(outcomes.n_actions.sum()))
    return Walked(outcomes, twin.splits(state))


def run_frozen(
    learner: LinearQ, graph: Graph, trials: Trials, one_hot: bool = False
) -> Outcomes:
    """Follow the greedy policy without learning; arguments and result as above."""
    state = linear_twin.begin(learner, trials)._replace(step_size=0.0)
    rule = Rule(0.0, 0.0, one_hot, False, False)
    unused = np.random.default_rng(0)
    return _run(linear_twin.TWIN, state, graph, trials, rule, unused)


def _run(
    twin: Twin,
    state: State,
    graph: Graph,
    trials: Trials,
    rule: Rule,
    rng: np.random.Generator,
) -> Outcomes:
    n_haptic, n_actions = twin.splits(state).shape
    check_integer("number of actions", n_actions, N_ACTIONS, N_ACTIONS)
    _check_sizes(graph, trials, n_haptic)
    _check_choices(graph.choices)
    shape = trials.draws.shape[:2]
    outcomes = Outcomes(
        np.full(shape[0], shape[1], np.int8),
        np.zeros(shape[0], np.bool_),
        np.full(shape, -1, np.int8),
        np.full(shape, -1, np.int32),
    )
    ended, trial = twin.run(state, graph, trials, rule, outcomes, rng)
    if ended == UNKNOWN_OUTCOME:
        raise RecordingError(f"an outcome of trial {trial} was not recorded")
    if ended == DIVERGED:
        raise InvalidValue(
            f"temporal-difference error of trial {trial}",
            "NaN or infinite",
            "a finite number (step size x |features|^2 must stay below 2)",
        )
    return outcomes


def _check_sizes(graph: Graph, trials: Trials, n_haptic: int) -> None:
    """Refuse what the compiled code would read beyond its end."""
    n_trials, max_actions, _ = trials.draws.shape
    n, n_images = len(graph.child), len(trials.visual)
    n_phases, n_states, _ = graph.choices.shape
    check_integer("actions per trial", max_actions, 1, np.iinfo(np.int8).max)
    for what, array, shape in (
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
        ("haptic states", graph.haptic, n, n_haptic),
        ("states", graph.state, n, n_states),
        ("roots", trials.root, n_trials, n),
        ("images", trials.image, n_trials, n_images),
        ("orientations", trials.orientation, n_trials, 2),
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
