"""Rendering shows what happens, and changes nothing of it."""

import contextlib
import gc
import hashlib
import itertools
import subprocess
import sys
import weakref

import gymnasium
import mujoco
import mujoco.viewer
import numpy as np
import pytest

import prospect_mj  # noqa: F401  (registers the environment)
from prospect_mj import display
from prospect_mj.envs.pick_place import PickPlaceEnv
from prospect_mj.errors import InvalidChoice, NoDisplay
from prospect_mj.sim import overview

pytestmark = pytest.mark.gl
ENV_ID = "prospect_mj/PickPlace-v0"
SIZE = {"width": 64, "height": 48, "gross_motion": "cartesian"}
FILM_RATE = 25
HANDS = {"left": 0, "right": 1}


@pytest.fixture(autouse=True)
def _without_shadows(monkeypatch):
    """In a tenth of the time."""
    light = overview.light_for_people

    def light_cheaply(model, size):
        light(model, size)
        model.vis.quality.shadowsize = model.vis.quality.offsamples = 0

    monkeypatch.setattr(overview, "light_for_people", light_cheaply)


class FakeHandle:
    """Stands for MuJoCo's viewer, where there is no display."""

    def __init__(self, model, data, **panels):
        self.model, self.data, self.cam = model, data, mujoco.MjvCamera()
        self.open, self.shown = True, []

    def is_running(self):
        return self.open

    def lock(self):
        return contextlib.nullcontext()

    def sync(self):
        # Whoever looks on may pull at the jar.
        self.shown.append((self.data.time, self.data.qpos.copy()))
        self.data.xfrc_applied[:] = 100.0
        self.model.opt.gravity[:] = 0.0

    def close(self):
        self.open = False


@pytest.fixture
def windows(monkeypatch):
    """Every window that is opened; none of them waits for real time."""
    opened = []

    def launch(*scene, **panels):
        opened.append(FakeHandle(*scene, **panels))
        return opened[-1]

    monkeypatch.setattr(display, "why_no_window", lambda: None)
    monkeypatch.setattr(mujoco.viewer, "launch_passive", launch)
    monkeypatch.setattr("prospect_mj.envs.window.time.sleep", lambda seconds: None)
    return opened


def rollout(mode):
    """Hash of all that happens in two actions, rendered after each."""
    env = PickPlaceEnv(render_mode=mode, **SIZE)
    digest = hashlib.sha256()
    try:
        for lid, hand in HANDS.items():
            seen, told = env.reset(seed=4, options={"orientation": lid})
            digest.update(seen.tobytes() + repr(told).encode())
            *step, told = env.step(hand)
            if mode is not None:
                env.render()
            digest.update(step[0].tobytes() + repr((step[1:], told)).encode())
            digest.update(env.task.simulation.save().tobytes())
    finally:
        env.close()
    return digest.hexdigest()


@pytest.fixture(scope="module")
def unseen():
    return rollout(None)


@pytest.mark.parametrize("mode", ["rgb_array", "rgb_array_list", "human"])
def test_results_are_those_of_an_environment_that_nobody_sees(mode, unseen, windows):
    assert rollout(mode) == unseen


def test_a_picture_shows_the_scene_after_reset_and_after_an_action():
    env = gymnasium.make(ENV_ID, render_mode="rgb_array", width=160, height=120)
    try:
        assert env.metadata["render_fps"] == 1
        env.reset(seed=1, options={"orientation": "left"})
        before, again = env.render(), env.render()
        assert before.shape == (120, 160, 3)
        assert before.dtype == np.uint8
        assert np.array_equal(before, again)
        assert not np.shares_memory(before, again)
        # A lit scene of many colours, not an empty one.
        assert before.std() > 20
        env.step(0)
        moved = (env.render() != before).any(axis=2).mean()
        assert 0.02 < moved < 0.9
        env.reset(seed=1, options={"orientation": "left"})
        assert np.array_equal(env.render(), before)
    finally:
        env.close()


def test_a_film_has_the_pictures_since_it_was_last_asked_for():
    env = PickPlaceEnv(render_mode="rgb_array_list", **SIZE)
    try:
        assert env.metadata["render_fps"] == FILM_RATE
        env.reset(seed=1, options={"orientation": "left"})
        (start,) = env.render()
        *_, told = env.step(0)
        film = env.render()
        assert len(film) == pytest.approx(FILM_RATE * told["sim_seconds"], abs=1)
        changes = [(a != b).any() for a, b in itertools.pairwise(film)]
        assert np.mean(changes) > 0.8
        assert (film[-1] != start).any()
        assert env.render() == []
        env.step(4)
        env.reset(seed=1, options={"orientation": "left"})
        (anew,) = env.render()
        assert np.array_equal(anew, start)
    finally:
        env.close()


def test_a_window_follows_an_action_until_it_is_closed(windows):
    env = PickPlaceEnv(render_mode="human", **SIZE)
    try:
        env.reset(seed=1, options={"orientation": "left"})
        (window,) = windows
        window.shown.clear()
        *_, told = env.step(0)
        times, poses = zip(*window.shown, strict=True)
        assert np.diff(times) == pytest.approx(1 / FILM_RATE, abs=1e-6)
        assert times[-1] - times[0] == pytest.approx(told["sim_seconds"], abs=0.1)
        assert np.ptp(poses, axis=0).max() > 0.1
        assert env.render() is None
        window.open = False
        shown = len(window.shown)
        assert env.step(4)[4]["executed"]
        assert len(window.shown) == shown
    finally:
        env.close()


def test_gymnasiums_own_check_finds_nothing_in_any_mode(windows, gymnasiums_check):
    gymnasiums_check(**SIZE)
    assert len(windows) == 1


def test_without_a_display_a_window_is_refused_before_anything_is_made(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    made = []
    monkeypatch.setattr("prospect_mj.envs.pick_place.Trials", made.append)
    with pytest.raises(NoDisplay, match="rgb_array") as raised:
        PickPlaceEnv(render_mode="human")
    assert "\n" not in str(raised.value)
    assert made == []


@pytest.mark.parametrize("mode", ["rgb_array", "rgb_array_list"])
def test_what_nobody_closes_is_given_back_when_it_is_no_longer_used(mode):
    env = PickPlaceEnv(render_mode=mode, **SIZE)
    env.reset(seed=1)
    env.render()
    screen, renderer = env._screen, env._screen._renderer
    given_back = [weakref.ref(screen), weakref.ref(renderer)]
    # At once, and not by the way, while another one renders.
    gc.disable()
    try:
        del env, screen, renderer
        assert [reference() for reference in given_back] == [None, None]
    finally:
        gc.enable()


def test_modes_that_do_not_exist_are_refused_with_those_that_do():
    with pytest.raises(InvalidChoice, match="valid: None, rgb_array, rgb_array_list"):
        PickPlaceEnv(render_mode="ansi")


def test_render_without_a_mode_warns():
    env = PickPlaceEnv()
    try:
        with pytest.warns(UserWarning, match="without a render_mode"):
            assert env.render() is None
    finally:
        env.close()


def test_a_process_that_closes_nothing_ends_quietly():
    code = (
        # Whose end comes after that of OpenGL.
        "import gymnasium, prospect_mj, weakref; weakref.finalize(gymnasium, int)\n"
        "env = gymnasium.make('prospect_mj/PickPlace-v0', render_mode='rgb_array')\n"
        "env.reset(seed=0); env.render()"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert done.stdout + done.stderr == ""
