"""The histograms that a run's weights are looked at with."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.recording import shipped
from prospect_mj.recording.hands import NUMBERS
from prospect_mj.recording.recording import Recording
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


@dataclass(frozen=True, eq=False)
class SeenHistograms:
    """What the jar looked like in some presentations of both orientations."""

    counts: Mapping[Orientation, NDArray[np.int64]]
    """(n, 100) [pixels] per side of the lid, n at least 1."""
    source: str
    """Where they come from, in words."""

    @classmethod
    def of(
        cls, kept: Mapping[Orientation, NDArray[np.int64]], config: TrainConfig
    ) -> Self:
        """Those of a run's own episodes, or of a recording if they lack a side.

        Args:
            kept: (n, 100) [pixels] per side of the lid; n may be 0, a side may lack.
            config: of the run.

        Raises:
            RecordingError: if a recording is damaged, or lacks a side as well.
        """
        for source, counts in _sources(kept, config):
            if all(len(counts.get(side, ())) for side in ORIENTATIONS):
                return cls(counts, source)
        raise RecordingError("the recording has not both orientations")


def _sources(
    kept: Mapping[Orientation, NDArray[np.int64]], config: TrainConfig
) -> Iterator[tuple[str, Mapping[Orientation, NDArray[np.int64]]]]:
    """What there is, in words, and its histograms; read only if it is asked for."""
    yield "the kept episodes", kept
    if config.physics == "recorded" and config.recording is not None:
        path = Path(config.recording)
        # The run may have been made elsewhere.
        if path.is_dir():
            yield "its recording", _recorded(Recording.load(path))
    yield (
        "the shipped recording",
        _recorded(Recording.load(shipped.folder(config.world))),
    )


def _recorded(recording: Recording) -> dict[Orientation, NDArray[np.int64]]:
    shown = recording.presentations
    return {side: shown.histogram[shown.lid == lid] for side, lid in NUMBERS.items()}
