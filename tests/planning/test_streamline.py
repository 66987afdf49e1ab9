import numpy as np
import pytest
from maps import channel, random_map, serpentine

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.ascent import ascend
from prospect_mj.planning.harmonic_field import harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.streamline import streamline

LOW = (-2.6, -2.0, -2.8, -0.9)
HIGH = (2.6, 2.0, 2.8, 3.1)


def arm_grid(*cells):
    return JointGrid(LOW[: len(cells)], HIGH[: len(cells)], cells)


def random_field(grid, seed, blob, share=0.5):
    rng = np.random.default_rng(seed)
    return harmonic_field(grid, *random_map(rng, grid.shape, blob, share))


def direction(field, joints):
    """Of the first step up from joint angles (n_joints,) [rad]."""
    ascent = np.zeros(field.grid.n_joints)
    ascend(field.arrays, joints, 0.25 * field.grid.spacing.min(), False, ascent)
    return ascent


def assert_stays_connected(field, points):
    """Points and the segments between them lie in cells connected to a goal."""
    between = [points[:-1] + t * np.diff(points, axis=0) for t in (0.25, 0.5, 0.75)]
    cells = field.grid.cell_of(np.concatenate([points, *between]))
    assert field.connected[tuple(cells.T)].all()
    assert (points >= field.grid.low).all()
    assert (points <= field.grid.high).all()


def assert_every_streamline_arrives(field, starts):
    for start in starts:
        way = streamline(field, start, 0.05, 60.0)
        assert way.reached
        assert field.log_u[tuple(field.grid.cell_of(way.points[-1]))] == 0
        np.testing.assert_array_equal(way.points[0], start)
        assert_stays_connected(field, way.points)


@pytest.mark.parametrize("cells", [(40, 33), (14, 12, 15), (8, 8, 8, 8)])
@pytest.mark.parametrize("blob", [0.6, 1.0, 1.5])
def test_from_every_connected_cell_it_arrives(cells, blob):
    field = random_field(arm_grid(*cells), seed=int(10 * blob), blob=blob)
    connected = np.argwhere(field.connected)
    assert len(connected) > 100
    assert_every_streamline_arrives(field, field.grid.centre(connected))


@pytest.mark.parametrize("seed", range(2))
def test_from_anywhere_in_a_cell_of_a_planning_grid_it_arrives(seed):
    grid = arm_grid(16, 16, 16, 16)
    field = random_field(grid, seed, blob=0.8 + seed, share=0.4)
    rng = np.random.default_rng(seed)
    cells = rng.choice(np.argwhere(field.connected), 500, replace=False)
    offsets = rng.uniform(-0.499, 0.499, cells.shape)
    assert_every_streamline_arrives(field, grid.centre(cells + offsets))


def test_from_a_cell_that_is_not_connected_it_does_not_start():
    field = random_field(arm_grid(40, 33), seed=6, blob=1.0)
    rest = field.grid.centre(np.argwhere(~field.connected))
    for start in rest:
        way = streamline(field, start, 0.05, 60.0)
        assert not way.reached
        np.testing.assert_array_equal(way.points, [start])


def test_it_arrives_where_double_precision_has_long_ended():
    free, goal = serpentine(49)
    grid = JointGrid((0.0, 0.0), (4.9, 4.9), free.shape)
    field = harmonic_field(grid, free, goal)
    start = grid.centre(np.array([48, 0]))
    assert np.exp(field.log_u[48, 0]) == 0
    assert np.linalg.norm(direction(field, start)) == pytest.approx(1)
    way = streamline(field, start, 0.02, 200.0)
    assert way.reached
    assert_stays_connected(field, way.points)


def test_direction_is_the_same_all_along_a_channel_beyond_double_precision():
    """There u is one sine mode across, which decays by a factor per column."""
    free, goal = channel(3, 1500)
    field = harmonic_field(JointGrid((0.0, 0.0), (0.3, 150.0), free.shape), free, goal)
    assert np.exp(field.log_u[1, 1000]) == 0
    for across in (0.04, 0.11, 0.19, 0.27):
        near, far = (direction(field, np.array([across, x])) for x in (20.03, 100.03))
        assert abs(near[0]) > 0.1
        np.testing.assert_allclose(far, near, atol=1e-3)


