"""Compose the scene with PyMJCF: the torso as root, everything else attached by name.

The torso must be the root: attached to something else its keyframe would silently
write into the jar's pose. PyMJCF only writes XML here; MuJoCo compiles and runs it.
"""

from dataclasses import dataclass, field

import mujoco
import numpy as np
from dm_control import mjcf
from lxml.etree import XMLSyntaxError

from prospect_mj import paths
from prospect_mj.errors import InvalidModel, InvalidValue
from prospect_mj.sim import fixtures
from prospect_mj.sim.props import Jar, Props

JAR, WELL, PEDESTAL, LAMP, TABLE = "jar", "well", "pedestal", "lamp", "table"
OBSTACLE = "obstacle"


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
    """The physics model: torso, table, pedestal, well, lamp, obstacle and jar.

    Raises:
        MissingFile: if a model or asset file is missing.
    """
    props = settings.props
    root = _torso()
    _options(root, settings)
    _attach_fixtures(root, props)
    jar = root.attach(_jar(props.jar, settings.physics))
    jar.set_attributes(pos=props.pedestal.nominal, quat=_lying())
    jar.add("freejoint")
    home = root.find("key", "home")
    home.qpos = np.concatenate([home.qpos, props.pedestal.nominal, _lying()])
    return _compiled(root)


def _attach_fixtures(root: mjcf.RootElement, props: Props) -> None:
    table, well, lamp = _model(TABLE), _model(WELL), _model(LAMP)
    fixtures.build_table(table, props.table)
    fixtures.build_well(well, props.well)
    fixtures.build_lamp(lamp, props.lamp)
    for model in (table, lamp):
        root.attach(model)
    root.attach(well).pos = [*props.well.position, 0.0]
    pedestal = _model(PEDESTAL)
    fixtures.build_pedestal(pedestal, props.pedestal, props.jar)
    frame = root.attach(pedestal)
    frame.set_attributes(mocap=True, pos=props.pedestal.nominal)
    if props.obstacle is not None:
        obstacle = _model(OBSTACLE)
        fixtures.build_obstacle(obstacle, props.obstacle)
        place = [*props.obstacle.position, 0.0]
        root.attach(obstacle).set_attributes(mocap=True, pos=place)


def obstacle_mocap(model: mujoco.MjModel) -> int:
    """Row of the obstacle among a model's mocap bodies.

    Raises:
        InvalidValue: if the scene was composed without one.
    """
    body = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_BODY, f"{OBSTACLE}/")
    if body < 0:
        raise InvalidValue("Props.obstacle", None, "an Obstacle, to be placed")
    return int(model.body_mocapid[body])


def _lying() -> np.ndarray:
    """Quaternion (4,) wxyz of a jar whose lid points left."""
    return np.array([np.cos(np.pi / 4), -np.sin(np.pi / 4), 0.0, 0.0])


def _torso() -> mjcf.RootElement:
    path = paths.torso_xml()
    try:
        return mjcf.from_path(str(path))
    # The parser answers bad XML with lxml's error, and bad MJCF with any of these.
    except (XMLSyntaxError, ValueError, KeyError, AttributeError) as error:
        raise InvalidModel(f"{path.name} can't be read: {error}") from error


def _compiled(root: mjcf.RootElement) -> mujoco.MjModel:
    try:
        return mujoco.MjModel.from_xml_string(root.to_xml_string(), root.get_assets())
    except ValueError as error:
        raise InvalidModel(f"the scene can't be compiled: {error}") from error


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
    # For people: the eyes look down and never see it.
    root.asset.add(
        "texture",
        name="sky",
        type="skybox",
        builtin="gradient",
        rgb1=[0.75, 0.80, 0.86],
        rgb2=[0.35, 0.40, 0.46],
        width=64,
        height=384,
    )


def _model(name: str) -> mjcf.RootElement:
    root = mjcf.RootElement(model=name)
    root.compiler.angle = "radian"
    return root


def _jar(jar: Jar, physics: PhysicsSettings) -> mjcf.RootElement:
    """The camera sees the mesh; two cylinders collide and carry the mass."""
    root = _model(JAR)
    mesh, texture = _look(jar)
    root.asset.add("mesh", name="jar", file=mesh)
    root.asset.add("texture", name="jar", type="2d", file=texture)
    root.asset.add("material", name="jar", texture="jar", specular=0, shininess=0)
    seen = {"contype": 0, "conaffinity": 0, "mass": 0, "group": 1}
    root.worldbody.add(
        "geom", name="visual", type="mesh", mesh="jar", material="jar", **seen
    )
    surface = {"friction": jar.friction, "condim": 4, "priority": 1}
    surface |= {"solref": physics.solref, "solimp": physics.solimp, "group": 3}
    fixtures.build_jar(root, jar, surface)
    return root


def _look(jar: Jar) -> tuple[str | mjcf.Asset, str | mjcf.Asset]:
    """Mesh and texture: files for the default jar, made here for any other."""
    if jar == Jar():
        return str(paths.jar_obj()), str(paths.jar_png())
    # trimesh takes longer to load than all else here, and most scenes need none of it.
    from prospect_mj.sim import jar_files

    mesh = mjcf.Asset(jar_files.obj(jar), ".obj")
    return mesh, mjcf.Asset(jar_files.png(jar), ".png")


def compile_twin(settings: SceneSettings, fingers: tuple[float, ...]) -> mujoco.MjModel:
    """The kinematic twin for inverse kinematics: 14 arm joints and no jar.

    Args:
        settings: the same as for the scene.
        fingers: proximal angle at which each finger is welded [rad].
    """
    props = settings.props
    root = _torso()
    for section in (root.keyframe, root.actuator, root.sensor):
        for element in list(section.all_children()):
            element.remove()
    for joint in root.find_all("joint"):
        if "finger" in joint.name:
            _weld(joint, fingers[int(joint.name.split("finger")[1][0]) - 1])
    _attach_fixtures(root, props)
    return _compiled(root)


def _weld(joint: mjcf.Element, proximal: float) -> None:
    """Turn a finger joint's body to where the joint would be, and drop the joint."""
    angle = proximal if "proximal" in joint.name else proximal / 3
    turned, turn = np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, np.array(joint.axis), angle)
    mujoco.mju_mulQuat(turned, np.array(joint.parent.quat), turn)
    joint.parent.quat = turned
    joint.remove()
