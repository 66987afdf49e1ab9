"""Size of the study of haptic categories."""

from dataclasses import dataclass, field

import numpy as np

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import ClusterSettings
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.recording.worlds import STANDARD

JARS = (STANDARD, "wide-lid", "narrow-lid")
"""Worlds of the jars: lids of 45, 48 and 42 mm radius on a body of 36 mm. One of 38 mm
the eyes take for no lid."""

_LEAST_GRASPED = 8
"""Two presentations of each orientation: one to learn from, one to be tried on."""
_MOST_GRASPED = 10_000


@dataclass(frozen=True)
class HapticSettings:
    """What is grasped and clustered."""

    clusters: ClusterSettings = field(default_factory=ClusterSettings)
    """Six models: of numbers from two to seven, models of halves of the standard jar's
    recorded grasps agree best then. The report has other numbers beside."""
    starts: int = 200
    """Of clusterings of all grasps of a jar, of whose models learners are told; those
    of a part of the grasps have the starts of `clusters`. One start in thirty comes to
    the best six models of the standard jar."""
    most_models: int = 7
    """Numbers of models up to this one are compared."""
    grasped: int = 72
    """Live grasps out of the cradle of each jar without a recording, and as many
    hand-overs: both hands at a quarter as many presentations of each orientation. 0: no
    jar is grasped live."""
    seed: int = 0
    """Of presentations and clustering."""

    def __post_init__(self) -> None:
        """Refuse sizes of no study."""
        check_integer("starts", self.starts, 1, 10_000)
        check_integer("numbers of models", self.most_models, 1, 20)
        check_grasped(self.grasped)
        check_integer("seed", self.seed, 0, LARGEST_SEED)

    @property
    def per_side(self) -> int:
        """Presentations of a jar that is grasped live, with the lid on each side."""
        return self.grasped // 4

    def rng(self, jar: str) -> np.random.Generator:
        """A jar's own generator: what it draws hangs on no other jar."""
        key = tuple(jar.encode())
        return np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=key))


def check_grasped(number: int) -> None:
    """Refuse numbers of live grasps that can't be made, or tell nothing."""
    check_integer("grasped", number, 0, _MOST_GRASPED)
    if number % 4 or 0 < number < _LEAST_GRASPED:
        expected = f"0, or a multiple of 4 from {_LEAST_GRASPED}"
        raise InvalidValue("grasped", number, expected)
