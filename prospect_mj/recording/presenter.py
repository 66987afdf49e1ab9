"""Drawing from the presentations of a recording."""

from pathlib import Path

import numpy as np

from prospect_mj.recording import files
from prospect_mj.recording.config import Extent
from prospect_mj.recording.hands import NUMBERS
from prospect_mj.recording.recording import Recording
from prospect_mj.task.presentation import Orientation


class GrowingPresenter:
    """Draws presentations of a recording that grows, be they there yet or not.

    Args:
        folder: of the recording.

    Attributes:
        presentations: of each orientation, that are drawn from: those of a usual
            recording, or more if there are more in the folder.
    """

    def __init__(self, folder: Path) -> None:
        """Count what is there; trees that a trial plants later don't add to it."""
        there = files.n_presentations(folder)
        self.presentations = max(Extent.presentations, there)

    def draw(self, rng: np.random.Generator) -> int:
        """The number of a presentation, of whichever orientation.

        Args:
            rng: source of chance.
        """
        return int(rng.integers(self.presentations))


class Presenter:
    """Draws presentations that are complete, each as often as any other.

    Args:
        recording: where they are.
        depth: executed actions that a trial may have; presentations with less than
            that recorded are not shown.
    """

    def __init__(self, recording: Recording, depth: int) -> None:
        """Find the presentations that are complete.

        Raises:
            RecordingError: if there is none for a side of the lid.
        """
        complete = recording.complete(depth)
        lids = recording.presentations.lid[complete]
        self._complete = {side: complete[lids == lid] for side, lid in NUMBERS.items()}

    def draw(self, orientation: Orientation, rng: np.random.Generator) -> int:
        """The number of a presentation.

        Args:
            orientation: the side on which the lid lies.
            rng: source of chance.
        """
        return int(rng.choice(self._complete[orientation]))
