"""Raw stereo images as an observation."""

import numpy as np
import pytest

from prospect_mj.envs.pick_place import PickPlaceEnv

pytestmark = pytest.mark.gl
IMAGES = ("left_image", "right_image")


@pytest.fixture(scope="module")
def env():
    env = PickPlaceEnv(observation="images")
    yield env
    env.close()


def test_gymnasiums_own_check_finds_nothing(gymnasiums_check):
    gymnasiums_check(
        skip_render_check=True, observation="images", gross_motion="cartesian"
    )


def test_the_images_are_what_both_eyes_saw(env):
    seen, _ = env.reset(seed=1, options={"orientation": "left"})
    assert env.observation_space.contains(seen)
    assert set(seen) == {"features", *IMAGES}
    looked = env.task.images
    for name, image in zip(IMAGES, looked, strict=True):
        assert seen[name].shape == (240, 320, 3)
        assert seen[name].dtype == np.uint8
        assert np.array_equal(seen[name], image)
        assert not np.shares_memory(seen[name], image)
    assert (seen["left_image"] != seen["right_image"]).any()


def test_the_robot_looks_once(env):
    first, _ = env.reset(seed=1, options={"orientation": "left"})
    held, *_ = env.step(0)
    for name in IMAGES:
        assert np.array_equal(first[name], held[name])
        assert not np.shares_memory(first[name], held[name])
    assert (first["features"] != held["features"]).any()
    other, _ = env.reset()
    assert (other["left_image"] != first["left_image"]).any()


def test_the_features_and_the_trial_are_those_without_images(env):
    plain = PickPlaceEnv()
    try:
        with_images, info = env.reset(seed=7)
        features, told = plain.reset(seed=7)
        assert np.array_equal(with_images["features"], features)
        assert repr(info) == repr(told)
    finally:
        plain.close()


def test_a_watched_environment_has_images_too(env):
    env.watch()
    seen, _ = env.reset(seed=1)
    assert np.array_equal(seen["left_image"], env.task.task.images.left)
