"""Size of the study of haptic categories."""

from dataclasses import dataclass, field

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import ClusterSettings
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.recording.worlds import STANDARD

JARS = (STANDARD, "wide-lid", "narrow-lid")
"""Worlds whose jar is grasped live: lids of 45, 48 and 42 mm radius on a body of 36 mm.
One of 38 mm the eyes take for no lid."""

_LEAST_GRASPED = 8
"""Two presentations of each orientation: one to learn from, one to be tried on."""


@dataclass(frozen=True)
class HapticSettings:
    """What is grasped, clustered and learned."""

    clusters: ClusterSettings = field(default_factory=ClusterSettings)
    """Three models: hand-overs of the body feel unlike grasps of it out of the cradle.
    The report has other numbers beside."""
    most_models: int = 5
    """Numbers of models up to this one are compared."""
    grasped: int = 24
    """Live grasps of each jar out of the cradle, and as many hand-overs: both hands at
    a quarter as many presentations of each orientation. 0: no jar is grasped live."""
    runs: int = 1000
    """Of every learner."""
    seed: int = 0
    """Of presentations, clustering, learners and resamples."""

    def __post_init__(self) -> None:
        """Refuse sizes of no study."""
        check_integer("numbers of models", self.most_models, 1, 20)
        check_integer("live grasps", self.grasped, 0, 10_000)
        if self.grasped % 4 or 0 < self.grasped < _LEAST_GRASPED:
            expected = f"0, or a multiple of 4 from {_LEAST_GRASPED}"
            raise InvalidValue("live grasps", self.grasped, expected)
        check_integer("runs", self.runs, 2, 100_000)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
