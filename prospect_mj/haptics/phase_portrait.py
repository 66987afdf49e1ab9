"""What a grasp felt like, as samples of the phase portrait of its controller."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import InvalidValue

_APART = 0.05
"""Between two probes at least [s]: the fingers lift off in between, which alone takes
0.1 s. Within a probe the samples are one control period of 0.02 s apart."""


def phase_samples(felt: NDArray[np.floating]) -> NDArray[np.float64]:
    """Residual, rate and number of the probe of every sample of a grasp.

    The rate is the residual's change since the sample before, d eps / dt. In the first
    sample of a probe it is zero, as in the grasp controller itself.

    Args:
        felt: (m, 2), time [s] and residual [1] of each control period in which all
            three fingertips touched (`GraspResult.trajectory`); rows after the last
            one may be NaN.

    Returns:
        (k, 3), residual [1], rate [1/s] and probe, from 0.

    Raises:
        InvalidValue: if times don't increase.
    """
    known = np.asarray(felt, np.float64).reshape(-1, 2)
    seconds, residual = known[~np.isnan(known[:, 0])].T
    elapsed = np.diff(seconds)
    if (elapsed <= 0).any():
        worst = float(elapsed.min())
        raise InvalidValue("time between two samples", worst, "seconds above 0")
    again = elapsed >= _APART
    rate, probe = np.zeros((2, len(seconds)))
    rate[1:] = np.where(again, 0.0, np.diff(residual) / elapsed)
    probe[1:] = np.cumsum(again)
    return np.column_stack([residual, rate, probe])


def together(
    trajectories: list[NDArray[np.float64]],
) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
    """All samples (n, 3), and where each trajectory begins among them.

    Raises:
        InvalidValue: if there is a trajectory without samples, or none at all.
    """
    lengths = [len(samples) for samples in trajectories]
    if not lengths or min(lengths) == 0:
        raise InvalidValue("lengths of trajectories", lengths, "samples in each")
    return np.concatenate(trajectories), np.cumsum([0, *lengths[:-1]])
