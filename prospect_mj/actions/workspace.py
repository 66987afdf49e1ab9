"""Places and distances of the task that the actions share; known to the robot."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.control.weighing import GRAVITY
from prospect_mj.sim.props import Props


@dataclass(frozen=True)
class Workspace:
    """What the robot knows of the task beforehand: sizes and fixed places."""

    jar_length: float
    """[m]"""
    jar_radius: float
    """Of its wider end [m]."""
    jar_weight: float
    """[N]"""
    well: np.ndarray
    """Centre of the rim (3,) [m]."""
    well_depth: float
    """[m]"""
    wedge: float
    """Where the end that does not fit stops, above the rim [m]."""
    presentation: np.ndarray
    """Where a held jar is kept between actions, and swapped (3,) [m]."""
    grip_inset: float = 0.027
    """Grip plane from the jar's end [m]."""
    stand_off: float = 0.10
    """From which a hand approaches, and to which it backs out [m]."""
    lift: float = 0.05
    """Straight up out of the cradle [m]."""
    rim_clearance: float = 0.025
    """Between the rim and the jar's lower end before the descent [m]."""
    via_height: float = 0.12
    """Of the jar's lower end above the rim while it is turned upright [m]."""

    @property
    def reach(self) -> float:
        """Centre of the jar to the grip plane [m]."""
        return self.jar_length / 2 - self.grip_inset

    def over_well(self, height: float) -> np.ndarray:
        """Centre (3,) [m] of an upright jar, its lower end `height` above the rim."""
        return self.well + [0, 0, height + self.jar_length / 2]


PRESENTATION = (0.50, 0.0, 0.44)
"""In front of the chest, within reach of both hands [m]."""


def workspace(props: Props) -> Workspace:
    """The workspace of a scene."""
    return Workspace(
        jar_length=props.jar.length,
        jar_radius=props.jar.lid_radius,
        jar_weight=props.jar.mass * GRAVITY,
        well=np.array([*props.well.position, props.well.rim_height]),
        well_depth=props.well.depth,
        wedge=props.well.stop_height(props.jar.lid_radius),
        presentation=np.array(PRESENTATION),
    )
