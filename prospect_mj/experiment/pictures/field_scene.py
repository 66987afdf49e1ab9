"""The scene with one arm in several configurations at once."""

from collections.abc import Iterator

import mujoco
import numpy as np

from prospect_mj.experiment.pictures.field_slice import POST, SCENE, SIDE
from prospect_mj.planning.arm_body import geoms_of
from prospect_mj.robot import names, posture
from prospect_mj.sim import overview
from prospect_mj.sim.offscreen import OffscreenRenderer
from prospect_mj.sim.scene import compile_scene, obstacle_mocap

_OPACITY = 0.5
"""Of every configuration but the last."""
# In front, to the right of the lamp, so that it hides nothing.
_LOOK_AT, _DISTANCE, _AZIMUTH, _ELEVATION = (0.28, 0.17, 0.57), 1.95, 158.0, -17.0


def photograph(
    configurations: np.ndarray, tints: np.ndarray, size: tuple[int, int]
) -> np.ndarray:
    """Render the slice's scene.

    Args:
        configurations: of the arm, joint angles (n, 7) [rad]; the last one is opaque.
        tints: colour of each (n, 3), RGB from 0 to 1.
        size: rows and columns [pixels].

    Returns:
        Picture (rows, columns, 3) uint8 RGB.
    """
    model = compile_scene(SCENE)
    overview.light_for_people(model, size)
    dynamic = mujoco.mjtCatBit.mjCAT_DYNAMIC
    option, nothing = mujoco.MjvOption(), mujoco.MjvPerturb()
    with OffscreenRenderer(model, *size) as renderer:
        renderer.update_scene(_posed(model, configurations[-1]), _camera())
        scene = renderer.scene
        for geom in _of_arm(model, scene, 0):
            geom.rgba[:3] = tints[-1]
        for joints, tint in zip(configurations[:-1], tints, strict=False):
            first = scene.ngeom
            mujoco.mjv_addGeoms(
                model, _posed(model, joints), option, nothing, dynamic, scene
            )
            # What else moves is already there.
            for number in range(first, scene.ngeom):
                scene.geoms[number].rgba[3] = 0.0
            for geom in _of_arm(model, scene, first):
                geom.rgba[:] = *tint, _OPACITY
        return renderer.render()


def _posed(model: mujoco.MjModel, joints: np.ndarray) -> mujoco.MjData:
    """The arm at joint angles (7,) [rad], the other one in front."""
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key(names.HOME).id)
    poses = {SIDE: joints, names.other(SIDE): posture.presenting(names.other(SIDE))}
    for side, pose in poses.items():
        for joint, angle in zip(names.arm_joints(side), pose, strict=True):
            data.joint(joint).qpos = angle
    data.mocap_pos[obstacle_mocap(model), :2] = POST
    mujoco.mj_forward(model, data)
    return data


def _of_arm(
    model: mujoco.MjModel, scene: mujoco.MjvScene, first: int
) -> Iterator[mujoco.MjvGeom]:
    """Drawn geoms of the arm, from a number on."""
    own = set(geoms_of(model, SIDE))
    for number in range(first, scene.ngeom):
        geom = scene.geoms[number]
        if geom.objtype == mujoco.mjtObj.mjOBJ_GEOM and geom.objid in own:
            yield geom


def _camera() -> mujoco.MjvCamera:
    view = mujoco.MjvCamera()
    view.lookat[:] = _LOOK_AT
    view.distance, view.azimuth, view.elevation = _DISTANCE, _AZIMUTH, _ELEVATION
    return view
