"""The result of a look at the object."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Status = Literal["found", "unsure", "not_found"]


@dataclass(frozen=True, eq=False)
class Look:
    """What one stereo image pair tells; a failure to see is a value, too."""

    status: Status
    """"found": the pose may be used. "unsure": something is there, but its pose can't
    be trusted. "not_found": nothing is there."""
    reason: str
    """Why it is not "found"; empty if it is."""
    histogram: NDArray[np.int64]
    """(100,) [pixels]: intensities of the object in the left eye, dark first."""
    masks: tuple[NDArray[np.uint8], NDArray[np.uint8]]
    """Object pixels (1) of the left and the right image, (rows, columns) each."""
    position: NDArray[np.float64] | None = None
    """Middle of the object's axis (3,) [m]; None unless "found"."""
    axis: NDArray[np.float64] | None = None
    """Its horizontal direction (3,), a unit vector with y > 0; None unless "found"."""
