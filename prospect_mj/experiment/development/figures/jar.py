"""The picture of the jar, with the grey levels marked that a learner goes by."""

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from prospect_mj.experiment.development.study.pictures import NO_JAR, JarPicture
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.sim.camera import Image

_MARK = np.array([[0, 114, 178], [213, 94, 0]])
"""Blue and vermilion [grey levels], for the lid on the left and on the right."""
_LEAST = 0.25
"""Of the largest; levels that say less are not marked in pictures."""
_PALE, _PAPER = 0.55, 250
"""Contrast of the jar [1], and what stands for all else [grey levels]."""


def marked(picture: JarPicture, levels: Floats) -> Image:
    """The picture in pale grey, pixels of levels that say something in their colour.

    Args:
        picture: of the jar.
        levels: (100,), what each says; see `study.found`.

    Returns:
        (rows, columns, 3) RGB [grey levels].
    """
    grey = picture.image.mean(axis=2, keepdims=True)
    pale = np.repeat(255 - _PALE * (255 - grey), 3, axis=2)
    strength = levels / max(np.abs(levels).max(), np.finfo(float).tiny)
    of_pixel = np.append(strength, 0.0)[picture.level]
    outside = picture.level == NO_JAR
    of_pixel[outside], pale[outside] = 0.0, _PAPER
    weight = np.where(np.abs(of_pixel) < _LEAST, 0.0, np.abs(of_pixel))[..., None]
    colour = _MARK[(of_pixel < 0).astype(int)]
    return ((1 - weight) * pale + weight * colour).astype(np.uint8)


def amid(image: Image, room: NDArray[np.int64]) -> Image:
    """The same picture in the middle of a larger one.

    Args:
        image: (rows, columns, 3) RGB [grey levels].
        room: rows and columns of the larger one.

    Returns:
        (*room, 3) RGB [grey levels], paper around it.
    """
    shown = np.full((*room, 3), _PAPER, np.uint8)
    rows, columns = image.shape[:2]
    top, left = (room - (rows, columns)) // 2
    shown[top : top + rows, left : left + columns] = image
    return shown


def draw_jar(axes: Axes, image: Image) -> None:
    """Show a picture without any axis."""
    axes.imshow(image, interpolation="nearest")
    axes.set_anchor("N")
    axes.set_axis_off()
