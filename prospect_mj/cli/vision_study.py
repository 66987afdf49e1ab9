"""The command line of the study of vision."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.experiment.studies.vision_study import (
    Observatory,
    Samples,
    VisionStudySettings,
    histogram_banks,
    record,
)

if TYPE_CHECKING:
    from prospect_mj.experiment.studies.vision_study import Sample
    from prospect_mj.sim.pinhole import Pinhole


@dataclass(frozen=True)
class StudyOptions:
    """Measure vision over many presentations, and draw what it sees.

    Writes the banks of histograms that the studies of the learner start from.
    """

    banks: Path = Path("runs/histograms.npz")
    """Archive of the histograms."""
    images: Path = Path("docs/images")
    """Folder of the pictures."""
    study: Annotated[VisionStudySettings, tyro.conf.arg(name="")] = field(
        default_factory=VisionStudySettings
    )
    """What is measured."""


def main(argv: Sequence[str] | None = None, prog: str = "vision_study.py") -> int:
    """Run the study as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_study, StudyOptions(), prog, argv)


def _study(options: StudyOptions) -> None:
    """Record, measure, draw and save."""
    study = options.study
    rng = np.random.default_rng(study.seed)
    total = 2 * (study.train + study.test)
    with (
        Observatory(study) as observatory,
        tqdm(total=total, unit="look", dynamic_ncols=True, disable=None) as bar,
    ):
        train = record(observatory, study.train, rng, bar.update)
        test = record(observatory, study.test, rng, bar.update)
        eyes = observatory.eyes
    options.banks.parent.mkdir(parents=True, exist_ok=True)
    histogram_banks(train, test).save(options.banks)
    _report([sample for taken in train.values() for sample in taken])
    _draw(train, eyes, options.images)


def _draw(train: Samples, eyes: "tuple[Pinhole, Pinhole]", folder: Path) -> None:
    from prospect_mj.experiment.studies import vision_plots

    pictures: dict[str, Callable[[], bytes]] = {
        "vision_looks.png": lambda: vision_plots.looks(train),
        "vision_segmentation.png": lambda: vision_plots.segmentation(train, eyes),
        "vision_histograms.png": lambda: vision_plots.histograms(train),
    }
    folder.mkdir(parents=True, exist_ok=True)
    bar = tqdm(pictures.items(), "drawing", unit="picture", disable=None)
    for name, picture in bar:
        (folder / name).write_bytes(picture())
        tqdm.write(f"wrote {folder / name}")


def _report(samples: "list[Sample]") -> None:
    """Print the figures of pose and time."""
    found = np.mean([sample.look.status == "found" for sample in samples])
    print(f"presentations {len(samples)}, found {100 * found:.1f} %")
    _print_spread("position error [mm]", [1e3 * s.position_error for s in samples])
    _print_spread("axis error [deg]", [np.degrees(s.axis_error) for s in samples])
    _print_spread("images and look [ms]", [1e3 * s.seconds for s in samples])


def _print_spread(name: str, values: list[float]) -> None:
    """Print median, 95th percentile and largest of some values."""
    median, most = np.percentile(values, [50, 95])
    print(f"{name}: median {median:.2f}, 95 % {most:.2f}, max {max(values):.2f}")