def test_points_are_a_step_apart():
    field = random_field(arm_grid(16, 12, 10), seed=1, blob=1.5)
    far = field.grid.centre(
        np.argwhere(field.log_u == field.log_u[field.connected].min())
    )
    for wanted in (0.03, 0.5):
        way = streamline(field, far[0], wanted, 60.0)
        step = min(wanted, 0.25 * field.grid.spacing.min())
        lengths = np.linalg.norm(np.diff(way.points, axis=0), axis=1)
        assert len(lengths) > 3
        np.testing.assert_allclose(lengths, step, rtol=1e-9)


def test_it_gives_up_at_its_longest_length():
    free, goal = channel(3, 40)
    field = harmonic_field(JointGrid((0.0, 0.0), (0.3, 4.0), free.shape), free, goal)
    start = np.array([0.15, 3.9])
    assert streamline(field, start, 0.01, 4.0).reached
    short = streamline(field, start, 0.01, 2.0)
    assert not short.reached
    assert len(short.points) == 201


def test_direction_is_the_gradient_in_angles_not_in_cells():
    """At a centre: (u_+ - u_-) / h of every joint, scaled to length 1."""
    grid = JointGrid((0.0, 0.0, 0.0), (2.0, 5.0, 9.0), (10, 10, 10))
    goal = np.zeros(grid.shape, bool)
    goal[7, 2, 8] = True
    field = harmonic_field(grid, ~goal, goal)
    u = np.exp(field.log_u)
    for cell in ((3, 5, 4), (6, 6, 1), (2, 8, 8)):
        gradient = np.array([d[cell] for d in np.gradient(u, *grid.spacing)])
        expected = gradient / np.linalg.norm(gradient)
        np.testing.assert_allclose(
            direction(field, grid.centre(np.array(cell))), expected, atol=1e-12
        )


def test_direction_is_of_length_1_wherever_u_rises():
    field = random_field(arm_grid(8, 8, 8, 8), seed=4, blob=1.0)
    rng = np.random.default_rng(0)
    for joints in rng.uniform(np.array(LOW) - 0.2, np.array(HIGH) + 0.2, (2000, 4)):
        length = np.linalg.norm(direction(field, joints))
        near = field.connected[tuple(field.grid.cell_of(joints))]
        assert length == pytest.approx(1) or (length == 0 and not near)


def test_direction_is_zero_far_from_all_that_is_connected():
    free = np.zeros((12, 12), bool)
    free[:3] = True
    goal = np.zeros_like(free)
    goal[0, 0] = True
    field = harmonic_field(JointGrid((0.0, 0.0), (1.2, 1.2), free.shape), free, goal)
    np.testing.assert_array_equal(direction(field, np.array([0.95, 0.5])), [0, 0])


def test_a_wall_between_is_not_crossed_at_a_corner():
    """Of two rooms with a common corner: the gradient points through it."""
    free = np.zeros((9, 9), bool)
    free[:4, :4] = True
    free[4:8, 4:] = True
    free[8, :] = True
    free[:, 0] = True
    goal = np.zeros_like(free)
    goal[3, 2] = True
    field = harmonic_field(JointGrid((0.0, 0.0), (9.0, 9.0), free.shape), free, goal)
    way = streamline(field, np.array([4.2, 4.2]), 0.1, 100.0)
    assert way.reached
    assert_stays_connected(field, way.points)
    crossed = (way.points < 4).all(axis=1) & (way.points > 3).all(axis=1)
    assert not crossed[: len(crossed) // 2].any()


@pytest.mark.parametrize(
    ("joints", "step", "length", "named"),
    [
        ((0.0, 0.0), 0.0, 1.0, "step"),
        ((0.0, 0.0), -0.1, 1.0, "-0.1"),
        ((0.0, 0.0), np.nan, 1.0, "step"),
        ((0.0, 0.0), 0.1, 0.0, "longest"),
        ((0.0, 0.0, 0.0), 0.1, 1.0, "2 finite angles"),
        ((0.0, np.nan), 0.1, 1.0, "2 finite angles"),
    ],
)
def test_bad_arguments_are_one_line(joints, step, length, named):
    field = random_field(arm_grid(8, 8), seed=1, blob=1.0)
    with pytest.raises(InvalidValue, match=named) as refusal:
        streamline(field, np.array(joints), step, length)
    assert "\n" not in str(refusal.value)
