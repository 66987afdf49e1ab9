"""Whether the jar is in the receptacle: a referee's view that no controller sees."""

import numpy as np

from prospect_mj.sim.simulation import Simulation

UPRIGHT = np.cos(np.deg2rad(10.0))
"""Least vertical component of the axis of a jar that stands in the receptacle."""
FLOOR_GAP = 0.01
"""Most that its lower end may be above the floor of the receptacle [m]."""


def is_inserted(simulation: Simulation) -> bool:
    """Whether the jar stands upright on the receptacle's floor, on either end.

    Walls, rim and post alone decide which end gets there.
    """
    props = simulation.settings.props
    centre, axis = simulation.jar_position, simulation.jar_axis
    up = axis if axis[2] > 0 else -axis
    bottom = centre - props.jar.length / 2 * up
    aside = np.abs(bottom[:2] - props.well.position).max()
    within = aside < props.well.half_width - props.jar.body_radius / 2
    standing = bottom[2] < props.well.floor_height + FLOOR_GAP
    return bool(within and standing and up[2] > UPRIGHT)
