"""What follows from an episode's states: poses, contacts and what the sensors read.

A state and MuJoCo's forward pass give all of it again, so that none of it is stored.
"""

from dataclasses import dataclass
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from prospect_mj.control.contact_residual import contact_residual
from prospect_mj.episodes.episode import Episode, PlannedPath
from prospect_mj.episodes.states import STATE
from prospect_mj.errors import EpisodeError
from prospect_mj.robot import names
from prospect_mj.robot.names import SIDES
from prospect_mj.robot.torso import Torso, Touch
from prospect_mj.sim.scene import compile_scene


class Contacts(NamedTuple):
    """Where the jar is touched at one instant."""

    positions: NDArray[np.float64]
    """(c, 3) [m]."""
    forces: NDArray[np.float64]
    """(c, 3) [N], on the jar, in the world's frame."""


@dataclass(frozen=True, eq=False)
class Frames:
    """What n states look like."""

    times: NDArray[np.float64]
    """(n,) [s], from the beginning of the episode."""
    positions: NDArray[np.float64]
    """Of every body (n, b, 3) [m]."""
    quaternions: NDArray[np.float64]
    """Of every body (n, b, 4), w first."""
    wrist_forces: NDArray[np.float64]
    """(n, 2) [N], left and right."""
    touch_forces: NDArray[np.float64]
    """Normal force of every fingertip (n, 2, 3) [N]."""
    residuals: NDArray[np.float64]
    """eps of the contacts of each hand (n, 2) [1], NaN unless all three tips touch."""
    contacts: tuple[Contacts, ...]
    """Of the jar."""


def model_of(episode: Episode) -> mujoco.MjModel:
    """Compile the scene of an episode, with its lamp.

    Raises:
        EpisodeError: if its states are not those of the scene as it is today.
    """
    model = compile_scene(episode.scene)
    wanted, found = mujoco.mj_stateSize(model, STATE), episode.states.rows.shape[1]
    if wanted != found:
        raise EpisodeError(
            f"the episode's states have {found} numbers, those of the present model "
            f"{wanted}: it was recorded with another model"
        )
    model.light_diffuse[:] *= episode.presentation.lamp_gain
    return model


def play(episode: Episode, model: mujoco.MjModel) -> Frames:
    """Compute what the states look like.

    Args:
        episode: whose states.
        model: its scene.
    """
    data = mujoco.MjData(model)
    torso, jar = Torso(model, data), model.body("jar/").id
    poses, wrists, touches, residuals, contacts = [], [], [], [], []
    for row in episode.states.rows:
        mujoco.mj_setState(model, data, row, STATE)
        mujoco.mj_forward(model, data)
        reading = torso.read()
        poses.append((data.xpos.copy(), data.xquat.copy()))
        wrists.append([np.linalg.norm(reading[s].wrist_force) for s in SIDES])
        touches.append([reading[side].touch.force for side in SIDES])
        residuals.append([_residual(reading[side].touch) for side in SIDES])
        contacts.append(_contacts(model, data, jar))
    positions, quaternions = (np.array(part) for part in zip(*poses, strict=True))
    return Frames(
        episode.states.times - episode.states.times[0],
        positions,
        quaternions,
        np.array(wrists),
        np.array(touches),
        np.array(residuals),
        tuple(contacts),
    )


def hand_path(model: mujoco.MjModel, path: PlannedPath) -> NDArray[np.float64]:
    """Where the grasp site goes on a planned path, (n, 3) [m]."""
    data = mujoco.MjData(model)
    joints = [model.joint(name).qposadr[0] for name in names.arm_joints(path.side)]
    site = model.site(names.grasp_site(path.side)).id
    places = np.empty((len(path.joints), 3))
    for place, angles in zip(places, path.joints, strict=True):
        data.qpos[joints] = angles
        mujoco.mj_kinematics(model, data)
        place[:] = data.site_xpos[site]
    return places


def _residual(touch: Touch) -> float:
    """As the grasp controller measures it."""
    if not touch.found.all():
        return np.nan
    return contact_residual(touch.position, touch.normal).value


def _contacts(model: mujoco.MjModel, data: mujoco.MjData, jar: int) -> Contacts:
    positions, forces = [], []
    for number in range(data.ncon):
        contact = data.contact[number]
        bodies = model.geom_bodyid[contact.geom]
        if jar not in bodies:
            continue
        wrench = np.empty(6)
        mujoco.mj_contactForce(model, data, number, wrench)
        # It is what the second geom's body feels; the normal is the first axis.
        force = contact.frame.reshape(3, 3).T @ wrench[:3]
        positions.append(contact.pos.copy())
        forces.append(force if bodies[1] == jar else -force)
    shape = len(positions), 3
    return Contacts(np.reshape(positions, shape), np.reshape(forces, shape))
