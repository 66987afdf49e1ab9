"""An episode as a Rerun recording: static things once, all that changes in columns."""

import hashlib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy as np
import rerun as rr
import rerun.blueprint as rrb

from prospect_mj.episodes.episode import Episode
from prospect_mj.replay import rerun_scene, rerun_story
from prospect_mj.replay.blueprint import blueprint
from prospect_mj.replay.panels import panels
from prospect_mj.replay.playback import Frames, model_of, play
from prospect_mj.replay.rerun_signals import log_panels
from prospect_mj.sim import overview
from prospect_mj.storage import replace_file

APPLICATION = "prospect_mj"
_NEVER = 1e5
"""Chunks are closed by their size, not by a clock [s]."""
_UNUSED = (64, 64)
"""Size of pictures, of which none is rendered here [pixels]."""


@dataclass(frozen=True, eq=False)
class Decision:
    """Why the learner chose an action."""

    q_values: np.ndarray
    """(6,) [actions]."""
    explored: bool
    """Whether the choice was a random one."""


@dataclass(frozen=True)
class Story:
    """What the states don't tell of an episode."""

    title: str
    """Such as run and trial."""
    decisions: Sequence[Decision] = ()
    """One for each action, or none at all."""

    @property
    def q_values(self) -> np.ndarray | None:
        """(a, 6) [actions], or None if nobody has learned."""
        if not self.decisions:
            return None
        return np.array([decision.q_values for decision in self.decisions])


def export(episode: Episode, story: Story, path: Path) -> None:
    """Write an episode as an .rrd file, which Rerun's viewer opens.

    Args:
        episode: what happened.
        story: what else is known of it.
        path: the file; it is there as a whole or not at all, and replaced if it was.

    Raises:
        EpisodeError: if it can't be played back.
        OSError: if the file can't be written.
    """
    model = model_of(episode)
    frames = play(episode, model)
    shown = panels(episode, frames, story.q_values)
    # Else it would show in the file how fast this machine is at the moment.
    stream = rr.RecordingStream(
        APPLICATION,
        recording_id=_identity(episode, story),
        batcher_config=rr.ChunkBatcherConfig(flush_tick=_NEVER),
    )
    # Wall-clock times would differ between two exports of the same.
    stream.set_log_time_enabled(False)
    stream.set_log_tick_enabled(False)
    layout = blueprint(story.title, shown, float(frames.times[-1]))
    with _in_memory(stream, layout) as written:
        stream.send_recording_name(story.title)
        _log_scene(stream, model, frames, episode)
        log_panels(stream, shown)
        _log_story(stream, episode, story)
        content = written.drain_as_bytes()
    replace_file(path, content)


@contextmanager
def _in_memory(
    stream: rr.RecordingStream, layout: rrb.Blueprint
) -> Iterator[rr.MemoryRecording]:
    """What is logged; the stream's own writer waits for ever where a disk is full."""
    try:
        written = stream.memory_recording()
        stream.send_blueprint(layout, make_active=False)
        yield written
    finally:
        stream.disconnect()


def _log_scene(
    stream: rr.RecordingStream, model: mujoco.MjModel, frames: Frames, episode: Episode
) -> None:
    # The eyes' world is dark; people see its colours by daylight.
    overview.light_for_people(model, _UNUSED)
    rerun_scene.log_scene(stream, model)
    rerun_scene.log_motion(stream, model, frames)
    rerun_scene.log_contacts(stream, frames)
    rerun_scene.log_paths(stream, model, episode)


def _log_story(stream: rr.RecordingStream, episode: Episode, story: Story) -> None:
    rerun_story.log_look(stream, episode)
    rerun_story.log_lanes(stream, episode)
    explored = [decision.explored for decision in story.decisions]
    rerun_story.log_words(stream, episode, explored)


def _identity(episode: Episode, story: Story) -> str:
    """Two recordings of one identity become one in the viewer."""
    digest = hashlib.sha256(story.title.encode())
    digest.update(np.ascontiguousarray(episode.states.rows).tobytes())
    return digest.hexdigest()[:32]
