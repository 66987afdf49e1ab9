"""Compose the scene with PyMJCF: the torso as root, everything else attached by name.

The torso must be the root: attached to something else its keyframe would silently
write into the jar's pose. PyMJCF only writes XML here; MuJoCo compiles and runs it.
"""

from dataclasses import dataclass, field

import mujoco
import numpy as np
from dm_control import mjcf

from prospect_mj import paths
from prospect_mj.sim.props import Jar, Lamp, Pedestal, Props, Table, Well

JAR, WELL, PEDESTAL, LAMP, TABLE = "jar", "well", "pedestal", "lamp", "table"
SLOPE = np.pi / 4
"""Of the cradle's plates and of the well's chamfer [rad]."""


@dataclass(frozen=True)
class PhysicsSettings:
    """MuJoCo's options; a grasp held for 2 s creeps 0.02 mm under them."""

    timestep: float = 0.0025
    """[s]"""
    integrator: str = "implicitfast"
    cone: str = "elliptic"
    """Pyramidal cones let a held jar drift by millimetres."""
    impratio: float = 10.0
    """Stiffness of friction relative to normal constraints."""
    noslip_iterations: int = 3
    iterations: int = 30
    """Of the Newton solver."""
    solref: tuple[float, float] = (0.005, 1.0)
    """Contact time constant [s] and damping ratio of what touches the jar."""
    solimp: tuple[float, float, float] = (0.95, 0.99, 0.001)


@dataclass(frozen=True)
class SceneSettings:
    """What to compose."""

    props: Props = field(default_factory=Props)
    physics: PhysicsSettings = field(default_factory=PhysicsSettings)
    shadow_size: int = 512
    """Resolution of the lamp's shadow map [pixels]; 4096 costs ten times as much."""
    ambient: float = 0.15
    """Headlight that reaches every surface."""
    fill: float = 0.05
    """Headlight from the camera's direction."""
    slices: int = 16
    """Facets round a drawn cylinder; every one costs time in the shadow map, too."""


def compile_scene(settings: SceneSettings) -> mujoco.MjModel:
    """The physics model: torso, table, pedestal, well, lamp and jar.

    Raises:
        MissingFile: if a model or asset file is missing.
    """
    props = settings.props
    root = mjcf.from_path(str(paths.torso_xml()))
    _options(root, settings)
    root.attach(_table(props.table))
    root.attach(_well(props.well))
    root.attach(_lamp(props.lamp))
    pedestal = root.attach(_pedestal(props.pedestal, props.jar))
    pedestal.set_attributes(mocap=True, pos=props.pedestal.nominal)
    jar = root.attach(_jar(props.jar, settings.physics))
    jar.set_attributes(pos=props.pedestal.nominal, quat=_lying())
    jar.add("freejoint")
    home = root.find("key", "home")
    home.qpos = np.concatenate([home.qpos, props.pedestal.nominal, _lying()])
    return _compiled(root)


def _lying() -> np.ndarray:
    """Quaternion (4,) wxyz of a jar whose lid points left."""
    return np.array([np.cos(SLOPE), -np.sin(SLOPE), 0.0, 0.0])


def _compiled(root: mjcf.RootElement) -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(root.to_xml_string(), root.get_assets())


def _options(root: mjcf.RootElement, settings: SceneSettings) -> None:
    physics = settings.physics
    root.option.set_attributes(
        timestep=physics.timestep,
        integrator=physics.integrator,
        cone=physics.cone,
        impratio=physics.impratio,
        noslip_iterations=physics.noslip_iterations,
        iterations=physics.iterations,
    )
    root.visual.quality.set_attributes(
        shadowsize=settings.shadow_size,
        offsamples=0,
        numslices=settings.slices,
        numstacks=settings.slices // 2,
    )
    root.visual.headlight.set_attributes(
        ambient=[settings.ambient] * 3, diffuse=[settings.fill] * 3, specular=[0] * 3
    )
    # Far from the near plane nothing is lost; the default clips what eyes look past.
    root.visual.map.set_attributes(znear=0.05, zfar=10)


def _model(name: str) -> mjcf.RootElement:
    root = mjcf.RootElement(model=name)
    root.compiler.angle = "radian"
    return root


