import inspect

import numpy as np
import pytest

from prospect_mj.sim.camera import StereoPair
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.vision.vision_controller import VisionController

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def seen(stage):
    return stage.present(np.random.default_rng(1), lid_left=True)


def darkened(pair, part_of, eyes=(0, 1)):
    """Both images with everything black where `part_of(columns, rows)` is true."""
    images = [image.copy() for image in pair]
    for eye in eyes:
        rows, columns = np.indices(images[eye].shape[:2])
        images[eye][part_of(columns, rows)] = 0
    return StereoPair(*images)


def test_the_same_pair_gives_the_same_look(stage, seen):
    again = stage.vision.look(StereoPair(seen.pair.left.copy(), seen.pair.right.copy()))
    assert np.array_equal(again.histogram, seen.look.histogram)
    assert np.array_equal(again.position, seen.look.position)
    assert np.array_equal(again.axis, seen.look.axis)


def test_only_images_and_calibration_come_in():
    """What the controller knows is in its signatures: two pinholes, two images."""
    made = inspect.signature(VisionController.__init__).parameters
    asked = inspect.signature(VisionController.look).parameters
    assert list(made) == ["self", "left", "right", "settings"]
    assert list(asked) == ["self", "pair"]


def test_axis_is_a_horizontal_unit_vector_to_the_left(seen):
    axis = seen.look.axis
    assert np.isclose(np.linalg.norm(axis), 1, atol=1e-12)
    assert abs(axis[2]) < 1e-12
    assert axis[1] > 0


def test_looking_does_not_touch_the_images(stage, seen):
    before = [image.copy() for image in seen.pair]
    stage.vision.look(seen.pair)
    assert all(np.array_equal(a, b) for a, b in zip(before, seen.pair, strict=True))


def test_an_empty_pedestal_is_not_found(stage):
    simulation = stage.simulation
    home = np.array([0.62, 0.0, 0.20])
    simulation.reset(JarPlacement(home, 0.0, True))
    state = simulation.save()
    simulation.data.qpos[simulation.model.jnt_qposadr[-1]] += 5.0  # out of sight
    simulation.restore(simulation.save())
    look = stage.seen(np.random.default_rng(3)).look
    simulation.restore(state)
    assert look.status == "not_found"
    assert look.reason
    assert look.histogram.sum() == 0
    assert look.position is None
    assert look.axis is None


def test_darkness_is_not_found(stage, seen):
    assert stage.vision.look(darkened(seen.pair, lambda c, r: c >= 0)).status == (
        "not_found"
    )


@pytest.mark.parametrize(
    ("hidden", "eyes"),
    [
        (lambda c, r: c < 160, (0, 1)),
        (lambda c, r: c > 200, (0, 1)),
        (lambda c, r: abs(c - 160) < 12, (0, 1)),
        (lambda c, r: r > 120, (0, 1)),
        (lambda c, r: c < 140, (0,)),
        (lambda c, r: c > 0, (1,)),
    ],
    ids=["left half", "right part", "waist", "lower half", "one eye", "blind eye"],
)
def test_an_object_in_part_hidden_is_unsure(stage, seen, hidden, eyes):
    look = stage.vision.look(darkened(seen.pair, hidden, eyes))
    assert look.status == "unsure"
    assert look.reason
    assert look.position is None


def test_whatever_little_is_hidden_a_found_pose_is_right(stage, seen):
    """An occluder creeps over the jar: the pose stays right or is refused."""
    statuses = set()
    for edge in range(60, 140, 4):
        look = stage.vision.look(darkened(seen.pair, lambda c, r, e=edge: c < e))
        statuses.add(look.status)
        if look.status == "found":
            assert np.linalg.norm(look.position - seen.position) < 0.006
    assert statuses == {"found", "unsure"}


def test_an_object_that_leaves_the_searched_region_is_unsure(stage):
    stage.simulation.reset(JarPlacement(np.array([0.62, 0.10, 0.20]), 0.0, True))
    look = stage.seen(np.random.default_rng(4)).look
    assert look.status == "unsure"
    assert "region" in look.reason
