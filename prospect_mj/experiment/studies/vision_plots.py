"""Pictures of what vision sees, for the documentation."""

from itertools import product

import cv2
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS, StateFeatureGenerator
from prospect_mj.experiment.run.plots import png
from prospect_mj.experiment.studies.vision_study import Sample, Samples
from prospect_mj.sim.pinhole import Pinhole

GAMMA = 2.2
"""Images are shown with dark levels lifted: grey^(1 / GAMMA) instead of grey."""

_SHOWN = 3
_SCALE = 4
_COLOURS = {"left": "#1f6fb4", "right": "#c8611a"}
_OUTLINE = (70, 220, 90)
_POSE = (240, 70, 60)
_CROP = (slice(30, 210), slice(26, 290))


def looks(samples: Samples) -> bytes:
    """What the left eye saw, a row of presentations per orientation, as PNG."""
    figure = Figure(figsize=(9, 4.6), dpi=110, layout="constrained")
    grid = figure.subplots(2, _SHOWN)
    for axes, (side, taken) in zip(grid, samples.items(), strict=True):
        for panel, sample in zip(axes, taken, strict=False):
            _show(panel, lifted(sample.pair.left))
        axes[0].set_ylabel(f"lid {side}", fontsize=12)
    for number, panel in enumerate(grid[0], 1):
        panel.set_title(f"presentation {number}", fontsize=11)
    return png(figure)


def segmentation(samples: Samples, eyes: tuple[Pinhole, Pinhole]) -> bytes:
    """Both eyes' outline of the object and the axis estimated from it, as PNG."""
    figure = Figure(figsize=(12, 4.4), dpi=110, layout="constrained")
    grid = figure.subplots(2, 4)
    for axes, (side, taken) in zip(grid, samples.items(), strict=True):
        for panel, (sample, which) in zip(
            axes, product(taken[:2], range(2)), strict=True
        ):
            _show(panel, _outlined(sample, eyes[which], which))
        axes[0].set_ylabel(f"lid {side}", fontsize=12)
    for panel, (number, eye) in zip(
        grid[0], product((1, 2), ("left", "right")), strict=True
    ):
        panel.set_title(f"presentation {number}, {eye} eye", fontsize=10)
    return png(figure)


def histograms(samples: Samples) -> bytes:
    """Mean and spread of the visual features of both orientations, as PNG."""
    figure = Figure(figsize=(9, 3.6), dpi=110, layout="constrained")
    axes = figure.subplots()
    for side, taken in samples.items():
        _draw_spread(axes, side, taken)
    axes.set(xlabel="intensity bin", ylabel="feature v")
    axes.set(xlim=(-0.5, N_BINS - 0.5), ylim=(0, None))
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, title="mean and 5-95 %")
    return png(figure)


def lifted(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A copy of an image (rows, columns, 3) whose dark parts can be seen on paper."""
    levels = np.arange(256) / 255
    table = np.rint(255 * levels ** (1 / GAMMA)).astype(np.uint8)
    return table[image]


def _draw_spread(axes: Axes, side: str, taken: list[Sample]) -> None:
    features, bins = StateFeatureGenerator(), np.arange(N_BINS)
    v = np.array([features.scaled_histogram(s.look.histogram) for s in taken])
    low, high = np.percentile(v, [5, 95], axis=0)
    colour = _COLOURS[side]
    axes.fill_between(bins, low, high, step="mid", color=colour, alpha=0.2, lw=0)
    axes.step(bins, v.mean(axis=0), where="mid", color=colour, label=f"lid {side}")


def _outlined(sample: Sample, eye: Pinhole, which: int) -> NDArray[np.uint8]:
    """A lifted image with the mask's outline in green, the estimated axis in red."""
    image = _enlarged(lifted(sample.pair[which]))
    mask = _enlarged(sample.look.masks[which])
    outline, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(image, outline, -1, _OUTLINE, 4)
    if sample.look.position is not None:
        reach = np.outer([-0.1, 0.0, 0.1], sample.look.axis)
        # A pixel's centre is its whole number.
        pixels = _SCALE * (eye.project(sample.look.position + reach) + 0.5)
        start, middle, end = np.rint(pixels).astype(int).tolist()
        cv2.line(image, start, end, _POSE, 4, cv2.LINE_AA)
        cv2.circle(image, middle, 11, _POSE, -1, cv2.LINE_AA)
    return image


def _enlarged(image: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.ascontiguousarray(image.repeat(_SCALE, axis=0).repeat(_SCALE, axis=1))


def _show(axes: Axes, image: NDArray[np.uint8]) -> None:
    """Show the part of an image round the pedestal."""
    scale = image.shape[0] // 240
    rows, columns = (slice(scale * s.start, scale * s.stop) for s in _CROP)
    axes.imshow(image[rows, columns], interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)
