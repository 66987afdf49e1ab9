"""Splits that aren't discovered: when which contexts are told the orientation."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.action_numbers import GRASPS, INSERTS
from prospect_mj.agent.settings import DiscoverySettings

ACTIONS = {"grasp": GRASPS, "insert": INSERTS}
"""Numbers of the actions of a kind, by either hand."""


def forced_after(settings: DiscoverySettings) -> NDArray[np.int64]:
    """The trial after which each context is split by force.

    Returns:
        (n_haptic, n_actions): number of the trial, from 0; -1: after none.
    """
    trial_of = dict(settings.forced_splits)
    named = {action: group for group in trial_of for action in ACTIONS.get(group, ())}
    after = [
        trial_of.get(named.get(action, "others"), -1)
        for action in range(settings.n_actions)
    ]
    return np.tile(np.array(after, np.int64), (settings.n_haptic, 1))
