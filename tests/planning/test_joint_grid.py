import tracemalloc

import numpy as np
import pytest

from prospect_mj.errors import InvalidValue
from prospect_mj.planning.joint_grid import JointGrid, machine_memory
from prospect_mj.planning.laplace import SolverSettings, bytes_needed, solve

GRID = JointGrid((-2.6, -2.0, -0.9), (2.6, 2.0, 3.1), (4, 5, 8))


def test_centres_tile_the_box():
    np.testing.assert_allclose(GRID.spacing, [1.3, 0.8, 0.5])
    np.testing.assert_allclose(GRID.centres(0), [-1.95, -0.65, 0.65, 1.95])
    for axis in range(GRID.n_joints):
        centres = GRID.centres(axis)
        half = GRID.spacing[axis] / 2
        np.testing.assert_allclose(centres[0] - half, GRID.low[axis])
        np.testing.assert_allclose(centres[-1] + half, GRID.high[axis])


def test_all_centres_are_in_the_order_of_a_flat_array():
    assert (GRID.n_joints, GRID.shape, GRID.size) == (3, (4, 5, 8), 160)
    index = np.array(np.unravel_index(np.arange(GRID.size), GRID.shape)).T
    np.testing.assert_array_equal(GRID.all_centres(), GRID.centre(index))
    np.testing.assert_array_equal(GRID.cell_of(GRID.all_centres()), index)


def test_coordinates_are_the_inverse_of_centres():
    joints = np.random.default_rng(0).uniform(GRID.low, GRID.high, (50, 3))
    np.testing.assert_allclose(GRID.centre(GRID.coordinates(joints)), joints)
    nearest = GRID.centre(GRID.cell_of(joints))
    assert (np.abs(nearest - joints) <= GRID.spacing / 2 + 1e-12).all()


def test_what_lies_outside_belongs_to_the_nearest_cell():
    outside = np.array([-9.0, 0.0, 9.0])
    np.testing.assert_array_equal(GRID.cell_of(outside), [0, 2, 7])


@pytest.mark.parametrize(
    ("low", "high", "cells", "named"),
    [
        ((0.0,), (1.0, 2.0), (4, 4), r"\(1, 2, 2\)"),
        ((), (), (), r"\(0, 0, 0\)"),
        ((0.0, 0.0), (1.0, 1.0), (4, 1), r"\(4, 1\)"),
        ((0.0, 0.0), (1.0, 1.0), (4, 2.5), r"\(4, 2.5\)"),
        ((0.0, 1.0), (1.0, 1.0), (4, 4), "low < high"),
        ((0.0, -np.inf), (1.0, 1.0), (4, 4), "finite"),
    ],
)
def test_a_grid_that_is_none_is_refused_in_one_line(low, high, cells, named):
    with pytest.raises(InvalidValue, match=named) as refusal:
        JointGrid(low, high, cells)
    assert "\n" not in str(refusal.value)


def test_too_large_a_grid_is_refused_with_its_bytes_before_it_is_made():
    grid = JointGrid((-1.0,) * 7, (1.0,) * 7, (64,) * 7)
    assert grid.bytes_needed > 64**7 * 8 > machine_memory()
    tracemalloc.start()
    with pytest.raises(InvalidValue, match=str(grid.bytes_needed)) as refusal:
        grid.check_memory()
    assert tracemalloc.get_traced_memory()[1] < 100_000
    tracemalloc.stop()
    assert "\n" not in str(refusal.value)


def test_the_limit_is_a_setting():
    GRID.check_memory(GRID.bytes_needed)
    with pytest.raises(InvalidValue, match=f"at most {GRID.bytes_needed - 1}"):
        GRID.check_memory(GRID.bytes_needed - 1)


@pytest.mark.parametrize("shape", [(300, 300), (16,) * 4])
def test_the_bytes_are_those_that_the_solver_takes(shape):
    free, goal = np.ones(shape, bool), np.zeros(shape, bool)
    goal.flat[0] = True
    settings = SolverSettings(max_sweeps=1)
    solve(free, goal, np.ones(len(shape)), settings)
    tracemalloc.start()
    solve(free, goal, np.ones(len(shape)), settings)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert 0.8 * bytes_needed(shape) < peak <= bytes_needed(shape)
