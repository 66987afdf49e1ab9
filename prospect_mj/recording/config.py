"""What a recording is of."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal, Self, get_args

from prospect_mj.checks import check_choice, check_integer, check_names
from prospect_mj.recording.worlds import STANDARD, WORLDS

# As `task` has them, without its imports of the physics: a recording is stepped where
# there is no OpenGL.
ObjectPose = Literal["vision", "truth"]
GrossMotion = Literal["harmonic", "cartesian"]

LARGEST_SEED = 2**63 - 1
MOST_CELLS = 100_000


@dataclass(frozen=True)
class RecordingConfig:
    """Everything that decides which outcomes a recording holds."""

    seed: int = 0
    """Of the presentations: jar's place, lamp's brightness and the cameras' noise."""
    object_pose: ObjectPose = "vision"
    """Where the controllers get the jar's pose from; truth is an ablation."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go; cartesian is an ablation."""
    grid_cells: int = 16
    """Of harmonic movements: cells of the coarsest grid for each of its four joints."""
    world: str = STANDARD
    """What stands round the torso, and how well its eyes see: standard, post,
    lamp-right, lamp-high, noisy, ring-label, wide-lid or narrow-lid."""

    def __post_init__(self) -> None:
        """Refuse numbers and choices that make no recording."""
        check_choice("world", self.world, WORLDS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        check_integer("grid cells per joint", self.grid_cells, 2, MOST_CELLS)
        check_choice("object pose", self.object_pose, get_args(ObjectPose))
        check_choice("gross motion", self.gross_motion, get_args(GrossMotion))

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> Self:
        """Build a configuration from what `dataclasses.asdict` returned.

        Raises:
            ProspectError: if a setting is missing, unknown or out of range.
        """
        check_names(plain, cls)
        return cls(**plain)

    def differences(self, other: "RecordingConfig") -> list[str]:
        """What is not the same in both and decides outcomes, in words.

        Args:
            other: what this one, of a recording, is held against.

        Returns:
            Such as `gross motion harmonic, not cartesian`.
        """
        mine, theirs = asdict(self), asdict(other)
        if self.gross_motion == other.gross_motion == "cartesian":
            # Straight movements need no grid.
            del mine["grid_cells"]
        return [
            f"{name.replace('_', ' ')} {had}, not {theirs[name]}"
            for name, had in mine.items()
            if had != theirs[name]
        ]


@dataclass(frozen=True)
class Extent:
    """How large a recording is to be."""

    presentations: int = 50
    """Of each orientation."""
    depth: int = 10
    """Executed actions up to which the tree of each is complete."""

    def __post_init__(self) -> None:
        """Refuse sizes that make no recording."""
        check_integer("presentations", self.presentations, 1, 100_000)
        check_integer("depth", self.depth, 1, 40)
