"""When something is over, and for how long it lasts at most, in blocks of a curve."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.experiment.run.learning_curve import BLOCK, settled


def over(shares: Floats, level: float) -> Floats:
    """End of the last block in which a share is above a level.

    Args:
        shares: (b, s); a block that is NaN is passed over.
        level: [1].

    Returns:
        (b,) [trials]; infinite where the last block of all is above, NaN where none is.
    """
    ends = BLOCK * settled(shares, level)
    return np.where((shares > level).any(axis=1), ends, np.nan)


def longest(holds: NDArray[np.bool_]) -> Floats:
    """Longest stretch of successive blocks in which something holds.

    Args:
        holds: (b, s).

    Returns:
        (b,) [trials].
    """
    running, most = np.zeros((2, len(holds)))
    for block in holds.T:
        running = np.where(block, running + 1, 0.0)
        most = np.maximum(most, running)
    return BLOCK * most
