"""Sizes and surfaces of what stands around the torso; plain numbers, no MuJoCo.

World frame: x forward, y left, z up, origin on the table top below the shoulders.
"""

from dataclasses import dataclass, field

import numpy as np


@dataclass(frozen=True)
class Recess:
    """A round hole in the top of a jar's lid, about its axis."""

    radius: float = 0.022
    """[m]"""
    depth: float = 0.037
    """From the top of the lid [m]."""


@dataclass(frozen=True)
class Jar:
    """A jar with a wide lid; frame at its centre, z along the axis to the lid."""

    length: float = 0.17
    """[m]"""
    body_radius: float = 0.036
    """[m]"""
    lid_radius: float = 0.045
    """[m]: wider than the well, narrower than an open hand."""
    lid_length: float = 0.040
    """[m]"""
    label: tuple[float, float] = (-0.060, 0.016)
    """From where to where on the axis the white label goes [m]."""
    recess: Recess | None = None
    """In the lid; None: it is flat."""
    mass: float = 0.40
    """[kg], three quarters in the body, one quarter in the lid."""
    lid_share: float = 0.25
    friction: tuple[float, float, float] = (1.0, 0.01, 0.0005)
    """Sliding, torsional [m], rolling [m]; the jar's surface decides (priority 1)."""

    @property
    def body_length(self) -> float:
        """The part that is not the lid [m]."""
        return self.length - self.lid_length


PRESENTATION = (0.62, 0.0, 0.20)
"""Nominal place of the centre of a presented jar [m]; eyes and lamp are aimed at it."""


@dataclass(frozen=True)
class Pedestal:
    """A V-shaped cradle of two 45-degree plates on a post."""

    position: tuple[float, float] = PRESENTATION[:2]
    """Nominal place on the table [m]."""
    axis_height: float = PRESENTATION[2]
    """Nominal height of the axis of a jar that lies in it [m]."""
    half_length: float = 0.014
    """Of the plates along the jar's axis [m]."""
    plate: tuple[float, float] = (0.025, 0.003)
    """Half width along the slope and half thickness of a plate [m]."""
    post_radius: float = 0.015
    """[m]"""

    @property
    def nominal(self) -> np.ndarray:
        """Centre (3,) [m] of a jar that lies in it at the nominal place."""
        return np.array([*self.position, self.axis_height])


@dataclass(frozen=True)
class Post:
    """A round post that stands in the middle of the receptacle's floor."""

    radius: float = 0.010
    """[m]"""
    height: float = 0.033
    """Above the floor [m]."""


@dataclass(frozen=True)
class Well:
    """The receptacle: an open square box with a 45-degree chamfer round its rim."""

    position: tuple[float, float] = (0.45, 0.0)
    """Centre on the table [m]."""
    half_width: float = 0.040
    """Inside [m]: 4 mm wider than the jar's body, 5 mm narrower than its lid."""
    rim_height: float = 0.10
    """Top of the straight walls above the table [m]."""
    depth: float = 0.08
    """Rim to floor [m]."""
    wall: float = 0.005
    """Half thickness [m]."""
    chamfer: float = 0.012
    """Width of the sloping plates [m]."""
    friction: float = 0.25
    """Sliding; smoother than the jar, and it decides (priority 2)."""
    post: Post | None = None
    """What only a recess goes over; None: nothing stands in the way."""

    def stop_height(self, widest: float) -> float:
        """Where the end that does not fit comes to rest, above the rim [m].

        Args:
            widest: radius of the jar's wider end [m].
        """
        if self.post is not None:
            return self.post.height - self.depth
        # The chamfer slopes at 45 degrees, so it is as high as the lid is wider, unless
        # that is wider still.
        return min(widest - self.half_width, self.chamfer * np.sin(np.pi / 4))

    @property
    def floor_height(self) -> float:
        """Of the inside, above the table [m]."""
        return self.rim_height - self.depth


@dataclass(frozen=True)
class Lamp:
    """A desk lamp to one side: inverse-square light is what makes the images differ."""

    position: tuple[float, float, float] = (0.50, 0.80, 1.20)
    """Of the bulb [m]: clear of what the left arm sweeps, and so high that the waiting
    left hand casts no shadow on the jar."""
    aim: tuple[float, float, float] = PRESENTATION
    """Where the shade points [m]: at the place where objects are presented."""
    cutoff: float = 45.0
    """Half angle of the cone that leaves the shade [degrees]."""
    diffuse: float = 1.0
    """Intensity, all three channels."""
    attenuation: tuple[float, float, float] = (0.0, 0.0, 0.8)
    """Constant, linear [1/m] and quadratic [1/m^2] coefficient: inverse square."""
    stand: tuple[float, float] = (1.00, 0.66)
    """Foot of the stand on the table [m]."""


@dataclass(frozen=True)
class Table:
    """Dark, so that the object is the bright thing in the fovea."""

    centre: tuple[float, float] = (0.66, 0.0)
    """[m]"""
    half_size: tuple[float, float] = (0.46, 0.75)
    """[m]"""
    colour: tuple[float, float, float] = (0.10, 0.10, 0.11)


@dataclass(frozen=True)
class Obstacle:
    """A tall post on the table that stands in the way; it can be moved."""

    position: tuple[float, float] = (1.07, -0.70)
    """Where it stands at reset, on the table [m]: in the far corner, out of reach."""
    radius: float = 0.04
    """[m]"""
    height: float = 0.60
    """[m]"""


@dataclass(frozen=True)
class Props:
    """Everything around the torso."""

    jar: Jar = field(default_factory=Jar)
    pedestal: Pedestal = field(default_factory=Pedestal)
    well: Well = field(default_factory=Well)
    lamp: Lamp = field(default_factory=Lamp)
    table: Table = field(default_factory=Table)
    obstacle: Obstacle | None = None
    """None: nothing stands in the way."""
