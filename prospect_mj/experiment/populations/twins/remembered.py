"""A kernel's ring of transitions as `agent.experience` has it."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.populations.kernels.ring import Ring


def experience(ring: Ring, left: NDArray, reached: NDArray) -> dict[str, NDArray]:
    """All that is remembered, by the names that `Experience.restore` knows.

    Args:
        ring: of the kernel.
        left: (b, width), the state that was left in each of its transitions.
        reached: (b, width), the one that was reached.
    """
    n_added = int(ring.n_added[0])
    taken = slice(min(n_added, len(ring.shown)))
    return {
        "experience_state": left[taken],
        "experience_action": ring.action[taken],
        "experience_reward": np.full(len(ring.action[taken]), -1.0),
        "experience_next_state": reached[taken],
        "experience_terminated": ring.terminated[taken],
        "experience_allowed": ring.allowed[taken],
        "experience_count": np.array(n_added),
    }
