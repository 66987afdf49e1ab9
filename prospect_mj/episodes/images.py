"""Images as PNG, which keeps every pixel."""

import cv2
import numpy as np
from numpy.typing import NDArray

from prospect_mj.sim.camera import Image


def as_png(image: Image) -> NDArray[np.uint8]:
    """Encode an image (rows, columns, 3) RGB as the bytes of a PNG file (n,)."""
    _, encoded = cv2.imencode(".png", cv2.cvtColor(image, cv2.COLOR_RGB2BGR))
    return encoded.ravel()


def from_png(encoded: NDArray[np.uint8]) -> Image:
    """Decode what `as_png` has made.

    Raises:
        ValueError: if it is no image.
    """
    image = cv2.imdecode(encoded, cv2.IMREAD_COLOR)
    if image is None:
        raise ValueError("its image is damaged")
    return cv2.cvtColor(image, cv2.COLOR_BGR2RGB)
