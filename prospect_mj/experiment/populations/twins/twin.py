"""What there is for every learner that has a compiled twin."""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.populations.kernels.graph import (
    Graph,
    Outcomes,
    Rule,
    Trials,
)

State = Any
"""The tuple of arrays that a kernel works on, of another type for every learner."""
Run = Callable[
    [State, Graph, Trials, Rule, Outcomes, np.random.Generator], tuple[int, int]
]


class Twin(NamedTuple):
    """How a readable learner is run by compiled code."""

    begin: Callable[[Any, Trials], State]
    """State of a learner without experience, to run on some trials."""
    run: Run
    """The kernel."""
    end: Callable[[Any, State, int], None]
    """Lets the learner take over a state, and how many transitions were learned from,
    as if it had learned all of it itself."""
    splits: Callable[[State], NDArray[np.int64]]
    """(h, 6): the trial in which each context, a haptic state and an action, was first
    split by a feature, counted from 0; -1 where it never was."""


def never_split(n_haptic: int, n_actions: int) -> NDArray[np.int64]:
    """The splits of a learner that knows none."""
    return np.full((n_haptic, n_actions), -1, np.int64)
