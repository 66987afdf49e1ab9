"""What a learner may choose in each of a recording's states, as arrays."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor


def choice_sets(
    supervisor: Supervisor, states: Sequence[PredicateState]
) -> NDArray[np.int8]:
    """The choice set of every state in every phase of the shaping schedule.

    Args:
        supervisor: its mode and its schedule decide.
        states: s states that supervision allows.

    Returns:
        (phases, s, 6), 1 = may be chosen.
    """
    return np.array(
        [
            [supervisor.choice_set(state, trial) for state in states]
            for trial in supervisor.schedule.phases
        ]
    )


def phases(supervisor: Supervisor, trials: ArrayLike) -> NDArray[np.int32]:
    """The phase of the shaping schedule in which each trial is.

    Args:
        supervisor: whose schedule.
        trials: (n,) numbers of trials, from 0.

    Returns:
        (n,) numbers of phases.
    """
    begins = np.array(supervisor.schedule.phases)
    return (np.searchsorted(begins, trials, side="right") - 1).astype(np.int32)
