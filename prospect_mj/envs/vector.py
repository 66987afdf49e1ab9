"""Many environments on recorded physics, stepped at once with NumPy's arrays."""

from collections.abc import Mapping
from functools import partial
from typing import Any, ClassVar

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode, SyncVectorEnv, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.checks import check_integer
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.envs.reset_options import ResetOptions, named_options
from prospect_mj.envs.screens import NOTHING, RenderMode
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.trials import REWARD
from prospect_mj.envs.vector_arguments import (
    RESET_MASK,
    Seeds,
    checked_actions,
    checked_mask,
    checked_mode,
    spread,
)
from prospect_mj.envs.vector_trials import VectorTrials
from prospect_mj.errors import InvalidValue

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_MOST = 1_000_000
"""Whose observations fill 2.4 GB."""


def make_vector(
    num_envs: int,
    settings: PickPlaceSettings | None = None,
    autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
    render_mode: RenderMode | None = None,
    **changes: Any,  # noqa: ANN401
) -> VectorEnv:
    """What `gymnasium.make_vec` makes.

    Args:
        num_envs: number of environments.
        settings: all settings; None for the defaults.
        autoreset_mode: when an environment whose trial has ended is reset.
        render_mode: how each is shown, in live physics.
        changes: single settings by name.

    Returns:
        On recorded physics, all at once; on live ones, one after the other.
    """
    check_integer("num_envs", num_envs, 1, _MOST)
    asked = PickPlaceSettings.of(settings, **changes)
    mode = checked_mode(autoreset_mode)
    if asked.physics == "recorded" and not asked.grow:
        return RecordedVectorEnv(num_envs, asked, mode, render_mode)
    if asked.grow and num_envs > 1:
        raise InvalidValue("num_envs", num_envs, "1, as only one may grow a recording")
    one = partial(PickPlaceEnv, asked, render_mode)
    return SyncVectorEnv([one] * num_envs, autoreset_mode=mode)


