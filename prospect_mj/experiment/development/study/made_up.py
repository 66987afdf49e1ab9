"""Recorded outcomes with made-up pictures, as the abstract task had them.

Each orientation has a prototype, a non-negative histogram, and both have a given
cosine. A picture is that of its orientation, each bin times 1 + noise x a normal
number, not below zero ("Development feasibility", section 1). Prototypes are bumps at
mirrored places, mixed so far that they have the cosine; the feasibility study found
that their shape does not matter.

The abstract task drew noise in every trial. So each presentation is there many times,
with as many pictures: a run draws the same outcomes as without, and hardly any picture
twice.
"""

from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.haptics import LEFT
from prospect_mj.checks import check_number
from prospect_mj.recording.arrays import Presentations
from prospect_mj.recording.recording import Recording

Floats = NDArray[np.float64]

_CENTRE, _WIDTH = 30.0, 12.0
"""Of the darker bump [bins]."""
_LEAST = 0.08
"""Cosine [1], a little above that of the bumps."""
_PICTURES = 20
"""Of each presentation."""
_COUNTS = 1_000_000
"""Pixels of a prototype: so many that whole counts add no noise of their own."""


@dataclass(frozen=True)
class MadeUp:
    """How alike made-up pictures are."""

    cosine: float
    """Between the prototypes of both orientations [1]; 0.08 at least, as the bumps
    overlap."""
    noise: float
    """Standard deviation of a bin's factor [1]."""

    def __post_init__(self) -> None:
        """Refuse what mixing can't reach."""
        check_number("cosine of made-up pictures", self.cosine, _LEAST, 1)
        check_number("noise of made-up pictures", self.noise, 0, 10)

    def prototypes(self) -> Floats:
        """(2, 100) [1]: of the lid on the left and on the right, each of norm 1."""
        bumps = _bumps()
        between = float(bumps[0] @ bumps[1])
        # Shares 1 - m and m of both: with s = 2 m (1 - m) and the bumps' cosine b, the
        # mixed ones have the cosine ((1 - s) b + s) / (1 - s + s b); solved for s, m.
        s = (self.cosine - between) / ((1 - between) * (1 + self.cosine))
        m = (1 - np.sqrt(max(1 - 2 * s, 0.0))) / 2
        mixed = (1 - m) * bumps + m * bumps[::-1]
        return mixed / np.linalg.norm(mixed, axis=1, keepdims=True)

    def presented(self, recording: Recording, rng: np.random.Generator) -> Recording:
        """The same outcomes, looking otherwise; each presentation twenty times.

        Args:
            recording: whose presentations they are.
            rng: draws the noise.
        """
        shown = _often(recording.presentations)
        pictures = self.prototypes()[shown.lid - LEFT]
        pictures *= np.maximum(1 + rng.normal(0.0, self.noise, pictures.shape), 0.0)
        counts = _COUNTS * pictures / pictures.sum(axis=1, keepdims=True)
        histogram = np.rint(counts).astype(np.int64)
        return replace(recording, presentations=replace(shown, histogram=histogram))


def _often(shown: Presentations) -> Presentations:
    """Each presentation many times, one after the other."""
    arrays = {field.name: getattr(shown, field.name) for field in fields(shown)}
    often = {name: np.repeat(array, _PICTURES, 0) for name, array in arrays.items()}
    return Presentations(**often)


def _bumps() -> Floats:
    """(2, 100) [1], each of norm 1."""
    bump = np.exp(-0.5 * ((np.arange(N_BINS) - _CENTRE) / _WIDTH) ** 2)
    bumps = np.stack([bump, bump[::-1]])
    return bumps / np.linalg.norm(bumps, axis=1, keepdims=True)
