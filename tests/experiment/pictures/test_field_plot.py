"""The picture of a harmonic function: what it shows is what the planner computes."""

import numpy as np
import pytest
from reach_clearance import planners_clearance

from prospect_mj.experiment.pictures import (
    corridor,
    field_plot,
    field_scene,
    field_slice,
)
from prospect_mj.experiment.run.plots import png
from prospect_mj.planning.planner import World

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def shown():
    return field_slice.joint_slice()


def test_every_kind_of_obstacle_but_the_arm_itself_is_seen(shown):
    kinds = set(np.unique(shown.obstacle).tolist())
    assert {field_slice.KINDS[k - 1] for k in kinds - {field_slice.FREE}} == {
        "table",
        "post",
        "other arm",
        "torso and head",
        "jar and fixtures",
    }


def test_free_cells_are_what_the_planner_finds_clear(shown):
    """By one call for all solids, instead of one for each kind."""
    twin = field_slice.twin()
    cells = np.random.default_rng(0).integers(0, shown.grid.shape, (400, 2))
    joints = field_slice.configurations(shown.grid.centre(cells))
    world = World(twin.data, field_slice.known_jars())
    room = planners_clearance(twin.model, field_slice.SIDE, joints, world)
    clear = room >= field_slice.CLEARANCE
    assert 0.5 < clear.mean() < 0.95
    free = shown.obstacle[tuple(cells.T)] == field_slice.FREE
    np.testing.assert_array_equal(free, clear)


def test_every_streamline_of_the_picture_arrives_through_free_cells(shown):
    for start in [np.array(field_slice.START), *field_plot.STARTS]:
        line = shown.streamline(start)
        assert line.reached
        cells = tuple(shown.grid.cell_of(line.points).T)
        assert (shown.obstacle[cells] == field_slice.FREE).all()


def test_straight_from_start_to_goal_is_the_post(shown):
    """So the way that is shown goes round something."""
    between = np.linspace(field_slice.START, field_slice.GOAL, 50)
    met = set(shown.obstacle[tuple(shown.grid.cell_of(between).T)].tolist())
    assert field_slice.KINDS.index("post") + 1 in met


def test_the_photograph_shows_the_arm_in_every_tint():
    tints = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    places = np.array([field_slice.START, field_slice.GOAL])
    joints = field_slice.configurations(places)
    picture = field_scene.photograph(joints, tints, (90, 120)).astype(float)
    without = field_scene.photograph(joints[1:], tints[1:], (90, 120)).astype(float)
    red = picture[..., 0] - picture[..., 1:].max(axis=-1)
    green = picture[..., 1] - picture[..., [0, 2]].max(axis=-1)
    assert (red > 60).sum() > 50
    assert (green > 60).sum() > 50
    changed = np.abs(picture - without).max(axis=-1) > 8
    assert 50 < changed.sum() < 0.2 * changed.size


def test_the_corridor_decays_at_the_rate_of_its_difference_equation():
    """cosh(k) = 2 - cos(pi / w) with w cells from wall to wall."""
    widths, log_u = corridor.decay()
    width = corridor.CELLS_ACROSS + 1
    per_width = -width * np.arccosh(2 - np.cos(np.pi / width)) / np.log(10)
    far = (widths > 20) & (widths < 280)
    slope = np.polyfit(widths[far], log_u[far], 1)[0]
    assert slope == pytest.approx(per_width, rel=1e-6)
    assert log_u.min() < np.log10(np.finfo(float).smallest_subnormal)


def test_the_picture_is_drawn_twice_alike_in_as_many_steps(shown, monkeypatch):
    ticks = []
    monkeypatch.setattr(field_plot, "joint_slice", lambda: shown)
    content = field_plot.field_picture(lambda: ticks.append(1))
    assert len(ticks) == field_plot.STEPS
    assert content == png(field_plot.drawing(shown))