class RecordedVectorEnv(VectorEnv[Floats, NDArray[np.integer], NDArray]):
    """Steps n environments on recorded physics at once.

    Each is a `PickPlaceEnv(physics="recorded")` to the last bit, with a generator of
    its own: environment i, reset with seed s, shows what a single one shows that is
    reset with s + i, or with the i-th seed where `reset` is given a sequence. Options
    of `reset` hold for all of them; `reset_mask`, (n,) bool, says which are reset.

    Each counts its own trials for a shaping schedule. Every key of the infos holds an
    array over the environments, and `_key` says for which of them it means anything.

    Args:
        num_envs: number of environments.
        settings: all settings; None for the defaults, but on recorded physics.
        autoreset_mode: what happens when a trial has ended: it is reset by the next
            step, whose action it ignores, by the same step, or by hand.
        render_mode: None, as nothing is simulated.
        changes: single settings by name.
    """

    metadata: ClassVar[dict[str, Any]] = {
        "render_modes": [],
        "autoreset_mode": AutoresetMode.NEXT_STEP,
    }

    def __init__(
        self,
        num_envs: int,
        settings: PickPlaceSettings | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: None = None,
        **changes: Any,  # noqa: ANN401
    ) -> None:
        """Load the recording.

        Raises:
            InvalidChoice: on a setting or a choice that does not exist.
            InvalidValue: on a setting that is out of its range.
            RecordingError: if the recording can't be had, or is of other physics.
        """
        check_integer("num_envs", num_envs, 1, _MOST)
        if render_mode is not None:
            raise InvalidValue("render_mode", render_mode, NOTHING)
        base = PickPlaceSettings(physics="recorded") if settings is None else settings
        self.settings = PickPlaceSettings.of(base, **changes)
        if self.settings.physics != "recorded":
            raise InvalidValue("physics", self.settings.physics, "'recorded'")
        if self.settings.grow:
            raise InvalidValue("grow", True, "False: many step a recording as it is")
        self.num_envs = num_envs
        self._mode = checked_mode(autoreset_mode)
        self.metadata = self.metadata | {"autoreset_mode": self._mode}
        self._trials = VectorTrials(self.settings, num_envs)
        self.single_observation_space = self._trials.space
        self.single_action_space = spaces.Discrete(len(Action))
        self.observation_space = batch_space(self._trials.space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._generators = [seeding.np_random(None) for _ in range(num_envs)]
        self._ended = np.zeros(num_envs, bool)

    @property
    def np_random(self) -> tuple[np.random.Generator, ...]:
        """The generator of every environment."""
        return tuple(rng for rng, _ in self._generators)

    @property
    def np_random_seed(self) -> tuple[int, ...]:
        """The seed of every environment."""
        return tuple(seed for _, seed in self._generators)

    def reset(
        self, *, seed: Seeds = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Floats, dict[str, Any]]:
        """Present the jar to all environments, or to those under a mask.

        Args:
            seed: of the first one, the others' counting on; or one for each. None goes
                on with the generators that are there.
            options: of `PickPlaceEnv.reset`, and `reset_mask`.

        Raises:
            InvalidChoice: on an unknown option or orientation.
            InvalidValue: on seeds, a mask or a trial that can't be.
            gymnasium.error.ClosedEnvironmentError: after `close`.
        """
        self._check_open()
        given = named_options(options)
        mask = checked_mask(given.pop(RESET_MASK, None), self.num_envs)
        told = ResetOptions.read(given)
        seeds = spread(seed, self.num_envs)
        which = np.flatnonzero(mask)
        for number in which:
            if seeds[number] is not None:
                self._generators[number] = seeding.np_random(seeds[number])
        self._trials.begin(which, told, self.np_random)
        self._ended[which] = False
        return self._trials.observe(), self._trials.infos(mask)

    def step(
        self, actions: NDArray[np.integer]
    ) -> tuple[Floats, Floats, Flags, Flags, dict[str, Any]]:
        """Run an action in each environment.

        Raises:
            InvalidChoice: if there is no such action.
            InvalidValue: if there is not one for each environment.
            gymnasium.error.ResetNeeded: before the first reset; after the end of a
                trial only if it is to be reset by hand.
            gymnasium.error.ClosedEnvironmentError: after `close`.
        """
        self._check_open()
        chosen = checked_actions(actions, self.num_envs)
        by_hand = self._mode is AutoresetMode.DISABLED and self._ended.any()
        if by_hand or not self._trials.begun.all():
            raise gymnasium.error.ResetNeeded("no trial is under way: call reset")
        act, again = np.flatnonzero(~self._ended), np.flatnonzero(self._ended)
        terminated, truncated = np.zeros((2, self.num_envs), bool)
        rewards = np.where(self._ended, 0.0, REWARD)
        terminated[act], truncated[act] = self._trials.act(act, chosen[act])
        self._trials.begin(again, ResetOptions(), self.np_random)
        self._ended = terminated | truncated
        finals = self._restarted() if self._mode is AutoresetMode.SAME_STEP else {}
        infos = self._trials.infos(np.ones(self.num_envs, bool)) | finals
        return self._trials.observe(), rewards, terminated, truncated, infos

    def _restarted(self) -> dict[str, Any]:
        """Begin anew where a trial has ended; how it ended, as Gymnasium tells it."""
        ended, which = self._ended, np.flatnonzero(self._ended)
        if not len(which):
            return {}
        last = np.full(self.num_envs, None, object)
        last[which] = [*self._trials.observe()[which]]
        finals = {"final_obs": last, "final_info": self._trials.infos(ended)}
        self._trials.begin(which, ResetOptions(), self.np_random)
        self._ended = np.zeros(self.num_envs, bool)
        return finals | {f"_{key}": ended.copy() for key in finals}

    def _check_open(self) -> None:
        if self.closed:
            raise gymnasium.error.ClosedEnvironmentError("they are closed")

    def action_masks(self) -> Flags:
        """The choice sets as booleans (n, 6)."""
        return self._trials.choice_sets().astype(bool)
