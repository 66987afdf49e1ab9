"""Where a jar sits in the hand that holds it: from touch, not from truth.

The contact normals of a cylinder are perpendicular to its axis and meet on it, so three
fingertips tell the axis; only the place along it, which they cannot feel, is carried
over from what was known before.
"""

import mink
import numpy as np

from prospect_mj.actions.poses import pose, turned_to
from prospect_mj.control.contact_residual import meeting_point
from prospect_mj.robot.torso import Touch


def felt_jar(touch: Touch, known: mink.SE3) -> mink.SE3:
    """Pose of a held cylinder in the world.

    Args:
        touch: of the hand that holds it, all three fingertips in contact.
        known: its pose by earlier knowledge; gives the sense of the axis, the turn
            about it and the place along it.
    """
    before = known.rotation().as_matrix()[:, 2]
    axis = np.linalg.svd(touch.normal)[2][2]
    axis = axis if axis @ before > 0 else -axis
    on_axis = meeting_point(touch.position, touch.normal)
    along = (known.translation() - on_axis) @ axis
    return pose(turned_to(known.rotation(), axis), on_axis + along * axis)
