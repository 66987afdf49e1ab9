"""Trials one after the other, on live physics or on recorded ones."""

from typing import TYPE_CHECKING, Any, NamedTuple, cast

import gymnasium
import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.agent.features import Holding
from prospect_mj.envs.observation import (
    FeatureObserver,
    ImageObserver,
    Observation,
    Observer,
)
from prospect_mj.envs.reset_options import ResetOptions
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.tasks import Task, make_task
from prospect_mj.envs.touch import Touch
from prospect_mj.errors import RecordingError
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

if TYPE_CHECKING:
    from prospect_mj.episodes.recorder import WatchedTask
    from prospect_mj.task.pick_place import PickPlaceTask

REWARD = -1.0
"""Of every action, so that the fewest actions are the best."""


class Transition(NamedTuple):
    """What an action led to."""

    observation: Observation
    reward: float
    terminated: bool
    """Whether the jar stands in the receptacle."""
    truncated: bool
    """Whether the trial was cut off."""
    info: dict[str, Any]


def drawn_orientation(rng: np.random.Generator) -> Orientation:
    """A side for the lid, each as likely as the other."""
    return ORIENTATIONS[int(rng.integers(len(ORIENTATIONS)))]


class Trials:
    """The task, how far its present trial is, and what is told of it.

    Args:
        settings: of the environment.

    Attributes:
        task: on live physics or on recorded ones.
        observer: makes the observations.
    """

    def __init__(self, settings: PickPlaceSettings) -> None:
        """Make the task.

        Raises:
            RenderingUnavailable: if something is to be simulated without OpenGL.
            RecordingError: if the recording can't be had, or is of other physics.
        """
        self.task: Task = make_task(settings)
        live = settings.physics == "live"
        self._live = cast("PickPlaceTask", self.task) if live else None
        self.observer = self._observer(settings)
        self._touch = Touch(settings.haptic_models)
        self._max_actions = settings.max_actions
        self._orientation: Orientation = ORIENTATIONS[0]
        self._trial = -1
        self._n_actions: int | None = None
        self._closed = False

    def _observer(self, settings: PickPlaceSettings) -> Observer:
        features = FeatureObserver(settings.features, settings.categories)
        if settings.observation == "features":
            return features
        return ImageObserver(features, self.live.camera.settings.size)

    @property
    def live(self) -> "PickPlaceTask":
        """The task on live physics.

        Raises:
            RecordingError: on recorded physics.
        """
        if self._live is None:
            raise RecordingError("recorded physics has no model and data")
        return self._live

    def watch(self) -> "WatchedTask":
        """Remember every trial from now on; see `PickPlaceEnv.watch`."""
        live = self.live
        # Where nothing is simulated, nothing of MuJoCo is loaded.
        from prospect_mj.episodes.recorder import WatchedTask

        if not isinstance(self.task, WatchedTask):
            self.task = WatchedTask(live)
        return self.task

    def begin(
        self, told: ResetOptions, rng: np.random.Generator
    ) -> tuple[Observation, dict[str, Any]]:
        """Present the jar and look at it.

        Args:
            told: what the agent wants of the trial.
            rng: draws the rest.
        """
        self.check_open()
        self._orientation = told.orientation or drawn_orientation(rng)
        self._trial = self._trial + 1 if told.trial is None else told.trial
        look = self.task.reset(self._orientation, rng)
        images = None if self._live is None else self._live.images
        self.observer.begin(look.histogram, images)
        self._touch.begin()
        self._n_actions = 0
        return self._observed(), self._info(False, look.status, 0.0)

    def act(self, action: Action) -> Transition:
        """Run an action to its end.

        Raises:
            gymnasium.error.ResetNeeded: before the first trial and after its end.
        """
        self.check_open()
        if self._n_actions is None:
            raise gymnasium.error.ResetNeeded("no trial is under way: call reset")
        outcome = self.task.execute(action)
        self._touch.feel(self.task, outcome)
        self._n_actions += 1
        terminated = self.task.inserted
        truncated = not terminated and self._n_actions >= self._max_actions
        info = self._info(outcome.executed, outcome.result, outcome.sim_seconds)
        if terminated or truncated:
            self._n_actions = None
        return Transition(self._observed(), REWARD, terminated, truncated, info)

    def check_open(self) -> None:
        """Refuse what needs the task.

        Raises:
            gymnasium.error.ClosedEnvironmentError: after `close`.
        """
        if self._closed:
            raise gymnasium.error.ClosedEnvironmentError("the environment is closed")

    def close(self) -> None:
        """Close the task; closing again does nothing."""
        self._closed = True
        self.task.close()

    @property
    def _holding(self) -> Holding:
        return self.task.holder or "none"

    def _observed(self) -> Observation:
        return self.observer.observe(self._holding, self._touch.category)

    def _info(
        self, executed: bool, result: str | ActionResult, sim_seconds: float
    ) -> dict[str, Any]:
        return {
            "action_mask": self.choice_set(),
            "orientation": self._orientation,
            "holding": self._holding,
            "category": self._touch.told(self._holding),
            "executed": executed,
            "result": str(result),
            "sim_seconds": sim_seconds,
            "inserted": self.task.inserted,
        }

    def choice_set(self) -> NDArray[np.int8]:
        """What the learner may choose from at present (6,), 1 = may be chosen."""
        return self.task.supervisor.choice_set(self.task.predicates, self._trial)
