"""Measure vision over many presentations; draw what it sees for docs/vision.md.

Writes the banks of histograms that the studies of the learner start from.
"""

import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from prospect_mj.cli import command_line
from prospect_mj.experiment import vision_plots
from prospect_mj.experiment.vision_study import (
    Observatory,
    Sample,
    VisionStudySettings,
    histogram_banks,
    record,
)


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
    write(chosen.images / "vision_looks.png", vision_plots.looks(train))
    segmentation = vision_plots.segmentation(train, eyes)
    write(chosen.images / "vision_segmentation.png", segmentation)
    write(chosen.images / "vision_histograms.png", vision_plots.histograms(train))


def write(path: Path, content: bytes) -> None:
    """Write a picture and say so."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(content)
    print(f"wrote {path}")


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


if __name__ == "__main__":
    sys.exit(main())
