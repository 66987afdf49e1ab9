"""The scene in Rerun: its shapes once, and how its bodies move."""

import mujoco
import numpy as np
import rerun as rr

from prospect_mj.episodes.episode import Episode
from prospect_mj.replay import colours, geometry
from prospect_mj.replay.playback import Frames, hand_path
from prospect_mj.replay.timeline import changes, column
from prospect_mj.robot.names import SIDES

ROOT = geometry.ROOT
CONTACTS, FORCES, PLAN = (
    f"{ROOT}/{name}" for name in ("contacts", "contact_forces", "plan")
)

_METRES_PER_NEWTON = 0.004


def log_scene(stream: rr.RecordingStream, model: mujoco.MjModel) -> None:
    """Log all shapes, which never change."""
    stream.log(ROOT, rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    for path, shape in geometry.shapes(model):
        stream.log(path, shape, static=True)


def log_motion(
    stream: rr.RecordingStream, model: mujoco.MjModel, frames: Frames
) -> None:
    """Log the poses of all bodies; those that stay where they are once."""
    times = column(frames.times)
    for body in range(1, model.nbody):
        path = geometry.entity(model, body)
        places = frames.positions[:, body]
        turns = np.roll(frames.quaternions[:, body], -1, axis=1)
        if np.ptp(places, axis=0).max() == np.ptp(turns, axis=0).max() == 0:
            pose = rr.Transform3D(translation=places[0], quaternion=turns[0])
            stream.log(path, pose, static=True)
            continue
        poses = rr.Transform3D.columns(translation=places, quaternion=turns)
        stream.send_columns(path, [times], poses)


def log_contacts(stream: rr.RecordingStream, frames: Frames) -> None:
    """Log where the jar is touched, and with which force."""
    times = column(frames.times)
    counts = [len(contact.positions) for contact in frames.contacts]
    places = np.concatenate([contact.positions for contact in frames.contacts])
    forces = np.concatenate([contact.forces for contact in frames.contacts])
    points = rr.Points3D.columns(positions=places, radii=np.full(len(places), 0.004))
    stream.send_columns(CONTACTS, [times], points.partition(counts))
    vectors = _METRES_PER_NEWTON * forces
    # An arrow is drawn from outside onto the contact.
    arrows = rr.Arrows3D.columns(vectors=vectors, origins=places - vectors)
    stream.send_columns(FORCES, [times], arrows.partition(counts))
    stream.log(CONTACTS, rr.Points3D.from_fields(colors=[colours.CONTACT]), static=True)
    red = rr.Arrows3D.from_fields(colors=[colours.CONTACT], radii=[0.002])
    stream.log(FORCES, red, static=True)


def log_paths(
    stream: rr.RecordingStream, model: mujoco.MjModel, episode: Episode
) -> None:
    """Log the ways that the hands are planned to go, as long as they are followed."""
    start = episode.states.times[0]
    for side in SIDES:
        paths = [p for span in episode.actions for p in span.paths if p.side == side]
        told = [*changes(paths)]
        if not told:
            continue
        times, shown = zip(*told, strict=True)
        lines = rr.LineStrips3D.columns(
            strips=[hand_path(model, paths[n]) for n in shown if n is not None]
        )
        # A row with no line ends what was shown before.
        rows = lines.partition([int(number is not None) for number in shown])
        at = column(np.array(times) - start)
        stream.send_columns(f"{PLAN}/{side}", [at], rows)
        look = rr.LineStrips3D.from_fields(colors=[colours.ARMS[side]], radii=[0.004])
        stream.log(f"{PLAN}/{side}", look, static=True)
