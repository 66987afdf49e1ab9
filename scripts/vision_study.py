"""Measure vision over many presentations; draw what it sees for docs/vision.md.

Writes the banks of histograms that the studies of the learner start from.
"""

import sys
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.cli import command_line
from prospect_mj.experiment.vision_study import (
    Observatory,
    Sample,
    Samples,
    VisionStudySettings,
    histogram_banks,
    record,
)
from prospect_mj.sim.pinhole import Pinhole

SHOWN = 3
COLOURS = {"left": "#1f6fb4", "right": "#c8611a"}
CROP = (slice(30, 210), slice(26, 290))


@dataclass(frozen=True)
class Options:
    """Where the results go, and what is measured."""

    banks: Path = Path("runs/histograms.npz")
    """Archive of the histograms."""
    images: Path = Path("docs/images")
    """Folder of the pictures."""
    study: VisionStudySettings = field(default_factory=VisionStudySettings)


def main() -> int:
    """Run the study as the command line says and return the exit code."""
    return command_line.run(lambda: study(options()))


def options() -> Options:
    """The command line."""
    return command_line.parse(Options, sys.argv[1:], Options(), "vision_study.py")


def study(chosen: Options) -> None:
    """Record, measure, draw and save."""
    rng = np.random.default_rng(chosen.study.seed)
    with Observatory(chosen.study) as observatory:
        train = record(observatory, chosen.study.train, rng)
        test = record(observatory, chosen.study.test, rng)
        eyes = observatory.eyes
    chosen.banks.parent.mkdir(parents=True, exist_ok=True)
    histogram_banks(train, test).save(chosen.banks)
    report([sample for taken in train.values() for sample in taken])
    draw_looks(train, chosen.images / "vision_looks.png")
    draw_segmentation(train, eyes, chosen.images / "vision_segmentation.png")
    draw_histograms(train, chosen.images / "vision_histograms.png")


def report(samples: list[Sample]) -> None:
    """Print the figures of pose and time."""
    found = np.mean([sample.look.status == "found" for sample in samples])
    print(f"presentations {len(samples)}, found {100 * found:.1f} %")
    print_spread("position error [mm]", [1e3 * s.position_error for s in samples])
    print_spread("axis error [deg]", [np.degrees(s.axis_error) for s in samples])
    print_spread("images and look [ms]", [1e3 * s.seconds for s in samples])


def print_spread(name: str, values: list[float]) -> None:
    """Print median, 95th percentile and largest of some values."""
    median, most = np.percentile(values, [50, 95])
    print(f"{name}: median {median:.2f}, 95 % {most:.2f}, max {max(values):.2f}")


def draw_looks(samples: Samples, path: Path) -> None:
    """What the left eye saw: a row of presentations per orientation."""
    figure, grid = plt.subplots(2, SHOWN, figsize=(9, 4.5), layout="constrained")
    for axes, (side, taken) in zip(grid, samples.items(), strict=True):
        for panel, sample in zip(axes, taken, strict=False):
            show(panel, sample.pair.left)
        axes[0].set_ylabel(f"lid {side}", fontsize=12)
    save(figure, path)


def draw_segmentation(
    samples: Samples, eyes: tuple[Pinhole, Pinhole], path: Path
) -> None:
    """Both eyes: outline of the object, and the axis that was estimated from it."""
    figure, grid = plt.subplots(2, 4, figsize=(12, 4.4), layout="constrained")
    for axes, (side, taken) in zip(grid, samples.items(), strict=True):
        for i, sample in enumerate(taken[:2]):
            for j, name in enumerate(("left eye", "right eye")):
                panel = axes[2 * i + j]
                show(panel, outlined(sample, eyes[j], j))
                panel.set_title(name, fontsize=9)
        axes[0].set_ylabel(f"lid {side}", fontsize=12)
    save(figure, path)


def outlined(sample: Sample, eye: Pinhole, which: int) -> NDArray[np.uint8]:
    """An image with the mask's outline in green and the estimated axis in red."""
    scale = 4
    image = cv2.resize(
        sample.pair[which], None, fx=scale, fy=scale, interpolation=cv2.INTER_NEAREST
    )
    mask = cv2.resize(
        sample.look.masks[which], image.shape[1::-1], interpolation=cv2.INTER_NEAREST
    )
    outline, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(image, outline, -1, (70, 220, 90), 4)
    if sample.look.position is not None:
        reach = np.outer([-0.1, 0.0, 0.1], sample.look.axis)
        pixels = scale * (eye.project(sample.look.position + reach) + 0.5)
        start, middle, end = np.rint(pixels).astype(int).tolist()
        cv2.line(image, start, end, (240, 70, 60), 4, cv2.LINE_AA)
        cv2.circle(image, middle, 11, (240, 70, 60), -1, cv2.LINE_AA)
    return image


def draw_histograms(samples: Samples, path: Path) -> None:
    """Mean and spread of the visual features of both orientations."""
    features = StateFeatureGenerator()
    figure, axes = plt.subplots(figsize=(9, 3.6), layout="constrained")
    bins = np.arange(100)
    for side, taken in samples.items():
        v = np.array([features.scaled_histogram(s.look.histogram) for s in taken])
        low, high = np.percentile(v, [5, 95], axis=0)
        colour = COLOURS[side]
        axes.fill_between(bins, low, high, step="mid", color=colour, alpha=0.2, lw=0)
        axes.step(bins, v.mean(axis=0), where="mid", color=colour, label=f"lid {side}")
    axes.set(
        xlabel="intensity bin", ylabel="feature v", xlim=(-0.5, 99.5), ylim=(0, None)
    )
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, title="mean and 5-95 %")
    save(figure, path)


def show(axes: Axes, image: NDArray[np.uint8]) -> None:
    """Show the part of an image round the pedestal."""
    scale = image.shape[0] // 240
    rows, columns = (slice(scale * s.start, scale * s.stop) for s in CROP)
    axes.imshow(image[rows, columns], interpolation="nearest")
    axes.set(xticks=[], yticks=[])
    axes.spines[:].set_visible(False)


def save(figure: plt.Figure, path: Path) -> None:
    """Write a picture and say so."""
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)
    plt.close(figure)
    print(f"wrote {path}")


if __name__ == "__main__":
    sys.exit(main())
