"""An episode as a Rerun recording: static things once, all that changes in columns."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import rerun as rr

from prospect_mj.episodes.episode import Episode
from prospect_mj.replay import rerun_scene, rerun_signals, rerun_story
from prospect_mj.replay.blueprint import blueprint
from prospect_mj.replay.playback import model_of, play
from prospect_mj.sim import overview

APPLICATION = "prospect_mj"
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


def export(episode: Episode, story: Story, path: Path) -> None:
    """Write an episode as an .rrd file, which Rerun's viewer opens.

    Args:
        episode: what happened.
        story: what else is known of it.
        path: the file; replaced if it is there.

    Raises:
        EpisodeError: if it can't be played back.
    """
    stream = rr.RecordingStream(APPLICATION, recording_id=story.title)
    # Wall-clock times would differ between two exports of the same.
    stream.set_log_time_enabled(False)
    stream.set_log_tick_enabled(False)
    stream.save(path, default_blueprint=blueprint(bool(story.decisions)))
    log(episode, story, stream)
    stream.flush()
    stream.disconnect()


def log(episode: Episode, story: Story, stream: rr.RecordingStream) -> None:
    """Log an episode to a stream."""
    model = model_of(episode)
    frames = play(episode, model)
    # The eyes' world is dark; people see its colours by daylight.
    overview.light_for_people(model, _UNUSED)
    stream.send_recording_name(story.title)
    rerun_scene.log_scene(stream, model)
    rerun_scene.log_motion(stream, model, frames)
    rerun_scene.log_contacts(stream, frames)
    rerun_scene.log_paths(stream, model, episode)
    rerun_signals.log_forces(stream, frames)
    rerun_signals.log_measured(stream, episode)
    rerun_story.log_look(stream, model, episode)
    rerun_story.log_actions(stream, episode)
    if story.decisions:
        values = np.array([decision.q_values for decision in story.decisions])
        rerun_signals.log_q_values(stream, episode, values)
