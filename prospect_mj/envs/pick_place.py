"""The pick and place task as a Gymnasium environment."""

from typing import TYPE_CHECKING, Any, ClassVar

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.envs.observation import Observation
from prospect_mj.envs.reset_options import ResetOptions
from prospect_mj.envs.screens import (
    FILM_RATE,
    NOTHING,
    RENDER_MODES,
    RenderMode,
    check_render_mode,
    make_screen,
    metadata,
)
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.tasks import Task
from prospect_mj.envs.trials import Trials
from prospect_mj.errors import InvalidChoice, InvalidValue

if TYPE_CHECKING:
    import mujoco

    from prospect_mj.envs.pictures import Screen
    from prospect_mj.episodes.recorder import WatchedTask


class PickPlaceEnv(gymnasium.Env[Observation, int]):
    """A two-armed torso picks up a jar and inserts it into a receptacle.

    ## Description
    A jar lies in a cradle with its lid to the left or to the right. It fits into the
    receptacle only base first, so only a hand that holds it by the lid end can insert
    it. Each action is a closed-loop behaviour of seconds in full MuJoCo physics; the
    robot sees the jar once, before the first action, and feels it from then on.

    ## Action Space
    `Discrete(6)`:

    - 0: grasp left: pick the jar up with the left hand by its left end
    - 1: grasp right
    - 2: swap left to right: hand the jar over in the air
    - 3: swap right to left
    - 4: insert left: insert the jar that the left hand holds
    - 5: insert right

    An action that the supervisor does not allow moves nothing and changes nothing.

    ## Observation Space
    `Box((303,))`, float64: with v the scaled 100-bin intensity histogram of the jar's
    pixels and h_L, h_R the grasp predicates, (v, v h_L, v h_R, h_L, h_R, 1); see
    `prospect_mj.agent.features`. With `haptic_models`, K categories of grasps, there
    is a bit more for each category: `Box((101 (3 + K),))`.

    With `observation="images"`, in live physics, a `Dict` of these `features` and of
    `left_image` and `right_image`, `Box(0, 255, (240, 320, 3), uint8)`: what both eyes
    saw, noise and all. The robot looks once, so the images are those of the
    presentation all through a trial; what changes with an action is in the features.

    ## Starting State
    Arms at rest, hands open. The jar's position is uniform within 2 cm in x and y and
    1 cm in z of its nominal, its yaw within 10 degrees, the lamp's brightness within
    10 %; recorded physics draws from recorded presentations of that distribution.
    Options of `reset`, without which chance and counting decide:

    - `"orientation"`: `"left"` or `"right"`, the side on which the lid lies
    - `"trial"`: number of the trial from 0, which a shaping schedule counts by

    ## Rewards
    -1 per action, run or not. Two actions are optimal: a return of -2.

    ## Episode End
    - Termination: the jar stands in the receptacle.
    - Truncation: after ten actions (`max_actions`).

    ## Information
    `reset` and `step` return the same keys:

    - `action_mask`: (6,) int8, the supervisor's choice set by mode and schedule;
      `action_masks()` gives it as booleans, through wrappers
      `env.get_wrapper_attr("action_masks")()`
    - `orientation`: the side on which the lid lies
    - `holding`: `"none"`, `"left"` or `"right"`: the grasp predicates
    - `category`: of the grasp that holds the jar, from 0, by the `haptic_models`; -1
      without these, and where no hand holds
    - `executed`: whether the action was run (False from `reset`)
    - `result`: an `ActionResult`, such as `"success"` or `"jammed"`; from `reset` the
      status of the look: `"found"`, `"unsure"` or `"not_found"`
    - `sim_seconds`: simulated time of this action [s]
    - `inserted`: whether the jar stands in the receptacle

    ## Arguments
    ```python
    import gymnasium
    gymnasium.make("prospect_mj/PickPlace-v0", physics="recorded")
    gymnasium.make("prospect_mj/PickPlace-v0", render_mode="rgb_array", width=320)
    gymnasium.make_vec("prospect_mj/PickPlace-v0", num_envs=1000, physics="recorded")
    ```
    Every field of `PickPlaceSettings` by its name, or `settings`, one as a whole. With
    `physics="recorded"` every outcome is looked up in the recording that comes with
    the package, one of 50 presentations of each orientation, and a step takes
    microseconds in place of a quarter of a second.

    `render_mode`, in live physics, where it changes no result; `width` and `height`
    are those of a picture:

    - `"rgb_array"`: `render()` gives the scene as it is, (height, width, 3) uint8;
      `render_fps` is 1, for a slide show with a picture after every action
    - `"rgb_array_list"`: the film since the last `render()` or `reset`, a list of
      pictures, `render_fps` = 25 of them for a simulated second
    - `"human"`: MuJoCo's viewer, at real time; it needs a display

    `make_vec` steps many recorded trials at once (`envs.vector`); on live physics it
    steps one environment after the other. `envs.dm_face` is the same as a
    `dm_env.Environment`.

    ## References
    D. Wheeler, A. H. Fagg and R. A. Grupen, "Learning prospective pick and place
    behavior", Proceedings of the International Conference on Development and Learning
    (ICDL), 2002.

    ## Version History
    * v0: first version
    """

    metadata: ClassVar[dict[str, Any]] = {
        "render_modes": [*RENDER_MODES],
        "render_fps": FILM_RATE,
    }

    def __init__(
        self,
        settings: PickPlaceSettings | None = None,
        render_mode: RenderMode | None = None,
        **changes: Any,  # noqa: ANN401
    ) -> None:
        """Make the task.

        Args:
            settings: all settings; None for the defaults.
            render_mode: how to show it; None for not at all.
            changes: single settings by name.

        Raises:
            InvalidChoice: on a setting or a choice that does not exist.
            InvalidValue: on a setting that is out of its range or of another kind.
            NoDisplay: if there is none to open a window on.
            RenderingUnavailable: if something is to be simulated without OpenGL.
            RecordingError: if the recording can't be had, or is of other physics.
        """
        self.settings = PickPlaceSettings.of(settings, **changes)
        check_render_mode(render_mode, self.settings)
        self.render_mode = render_mode
        self.metadata = metadata(render_mode, self.settings)
        self._trials = Trials(self.settings)
        self.observation_space = self._trials.observer.space
        self.action_space = spaces.Discrete(len(Action))
        self._screen: Screen | None = None
        if render_mode is not None and self.settings.physics == "live":
            live = self._trials.live.simulation
            self._screen = make_screen(render_mode, live, self.settings)

    @property
    def task(self) -> Task:
        """What the actions are run on."""
        return self._trials.task

    @property
    def model(self) -> "mujoco.MjModel":
        """The live scene."""
        return self._trials.live.simulation.model

    @property
    def data(self) -> "mujoco.MjData":
        """The live state."""
        return self._trials.live.simulation.data

    def watch(self) -> "WatchedTask":
        """Remember every trial from now on; what happens stays the same.

        Returns:
            What has the episode of the trial under way.

        Raises:
            RecordingError: on recorded physics, which has nothing to be seen.
        """
        return self._trials.watch()

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Present the jar and look at it.

        Raises:
            InvalidChoice: on an unknown option or orientation.
            InvalidValue: on a trial that is no number from 0.
        """
        told = ResetOptions.read(options)
        super().reset(seed=seed)
        begun = self._trials.begin(told, self.np_random)
        if self._screen is not None:
            self._screen.begin()
        return begun

    def step(
        self, action: int
    ) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Run one of the six actions to its end.

        Raises:
            InvalidChoice: if there is no such action.
            gymnasium.error.ResetNeeded: before the first reset and after the end.
        """
        if isinstance(action, bool) or not self.action_space.contains(action):
            raise InvalidChoice("action", action, range(len(Action)))
        return tuple(self._trials.act(Action(int(action))))

    def action_masks(self) -> NDArray[np.bool_]:
        """The choice set as booleans (6,), for agents that ask the environment."""
        return self._trials.choice_set().astype(bool)

    def render(self) -> Any:  # noqa: ANN401
        """What the render mode asks for; see the class.

        Raises:
            InvalidValue: on recorded physics, where nothing is simulated.
            gymnasium.error.ClosedEnvironmentError: after `close`, as of all else.
        """
        self._trials.check_open()
        if self._screen is not None:
            return self._screen.render()
        if self.render_mode is not None:
            raise InvalidValue("render_mode", self.render_mode, NOTHING)
        gymnasium.logger.warn("nothing is rendered without a render_mode")
        return None

    def close(self) -> None:
        """Close the eyes, and what shows the scene."""
        if self._screen is not None:
            self._screen.close()
        self._trials.close()
