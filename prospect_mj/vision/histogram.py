"""The 100-bin intensity histogram of the object's pixels.

Wheeler, Fagg & Grupen (ICDL 2002), section 3.1: the visual feature of a state is the
histogram of the intensities in the fovea, in 100 bins.
"""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from prospect_mj.checks import check_choice
from prospect_mj.sim.camera import Image

N_BINS = 100
WHITE = 255.0
Gain = Literal["automatic", "fixed"]
GAINS: tuple[Gain, ...] = ("automatic", "fixed")
# Grey levels from dark to bright that automatic gain stretches to the full range [%].
_STRETCHED = (1.0, 99.0)
# Weights of red, green and blue in perceived brightness (ITU-R BT.601), in thousandths:
# whole numbers fall into the same bin on every processor.
_LUMA = np.array([299, 587, 114])


def intensity_histogram(pixels: Image, gain: Gain) -> NDArray[np.int64]:
    """Count the object's pixels per bin of intensity.

    Args:
        pixels: (n, 3) RGB [grey levels].
        gain: "automatic" stretches the object's own contrast to the full range, as the
            gain control of a camera does, so that the lamp's brightness drops out;
            "fixed" takes the grey levels as they are.

    Returns:
        (100,) [pixels], dark first; the sum is n.
    """
    check_choice("gain", gain, GAINS)
    if len(pixels) == 0:
        return np.zeros(N_BINS, np.int64)
    grey = pixels @ _LUMA / 1000
    low, high = np.percentile(grey, _STRETCHED) if gain == "automatic" else (0.0, WHITE)
    scale = N_BINS / max(high - low, 1.0)
    bins = np.clip((grey - low) * scale, 0, N_BINS - 1).astype(np.int64)
    return np.bincount(bins, minlength=N_BINS)
