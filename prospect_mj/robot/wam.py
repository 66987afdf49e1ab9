"""Published facts of the Barrett WAM 7-DoF arm, in SI units.

Sources: Barrett WAM user manual D1001 AH.00 p. 64-65 (Denavit-Hartenberg table,
joint limits) = libbarrett ``config/wam7w.conf`` (link masses); ``barrett_model``
``components.urdf.xacro`` (torque and velocity limits).
"""

from dataclasses import dataclass

N_JOINTS = 7

UPPER_ARM = 0.55
"""DH d3 [m]: shoulder centre to elbow, along the upper arm."""

ELBOW_OFFSET = 0.045
"""DH a3 = -a4 [m]: the elbow axis stands this far beside the arm's midline."""

FOREARM = 0.30
"""DH d5 [m]: elbow to wrist centre, along the forearm."""

WRIST_TO_FLANGE = 0.06
"""DH d7 [m]: wrist centre to tool plate."""

JOINT_AXES = ("z", "y", "z", "y", "z", "y", "z")
"""Axis of each joint in its own link's frame, all links aligned at zero."""

LINK_ORIGINS = (
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0),
    (ELBOW_OFFSET, 0.0, UPPER_ARM),
    (-ELBOW_OFFSET, 0.0, 0.0),
    (0.0, 0.0, FOREARM),
    (0.0, 0.0, 0.0),
)
"""Origin of each link's frame in its parent's [m]: the DH table at zero angles."""

LINK_MASSES = (10.77, 3.87, 1.80, 2.17, 0.357, 0.409, 0.075)
"""[kg]"""

JOINT_LIMITS = (
    (-2.6, 2.6),
    (-2.0, 2.0),
    (-2.8, 2.8),
    (-0.9, 3.1),
    (-4.76, 1.24),
    (-1.6, 1.6),
    (-3.0, 3.0),
)
"""[rad], of the left arm; the right arm is its mirror image."""

TORQUE_LIMITS = (60.0, 60.0, 45.0, 30.0, 10.0, 10.0, 10.0)
"""[N m]"""

VELOCITY_LIMIT = 2.0
"""[rad/s], every joint."""

MIRROR = (-1, 1, -1, 1, -1, 1, -1)
"""Sign of each joint angle under reflection in the torso's sagittal plane."""


@dataclass(frozen=True)
class ServoGains:
    """Joint position servo and passive terms; ours, not published.

    They are stable at a 4 ms timestep and leave 0.2 mm of steady error at the palm.
    """

    stiffness: tuple[float, ...] = (900, 900, 600, 400, 80, 80, 30)
    """[N m / rad]"""
    damping: tuple[float, ...] = (108, 108, 60, 40, 4.8, 4.8, 1.5)
    """[N m s / rad], applied to the joint velocity."""
    armature: tuple[float, ...] = (0.3, 0.3, 0.2, 0.15, 0.02, 0.02, 0.01)
    """Reflected rotor inertia [kg m^2]."""
    friction_damping: tuple[float, ...] = (2.0, 2.0, 1.5, 1.0, 0.3, 0.3, 0.1)
    """Passive viscous damping [N m s / rad]."""


SERVO = ServoGains()