def _table(table: Table) -> mjcf.RootElement:
    root = _model(TABLE)
    rgba = [*table.colour, 1]
    root.worldbody.add(
        "geom",
        name="top",
        type="box",
        pos=[*table.centre, -0.02],
        size=[*table.half_size, 0.02],
        rgba=rgba,
    )
    root.worldbody.add(
        "geom",
        name="floor",
        type="plane",
        pos=[0, 0, -0.75],
        size=[4, 4, 0.1],
        rgba=rgba,
    )
    return root


def _plate(
    body: mjcf.Element, name: str, pos: np.ndarray, euler: np.ndarray, **geom: object
) -> None:
    quat = np.empty(4)
    mujoco.mju_euler2Quat(quat, euler, "XYZ")
    body.add("geom", name=name, type="box", pos=pos, quat=quat, **geom)


def _pedestal(pedestal: Pedestal, jar: Jar) -> mjcf.RootElement:
    """Frame at the centre of the jar that lies in it, plates along y."""
    root = _model(PEDESTAL)
    rgba = [0.10, 0.10, 0.11, 1]
    half_width, half_thickness = pedestal.plate
    valley = -jar.body_radius / np.sin(SLOPE)
    for name, side in (("near", -1), ("far", 1)):
        along = np.array([side * np.cos(SLOPE), 0, np.sin(SLOPE)])
        outward = np.array([side * np.sin(SLOPE), 0, -np.cos(SLOPE)])
        pos = [0, 0, valley] + half_width * along + half_thickness * outward
        size = [half_width, pedestal.half_length, half_thickness]
        _plate(
            root.worldbody,
            name,
            pos,
            np.array([0, -side * SLOPE, 0]),
            size=size,
            rgba=rgba,
        )
    root.worldbody.add(
        "geom",
        name="post",
        type="cylinder",
        fromto=[0, 0, valley - 2 * half_thickness, 0, 0, -pedestal.axis_height - 0.03],
        size=[pedestal.post_radius],
        rgba=rgba,
    )
    return root


def _well(well: Well) -> mjcf.RootElement:
    root = _model(WELL)
    surface = dict(
        friction=[well.friction, 0.005, 0.0001],
        priority=2,
        condim=4,
        rgba=[0.16, 0.34, 0.27, 1],
    )
    outer = well.half_width + 2 * well.wall
    body = root.worldbody.add("body", name="box", pos=[*well.position, 0])
    floor = [outer, outer, well.floor_height / 2]
    body.add(
        "geom", name="floor", type="box", pos=[0, 0, floor[2]], size=floor, **surface
    )
    for i, name in enumerate(("far", "left", "near", "right")):
        angle = i * np.pi / 2
        outward = np.array([np.cos(angle), np.sin(angle), 0])
        size = [well.wall, outer, well.rim_height / 2]
        pos = (well.half_width + well.wall) * outward + [0, 0, size[2]]
        _plate(body, f"wall_{name}", pos, np.array([0, 0, angle]), size=size, **surface)
        rise = np.cos(SLOPE) * outward + [0, 0, np.sin(SLOPE)]
        down = np.sin(SLOPE) * outward - [0, 0, np.cos(SLOPE)]
        rim = well.half_width * outward + [0, 0, well.rim_height]
        pos = rim + well.chamfer / 2 * rise + 0.002 * down
        size = [well.chamfer / 2, outer, 0.002]
        euler = np.array([0, -SLOPE, 0])
        _chamfer(body, f"chamfer_{name}", pos, angle, euler, size, surface)
    return root


def _chamfer(
    body: mjcf.Element,
    name: str,
    pos: np.ndarray,
    angle: float,
    euler: np.ndarray,
    size: list[float],
    surface: dict[str, object],
) -> None:
    turn, lean, quat = np.empty(4), np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, np.array([0, 0, 1.0]), angle)
    mujoco.mju_euler2Quat(lean, euler, "XYZ")
    mujoco.mju_mulQuat(quat, turn, lean)
    body.add("geom", name=name, type="box", pos=pos, quat=quat, size=size, **surface)


