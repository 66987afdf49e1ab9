"""The state of a trial between two of its actions."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.actions.belief import Belief
from prospect_mj.supervisor.predicates import PredicateState


@dataclass(frozen=True)
class TrialState:
    """All that the rest of a trial depends on, between two of its actions."""

    physics: np.ndarray
    """MuJoCo's integration state (n,)."""
    belief: Belief
    """The controllers' memory."""
    predicates: PredicateState
    """The supervisor's memory."""
