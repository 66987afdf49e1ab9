"""How the jar is presented: the reset distribution of a trial."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.sim.placement import JarPlacement

Orientation = Literal["left", "right"]
"""The side on which the lid lies."""
ORIENTATIONS: tuple[Orientation, ...] = get_args(Orientation)


@dataclass(frozen=True)
class PresentationSettings:
    """Half widths of the uniform distributions round the nominal presentation."""

    across: float = 0.02
    """Of the position in x and in y [m]."""
    height: float = 0.01
    """Of the position in z [m]."""
    yaw: float = np.deg2rad(10.0)
    """Of the turn about the vertical [rad]."""
    lamp: float = 0.10
    """Of the lamp's brightness, relative."""

    def __post_init__(self) -> None:
        """Refuse what would put the jar off the cradle's reach or the lamp out."""
        for name, most in (("across", 0.03), ("height", 0.02), ("yaw", 0.35)):
            if not 0 <= getattr(self, name) <= most:
                raise InvalidValue(name, getattr(self, name), f"0 to {most}")
        if not 0 <= self.lamp < 1:
            raise InvalidValue("lamp", self.lamp, "at least 0 and below 1")


@dataclass(frozen=True)
class Presentation:
    """One presentation of the jar."""

    orientation: Orientation
    placement: JarPlacement
    lamp_gain: float
    """Brightness of the lamp relative to its nominal."""


def checked_orientation(orientation: object) -> Orientation:
    """Return `orientation`, or raise `InvalidChoice` if it is none."""
    for valid in ORIENTATIONS:
        if orientation == valid:
            return valid
    raise InvalidChoice("orientation", orientation, ORIENTATIONS)


def draw_presentation(
    settings: PresentationSettings,
    nominal: np.ndarray,
    orientation: Orientation,
    rng: np.random.Generator,
) -> Presentation:
    """Draw a presentation of given orientation.

    Args:
        settings: the distribution.
        nominal: centre of the jar (3,) [m].
        orientation: the side on which the lid lies.
        rng: source of chance.
    """
    spread = np.array([settings.across, settings.across, settings.height])
    offset = rng.uniform(-spread, spread)
    yaw = rng.uniform(-settings.yaw, settings.yaw)
    gain = 1.0 + rng.uniform(-settings.lamp, settings.lamp)
    placement = JarPlacement(nominal + offset, yaw, orientation == "left")
    return Presentation(orientation, placement, gain)