def _lamp(lamp: Lamp) -> mjcf.RootElement:
    """A shade open in front of the bulb, on a boom from a stand behind the table."""
    root = _model(LAMP)
    bulb = np.array(lamp.position)
    forward = np.array(lamp.aim) - bulb
    forward /= np.linalg.norm(forward)
    root.worldbody.add(
        "light",
        name="bulb",
        pos=bulb,
        dir=forward,
        cutoff=lamp.cutoff,
        exponent=0,
        attenuation=lamp.attenuation,
        diffuse=[lamp.diffuse] * 3,
        ambient=[0] * 3,
        specular=[0] * 3,
    )
    rgba = [0.75, 0.62, 0.25, 1]
    top = bulb - 0.06 * forward
    foot = np.array([*lamp.stand, 0.0])
    elbow = np.array([*lamp.stand, top[2] + 0.1])
    root.worldbody.add(
        "geom",
        name="shade",
        type="cylinder",
        size=[0.045],
        fromto=[*(bulb - 0.025 * forward), *top],
        rgba=rgba,
    )
    for name, start, end, radius in (
        ("stand", foot, elbow, 0.012),
        ("boom", elbow, top, 0.01),
    ):
        root.worldbody.add(
            "geom",
            name=name,
            type="capsule",
            fromto=[*start, *end],
            size=[radius],
            rgba=rgba,
        )
    root.worldbody.add(
        "geom",
        name="foot",
        type="cylinder",
        size=[0.08, 0.01],
        pos=foot + [0, 0, 0.01],
        rgba=rgba,
    )
    return root


def _jar(jar: Jar, physics: PhysicsSettings) -> mjcf.RootElement:
    """The camera sees the mesh; two cylinders collide and carry the mass."""
    root = _model(JAR)
    root.asset.add("mesh", name="jar", file=str(paths.jar_obj()))
    root.asset.add("texture", name="jar", type="2d", file=str(paths.jar_png()))
    root.asset.add("material", name="jar", texture="jar", specular=0, shininess=0)
    root.worldbody.add(
        "geom",
        name="visual",
        type="mesh",
        mesh="jar",
        material="jar",
        contype=0,
        conaffinity=0,
        mass=0,
        group=1,
    )
    surface = dict(
        type="cylinder",
        condim=4,
        priority=1,
        friction=jar.friction,
        solref=physics.solref,
        solimp=physics.solimp,
        group=3,
    )
    half = jar.length / 2
    for name, start, end, radius, share in (
        ("body", -half, half - jar.lid_length, jar.body_radius, 1 - jar.lid_share),
        ("lid", half - jar.lid_length, half, jar.lid_radius, jar.lid_share),
    ):
        root.worldbody.add(
            "geom",
            name=name,
            fromto=[0, 0, start, 0, 0, end],
            size=[radius],
            mass=share * jar.mass,
            **surface,
        )
    return root


def compile_twin(settings: SceneSettings, fingers: tuple[float, ...]) -> mujoco.MjModel:
    """The kinematic twin for inverse kinematics: 14 arm joints and no jar.

    Args:
        settings: the same as for the scene.
        fingers: proximal angle at which each finger is welded [rad].
    """
    props = settings.props
    root = mjcf.from_path(str(paths.torso_xml()))
    for section in (root.keyframe, root.actuator, root.sensor):
        for element in list(section.all_children()):
            element.remove()
    for joint in root.find_all("joint"):
        if "finger" in joint.name:
            _weld(joint, fingers[int(joint.name.split("finger")[1][0]) - 1])
    root.attach(_table(props.table))
    root.attach(_well(props.well))
    root.attach(_lamp(props.lamp))
    pedestal = root.attach(_pedestal(props.pedestal, props.jar))
    pedestal.set_attributes(mocap=True, pos=props.pedestal.nominal)
    return _compiled(root)


def _weld(joint: mjcf.Element, proximal: float) -> None:
    """Turn a finger joint's body to where the joint would be, and drop the joint."""
    angle = proximal if "proximal" in joint.name else proximal / 3
    turned, turn = np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, np.array(joint.axis), angle)
    mujoco.mju_mulQuat(turned, np.array(joint.parent.quat), turn)
    joint.parent.quat = turned
    joint.remove()
