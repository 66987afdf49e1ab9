"""What the compiled learners walk on, what is presented to them, and what they did."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

N_ACTIONS = 6
DONE, UNKNOWN_OUTCOME, DIVERGED = 0, 1, 2


class Graph(NamedTuple):
    """What every action leads to from n nodes, in s states of the supervisor."""

    child: NDArray[np.int32]
    """(n, 6): the node that an action leads to, the node itself where it is not run, or
    a negative number where the outcome is not known."""
    situation: NDArray[np.int32]
    """(n,): the node in which the trial is after this one."""
    inserted: NDArray[np.bool_]
    """(n,): whether the jar stands in the receptacle, which ends a trial."""
    holding: NDArray[np.int64]
    """(n,): 0 = no hand holds the jar, 1 = left, 2 = right."""
    haptic: NDArray[np.int64]
    """(n,): number of the haptic state (`agent.haptics`), which is `holding` without
    categories of grasps."""
    state: NDArray[np.int32]
    """(n,): number of the supervisor's state."""
    choices: NDArray[np.bool_]
    """(phases, s, 6): whether the learner may choose an action, in every phase of the
    shaping schedule."""


class Trials(NamedTuple):
    """What a run's trials present, and the random numbers of the choices in them."""

    root: NDArray[np.int32]
    """(n_trials,): the node where a trial begins."""
    image: NDArray[np.int32]
    """(n_trials,): row of `visual`."""
    visual: NDArray[np.float64]
    """(n_images, 100) [1], scaled histograms."""
    orientation: NDArray[np.int64]
    """(n_trials,): side of the lid, 0 left, 1 right, for learners that are told."""
    phase: NDArray[np.int32]
    """(n_trials,): phase of the shaping schedule."""
    draws: NDArray[np.float64]
    """(n_trials, max_actions, 2), uniform on [0, 1): those of `epsilon_greedy`."""


class Outcomes(NamedTuple):
    """What the learner did; entries after a trial's last action are -1."""

    n_actions: NDArray[np.int8]
    """(n_trials,) [actions], all that a trial may have where it was not solved."""
    solved: NDArray[np.bool_]
    """(n_trials,): whether the jar was inserted."""
    action: NDArray[np.int8]
    """(n_trials, max_actions): the action taken."""
    node: NDArray[np.int32]
    """(n_trials, max_actions): the node it led to; the one before if it was not run."""


class Rule(NamedTuple):
    """What all learners are told alike."""

    epsilon: float
    """Probability of an action at random [1]."""
    discount: float
    """gamma [1], per action."""
    one_hot: bool
    """The reading of the linear features (see `agent.features`)."""
    bootstrap: bool
    """Whether a cut-off trial's last action counts the value of what would follow."""
    suppress: bool
    """Whether a failed action is suppressed (see `agent.failed_actions`)."""
