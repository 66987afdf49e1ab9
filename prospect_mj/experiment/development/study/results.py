"""All that the study came to, part by part; None or empty where a part was left out."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import pyarrow as pa

from prospect_mj.experiment.development.haptics.haptics import HapticResults
from prospect_mj.experiment.development.rivals.rivals import RivalResults
from prospect_mj.experiment.development.study.found import Discovered
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.measured import (
    Measured,
    MeasuredCurves,
    Told,
)
from prospect_mj.experiment.development.study.rows import Row
from prospect_mj.experiment.development.study.settings import Extent, StudySettings
from prospect_mj.experiment.populations.population import Population


class Single(NamedTuple):
    """A row with the population itself, for what single runs do."""

    row: Row
    population: Population


@dataclass
class Results:
    """Filled part by part."""

    settings: StudySettings
    extent: Extent
    recording: Path | None = None
    """Folder of the standard world's recording; None: that comes with the package."""
    recordings: Path | None = None
    """Folder of the others; None: those that come with the package."""
    learners: list[Told] = field(default_factory=list)
    """Every learner under both rules, controls among them."""
    towards_abstract: list[Measured] = field(default_factory=list)
    """Learners with a thing of the abstract task (`abstract_rows`)."""
    outcomes: IdealOutcomes | None = None
    """Recorded ones beside those of the abstract task."""
    singles: list[Single] = field(default_factory=list)
    """The four learners, failed actions being suppressed."""
    causal: list[Measured] = field(default_factory=list)
    population: list[Told] = field(default_factory=list)
    """Spread populations."""
    looks: pa.Table | None = None
    """Under `looks.LOOKS`."""
    worlds: list[MeasuredCurves] = field(default_factory=list)
    change: list[MeasuredCurves] = field(default_factory=list)
    """After the change."""
    formerly_easy: list[Measured] = field(default_factory=list)
    """The same rows, of their formerly easy trials."""
    found: Discovered | None = None
    haptics: HapticResults | None = None
    touches: list[MeasuredCurves] = field(default_factory=list)
    """Learners that are told more or less of a grasp."""
    by_number: list[MeasuredCurves] = field(default_factory=list)
    """The one that discovers, told categories of other numbers of models."""
    rivals: RivalResults | None = None
    seconds: Mapping[str, float] = field(default_factory=dict)
    """Wall time of each part in this command [s]."""
    learning_seconds: float = 0.0
    """Wall time in which all populations learned, in this command or earlier [s]."""
