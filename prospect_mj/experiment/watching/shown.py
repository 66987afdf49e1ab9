"""What is shown to somebody who watches actions live."""

from dataclasses import dataclass

from prospect_mj.actions.action import Action
from prospect_mj.checks import check_choice, check_integer, check_number
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.recording.worlds import STANDARD, WORLDS
from prospect_mj.task.presentation import ORIENTATIONS, Orientation


@dataclass(frozen=True)
class Shown:
    """One presentation of the jar and what is done with it."""

    lid: Orientation
    """The side on which the lid lies."""
    actions: tuple[Action, ...]
    """To run one after the other, at least one."""
    seed: int = 0
    """Of the presentation."""
    speed: float = 1.0
    """Simulated seconds per second that a window shows."""
    world: str = STANDARD
    """What stands round the torso."""

    def __post_init__(self) -> None:
        """Refuse what can't be shown."""
        check_choice("lid", self.lid, ORIENTATIONS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        check_number("speed", self.speed, 0.01, 100.0)
        check_choice("world", self.world, WORLDS)
        if not self.actions:
            raise InvalidValue("actions", "", "one or more")
