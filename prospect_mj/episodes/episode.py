"""A trial as it was simulated: the states it went through, and what ran meanwhile."""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import ActionOutcome, PlanOutcome
from prospect_mj.control.result import Measured, Status
from prospect_mj.robot.names import Side
from prospect_mj.sim.camera import StereoPair
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.task.presentation import Presentation

QUANTITIES = tuple(field.name for field in fields(Measured))
"""What controllers measure, in the order of `Signals.measured`."""


@dataclass(frozen=True)
class ControllerSpan:
    """One controller's part in an action."""

    name: str
    """Of its class."""
    side: Side
    start: float
    """[s]"""
    end: float
    """[s]"""
    status: Status
    reason: str


@dataclass(frozen=True, eq=False)
class PlannedPath:
    """A way through joint space that a controller followed for some time."""

    side: Side
    start: float
    """When it was planned [s]."""
    end: float
    """When it was followed for the last time [s]."""
    joints: NDArray[np.float32]
    """(n, 7) [rad]."""


@dataclass(frozen=True, eq=False)
class ActionSpan:
    """One action of the trial, run or refused, or a plan of one's own."""

    name: str
    """The action's label, such as `grasp-left`, or the plan's name."""
    outcome: ActionOutcome | PlanOutcome
    start: float
    """[s]"""
    end: float
    """[s]"""
    controllers: tuple[ControllerSpan, ...]
    paths: tuple[PlannedPath, ...]


@dataclass(frozen=True, eq=False)
class Signals:
    """What was measured in every control period, m of them."""

    times: NDArray[np.float64]
    """(m,) [s]."""
    measured: NDArray[np.float32]
    """(m, 2, 7): `QUANTITIES` of the left and of the right arm, NaN where there is
    none."""


@dataclass(frozen=True, eq=False)
class States:
    """Integration states of the simulation, n of them; see `Simulation.save`."""

    times: NDArray[np.float64]
    """(n,) [s]."""
    rows: NDArray[np.float64]
    """(n, k)."""


@dataclass(frozen=True, eq=False)
class LookTaken:
    """What the robot saw before it began."""

    images: StereoPair
    histogram: NDArray[np.int64]
    """(100,) [pixels]."""
    status: str
    """`found`, `unsure` or `not_found`."""
    position: NDArray[np.float64] | None
    """Of the jar (3,) [m], if it was found."""
    axis: NDArray[np.float64] | None
    """Of the jar (3,), pointing to the left."""


@dataclass(frozen=True, eq=False)
class Episode:
    """A trial from the look to the end of its last action."""

    scene: SceneSettings
    presentation: Presentation
    look: LookTaken
    states: States
    signals: Signals
    actions: tuple[ActionSpan, ...]
    inserted: bool
    """Whether the jar stood in the receptacle at the end."""

    @property
    def seconds(self) -> float:
        """Simulated time of all actions [s]."""
        return sum(span.outcome.sim_seconds for span in self.actions)
