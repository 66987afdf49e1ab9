"""The task behind the environment: on live physics, or on what was recorded of it."""

from dataclasses import replace
from pathlib import Path
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionOutcome
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.errors import RecordingError
from prospect_mj.recording import files, shipped
from prospect_mj.recording import key as keys
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.felt import check_felt
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.task import RecordedTask
from prospect_mj.robot.names import Side
from prospect_mj.sim import gl
from prospect_mj.supervisor.predicates import PredicateState
from prospect_mj.supervisor.supervisor import Supervisor
from prospect_mj.task.presentation import Orientation


class LookLike(Protocol):
    """What the environment needs of a look."""

    @property
    def status(self) -> str:
        """`found`, `unsure` or `not_found`."""
        ...

    @property
    def histogram(self) -> NDArray[np.int64]:
        """(100,) [pixels]."""
        ...


class Task(Protocol):
    """What the environment needs of a task; see `task.pick_place.PickPlaceTask`."""

    supervisor: Supervisor

    @property
    def predicates(self) -> PredicateState:
        """As they were last observed."""
        ...

    @property
    def holder(self) -> Side | None:
        """The hand whose grasp predicate is on."""
        ...

    @property
    def inserted(self) -> bool:
        """Whether the jar stands in the receptacle and no hand holds it."""
        ...

    def reset(self, orientation: Orientation, rng: np.random.Generator) -> LookLike:
        """Present the jar and look at it once."""
        ...

    def execute(self, action: Action) -> ActionOutcome:
        """Run an action to its end, if it may run."""
        ...

    def close(self) -> None:
        """Give back what is held."""
        ...


def make_task(settings: PickPlaceSettings) -> Task:
    """Make the task that an environment asks for.

    Raises:
        RenderingUnavailable: if something is to be simulated without OpenGL.
        RecordingError: if the recording can't be had, or is of other physics.
        MissingFile: if a model or asset file is missing.
    """
    if settings.physics == "live":
        return _live(settings)
    return _growing(settings) if settings.grow else _recorded(settings)


def load_recording(settings: PickPlaceSettings) -> Recording:
    """Read the recording that an environment asks for.

    Raises:
        RecordingError: if it can't be had, is of other physics, or has no grasps for
            the haptic models.
    """
    path = settings.recording
    path = shipped.folder(settings.world) if path is None else path
    recording = Recording.load(path)
    _check_same(path, recording.key.config, settings)
    if settings.haptic_models is not None:
        check_felt(recording)
    recording.warn_if_foreign()
    return recording


def _recorded(settings: PickPlaceSettings) -> Task:
    recording = load_recording(settings)
    return RecordedTask(recording, make_supervisor(settings), settings.max_actions)


def _live(settings: PickPlaceSettings) -> Task:
    # Before the imports: MuJoCo's and dm_control's would fail, each in its own words.
    gl.require_gl()
    from prospect_mj.recording.grower import task_settings
    from prospect_mj.task.pick_place import PickPlaceTask

    return PickPlaceTask(
        replace(
            task_settings(settings.recorded_as),
            supervisor=settings.supervisor,
            shaping=settings.shaping,
            presentation=settings.presentation,
        )
    )


def _growing(settings: PickPlaceSettings) -> Task:
    path = settings.recording
    gl.require_gl()
    from prospect_mj.recording.grower import task_settings
    from prospect_mj.recording.growing import GrowingRecording
    from prospect_mj.recording.lazy_task import LazyTask

    config = settings.recorded_as
    files.check_folder(path)
    if (path / keys.NAME).exists():
        stored = RecordingKey.read(path).config
        _check_same(path, stored, settings)
        config = stored
    # What can't be simulated must not be written down as a recording's settings.
    task_settings(config)
    key = RecordingKey.present(config, gl.renderer_name())
    return LazyTask(GrowingRecording.open(path, key), make_supervisor(settings))


def make_supervisor(settings: PickPlaceSettings) -> Supervisor:
    """The supervisor that decides what an environment's agent may choose from."""
    return Supervisor(settings.supervisor, settings.shaping)


def _check_same(
    path: Path, stored: RecordingConfig, settings: PickPlaceSettings
) -> None:
    """Refuse a recording that was made in another way; which seed does not matter."""
    changed = stored.differences(replace(settings.recorded_as, seed=stored.seed))
    if changed:
        raise RecordingError(f"{path} was recorded with {'; '.join(changed)}")
