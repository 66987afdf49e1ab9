"""The pick and place task as a Gymnasium environment."""

from typing import TYPE_CHECKING, Any, ClassVar, cast

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.agent.features import N_BINS, Holding, StateFeatureGenerator
from prospect_mj.envs.reset_options import ResetOptions
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.tasks import Task, make_task
from prospect_mj.errors import InvalidChoice, InvalidValue, RecordingError
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

if TYPE_CHECKING:
    import mujoco

    from prospect_mj.episodes.recorder import WatchedTask
    from prospect_mj.sim.simulation import Simulation
    from prospect_mj.task.pick_place import PickPlaceTask


class PickPlaceEnv(gymnasium.Env[NDArray[np.float64], int]):
    """A two-armed torso picks up a jar and inserts it into a receptacle.

    ## Description
    A jar lies in a cradle with its lid to the left or to the right. It fits into the
    receptacle only base first, so only a hand that holds it by the lid end can insert
    it. Each action is a closed-loop behaviour of seconds in full MuJoCo physics; the
    robot sees the jar once, before the first action, and feels it from then on.

    ## Action space
    `Discrete(6)`:

    | action | meaning |
    |---|---|
    | 0 | grasp left: pick the jar up with the left hand by its left end |
    | 1 | grasp right |
    | 2 | swap left to right: hand the jar over in the air |
    | 3 | swap right to left |
    | 4 | insert left: insert the jar that the left hand holds |
    | 5 | insert right |

    An action that the supervisor does not allow moves nothing and changes nothing.

    ## Observation space
    `Box((303,))`: with v the scaled 100-bin intensity histogram of the jar's pixels and
    h_L, h_R the grasp predicates, (v, v h_L, v h_R, h_L, h_R, 1); see
    `prospect_mj.agent.features`.

    ## Starting state
    Arms at rest, hands open. The jar's position is uniform within 2 cm in x and y and
    1 cm in z of its nominal, its yaw within 10 degrees, the lamp's brightness within
    10 %. `reset(options={"orientation": "left" | "right"})` sets the side on which the
    lid lies; otherwise it is drawn. `reset(options={"trial": n})` tells the number of
    the trial, from 0, which a shaping schedule counts by; otherwise it is one more than
    that of the trial before.

    ## Rewards
    -1 per action.

    ## Episode end
    Terminated when the jar stands in the receptacle; truncated after ten actions.

    ## Info
    The same keys from `reset` and `step`:

    | key | meaning |
    |---|---|
    | `action_mask` | (6,) int8, the supervisor's choice set by mode and schedule |
    | `orientation` | the side on which the lid lies |
    | `holding` | "none", "left" or "right": the grasp predicates |
    | `executed` | whether the action was run (False from `reset`) |
    | `result` | an `ActionResult`, such as "success" or "jammed"; from `reset` the \
status of the look: "found", "unsure" or "not_found" |
    | `sim_seconds` | simulated time of this action [s] |
    | `inserted` | whether the jar stands in the receptacle |

    ## Arguments
    `settings`: a `PickPlaceSettings`. Each of its fields may be given by name instead,
    such as `physics="recorded"`: every outcome is then looked up in the recording that
    comes with the package, one of 50 presentations of each orientation, and a step
    takes microseconds in place of a quarter of a second.

    ## References
    Wheeler, Fagg and Grupen, "Learning prospective pick and place behavior", ICDL 2002.

    ## Version history
    * v0: first version.
    """

    metadata: ClassVar[dict[str, Any]] = {"render_modes": []}

    def __init__(
        self,
        settings: PickPlaceSettings | None = None,
        render_mode: None = None,
        **changes: Any,  # noqa: ANN401
    ) -> None:
        """Make the task.

        Args:
            settings: all settings; None for the defaults.
            render_mode: must be None.
            changes: single settings by name.

        Raises:
            InvalidChoice: on a setting or a choice that does not exist.
            InvalidValue: on a setting that is out of its range or of another kind.
            RenderingUnavailable: if something is to be simulated without OpenGL.
            RecordingError: if the recording can't be had, or is of other physics.
        """
        if render_mode is not None:
            raise InvalidChoice("render_mode", render_mode, [None])
        self.render_mode = None
        given = PickPlaceSettings() if settings is None else settings
        if not isinstance(given, PickPlaceSettings):
            raise InvalidValue("settings", given, "a PickPlaceSettings")
        self.settings = given.changed(**changes)
        self.task: Task = make_task(self.settings)
        self._generator = StateFeatureGenerator(self.settings.features)
        low, high = self._generator.bounds
        self.observation_space = spaces.Box(low, high, dtype=np.float64)
        self.action_space = spaces.Discrete(len(Action))
        self._orientation: Orientation = ORIENTATIONS[0]
        self._trial = -1
        self._n_actions: int | None = None
        self._histogram: NDArray[np.int64] = np.zeros(N_BINS, np.int64)

    @property
    def model(self) -> "mujoco.MjModel":
        """The live scene."""
        return self._simulation.model

    @property
    def data(self) -> "mujoco.MjData":
        """The live state."""
        return self._simulation.data

    @property
    def _simulation(self) -> "Simulation":
        if self.settings.physics != "live":
            raise RecordingError("recorded physics has no model and data")
        return cast("PickPlaceTask", self.task).simulation

    def watch(self) -> "WatchedTask":
        """Remember every trial from now on; what happens stays the same.

        Returns:
            What has the episode of the trial under way.

        Raises:
            RecordingError: on recorded physics, which has nothing to be seen.
        """
        _ = self._simulation
        # Where nothing is simulated, nothing of MuJoCo is loaded.
        from prospect_mj.episodes.recorder import WatchedTask

        if not isinstance(self.task, WatchedTask):
            self.task = WatchedTask(cast("PickPlaceTask", self.task))
        return self.task

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.float64], dict[str, Any]]:
        """Present the jar and look at it.

        Raises:
            InvalidChoice: on an unknown option or orientation.
            InvalidValue: on a trial that is no number from 0.
        """
        super().reset(seed=seed)
        told = ResetOptions.read(options)
        self._orientation = told.orientation or self._drawn_orientation()
        self._trial = self._trial + 1 if told.trial is None else told.trial
        look = self.task.reset(self._orientation, self.np_random)
        self._histogram = look.histogram
        self._n_actions = 0
        return self._observation(), self._info(False, look.status, 0.0)

    def _drawn_orientation(self) -> Orientation:
        return ORIENTATIONS[int(self.np_random.integers(len(ORIENTATIONS)))]

    def step(
        self, action: int
    ) -> tuple[NDArray[np.float64], float, bool, bool, dict[str, Any]]:
        """Run one of the six actions to its end.

        Raises:
            InvalidChoice: if there is no such action.
            gymnasium.error.ResetNeeded: before the first reset and after the end.
        """
        if self._n_actions is None:
            raise gymnasium.error.ResetNeeded("no trial is under way: call reset")
        if isinstance(action, bool) or not self.action_space.contains(action):
            raise InvalidChoice("action", action, range(len(Action)))
        outcome = self.task.execute(Action(int(action)))
        self._n_actions += 1
        terminated = self.task.inserted
        truncated = not terminated and self._n_actions >= self.settings.max_actions
        info = self._info(outcome.executed, outcome.result, outcome.sim_seconds)
        observation = self._observation()
        if terminated or truncated:
            self._n_actions = None
        return observation, -1.0, terminated, truncated, info

    @property
    def _holding(self) -> Holding:
        return self.task.holder or "none"

    def _observation(self) -> NDArray[np.float64]:
        return self._generator.generate(self._histogram, self._holding)

    def _info(
        self, executed: bool, result: str | ActionResult, sim_seconds: float
    ) -> dict[str, Any]:
        return {
            "action_mask": self._choice_set(),
            "orientation": self._orientation,
            "holding": self._holding,
            "executed": executed,
            "result": str(result),
            "sim_seconds": sim_seconds,
            "inserted": self.task.inserted,
        }

    def action_masks(self) -> NDArray[np.bool_]:
        """The choice set as booleans (6,), for agents that ask the environment."""
        return self._choice_set().astype(bool)

    def _choice_set(self) -> NDArray[np.int8]:
        return self.task.supervisor.choice_set(self.task.predicates, self._trial)

    def close(self) -> None:
        """Close the eyes."""
        self.task.close()
