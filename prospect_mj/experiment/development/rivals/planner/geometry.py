"""What the planner asks of geometry: which end fits, and which hand reaches where.

The sizes are those that the robot believes; `SizeError` makes them slightly wrong.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import mink
import numpy as np

from prospect_mj.actions import poses
from prospect_mj.actions.workspace import workspace
from prospect_mj.checks import check_number
from prospect_mj.experiment.development.rivals.planner.facts import End
from prospect_mj.planning.goals import NATURAL
from prospect_mj.robot import wam_ik
from prospect_mj.robot.names import Side
from prospect_mj.sim.props import Props

_LEFT = np.array([0.0, 1.0, 0.0])
_ROUNDING = 1e-9
"""Sizes that are equal but for this fit [m]."""
_MOST = 0.03


@dataclass(frozen=True)
class SizeError:
    """By how much what the robot believes is larger than what is there."""

    half_width: float = 0.0
    """Of the receptacle [m]."""
    lid_radius: float = 0.0
    """[m]"""

    def __post_init__(self) -> None:
        """Refuse what would leave no receptacle or no jar."""
        for name, value in vars(self).items():
            check_number(f"error of {name}", value, -_MOST, _MOST)


@dataclass
class Geometry:
    """Answers, and counts, the planner's questions; each is computed once.

    It knows the cradle's nominal place and not where the jar lies in this trial.
    """

    error: SizeError = field(default_factory=SizeError)
    props: Props = field(default_factory=Props)
    queries: int = 0
    """Questions that were computed."""
    known: dict[tuple[str, str], bool] = field(default_factory=dict)
    """Their answers."""

    def fits(self, end: End) -> bool:
        """Whether an end goes into the receptacle."""
        return self._asked("fits", end, lambda: self._fits(end))

    def reaches_cradle(self, side: Side) -> bool:
        """Whether a hand can take the lying jar by the end on its side."""
        place = self.props.pedestal.nominal
        return self._asked("cradle", side, lambda: self._reaches(side, place))

    def reaches_hand(self, side: Side) -> bool:
        """Whether a hand can take the jar out of the other hand."""
        place = workspace(self.props).presentation
        return self._asked("hand", side, lambda: self._reaches(side, place))

    def _asked(self, about: str, of: str, answer: Callable[[], bool]) -> bool:
        if (about, of) not in self.known:
            self.queries += 1
            self.known[about, of] = answer()
        return self.known[about, of]

    def _fits(self, end: End) -> bool:
        jar, error = self.props.jar, self.error
        radius = jar.body_radius if end == "body" else jar.lid_radius + error.lid_radius
        half_width = self.props.well.half_width + error.half_width
        return radius <= half_width + _ROUNDING

    def _reaches(self, side: Side, place: np.ndarray) -> bool:
        """Whether an arm has joint angles for a grasp of a jar along y."""
        reach = workspace(self.props).reach
        point, palm = poses.end_of_jar(side, place, _LEFT, reach)
        turn = poses.turned_to(mink.SO3.identity(), palm).as_matrix()
        swivels = np.linspace(-np.pi, np.pi, NATURAL.swivels, endpoint=False)
        rolls = np.linspace(-np.pi, np.pi, NATURAL.rolls, endpoint=False)
        found = wam_ik.solutions_free_roll(
            side, point, turn, swivels, rolls, NATURAL.limit_margin
        )
        return len(found) > 0
