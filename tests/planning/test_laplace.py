from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from maps import baffles, channel, random_map, serpentine, unequal_ways
from scipy import ndimage, sparse
from scipy.sparse.linalg import spsolve

from prospect_mj.errors import InvalidValue
from prospect_mj.planning import relaxation
from prospect_mj.planning.harmonic_field import harmonic_field
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.laplace import SolverSettings, solve
from prospect_mj.planning.settings import PlannerSettings

PLANNING = PlannerSettings().solver
TIGHT = SolverSettings(tolerance=1e-12)
SMALLEST_DOUBLE = np.log(5e-324)


def neighbours(values, wall):
    """Values of the 2 n neighbours (n, 2, *shape), with `wall` outside of the grid."""
    padded = np.pad(values, 1, constant_values=wall)
    found = []
    for axis in range(values.ndim):
        for first in (0, 2):
            cut = [slice(1, -1)] * values.ndim
            cut[axis] = slice(first, first + values.shape[axis])
            found.append(padded[tuple(cut)])
    return np.reshape(found, (values.ndim, 2, *values.shape))


def weights(spacing):
    """Of the neighbours along each axis, for all 2 n of them to add up to 1."""
    return spacing**-2.0 / np.sum(2 * spacing**-2.0)


def log_equation_error(log_u, goal, spacing):
    """Largest |log u_i - log sum_j w_j u_j|, with logarithms all the way."""
    shares = np.log(weights(spacing)).reshape(-1, 1, *[1] * log_u.ndim)
    with np.errstate(invalid="ignore"):
        terms = neighbours(log_u, -np.inf) + shares
        mean = np.logaddexp.reduce(terms.reshape(-1, *log_u.shape), axis=0)
        return np.nanmax(np.abs(mean - log_u)[np.isfinite(log_u) & ~goal])


def direct_log_u(free, goal, spacing):
    """The same equation by sparse elimination, on the cells connected to a goal."""
    labels, _ = ndimage.label(free | goal)
    open_cells = np.isin(labels, labels[goal])
    index = np.where(open_cells, np.arange(free.size).reshape(free.shape), -1)
    matrix = sparse.identity(free.size, format="lil")
    unknown = (open_cells & ~goal).ravel()
    for axis, pair in enumerate(neighbours(index, -1)):
        for others in pair.reshape(2, -1):
            at = np.flatnonzero(unknown & (others >= 0))
            matrix[at, others[at]] = -weights(spacing)[axis]
    u = spsolve(matrix.tocsc(), goal.ravel().astype(float))
    with np.errstate(divide="ignore"):
        return np.log(u).reshape(free.shape)


def assert_no_interior_extremum(log_u, goal):
    inside = np.isfinite(log_u) & ~goal
    around = neighbours(log_u, -np.inf).reshape(-1, *log_u.shape)
    assert (log_u[goal] == 0).all()
    assert (log_u[inside] < 0).all()
    assert (around.max(axis=0) > log_u)[inside].all()
    assert (around.min(axis=0) < log_u)[inside].all()


@pytest.mark.parametrize("spacing", [(1.0, 1.0), (1.0, 3.0), (0.3, 0.1)])
def test_a_box_with_one_side_as_goal_is_its_discrete_sine_series(spacing):
    """u(i, j) = sum_k b_k sin(k pi i / (n+1)) sinh(a_k (m-j)) / sinh(a_k m)."""
    n, m = 14, 20
    log_u, _, converged = solve(*channel(n, m), np.array(spacing), TIGHT)
    k = np.arange(1, n + 1)
    ratio = (spacing[1] / spacing[0]) ** 2
    decay = np.arccosh(1 + ratio * (1 - np.cos(k * np.pi / (n + 1))))
    modes = np.sin(np.outer(k, k) * np.pi / (n + 1))
    coefficients = 2 / (n + 1) * modes.sum(axis=0)
    along = np.arange(m)[:, None]
    # sinh(a (m-j)) / sinh(a m) without overflow.
    fall = np.exp(-decay * along) * (1 - np.exp(-2 * decay * (m - along)))
    fall /= 1 - np.exp(-2 * decay * m)
    expected = modes @ (coefficients * fall).T
    assert converged
    np.testing.assert_allclose(log_u, np.log(expected), atol=1e-9)


def test_an_annulus_is_the_logarithm_of_its_radius():
    """To within what half a cell more or less of either radius makes."""
    n, inner, outer = 121, 10.0, 58.0
    x = np.arange(n) - n // 2
    radius = np.hypot(x[:, None], x)
    goal = radius <= inner
    log_u, *_ = solve(radius < outer, goal, np.ones(2), TIGHT)
    between = (radius > inner + 3) & (radius < outer - 6)
    expected = np.log(outer / radius[between]) / np.log(outer / inner)
    np.testing.assert_allclose(np.exp(log_u[between]), expected, atol=0.02)


@pytest.mark.parametrize(
    ("shape", "spacing"),
    [
        ((30, 25), (1.0, 1.0)),
        ((30, 25), (0.1, 0.35)),
        ((9, 10, 8), (1.0, 1.0, 1.0)),
        ((9, 10, 8), (0.3, 0.2, 0.5)),
        ((5, 6, 5, 4), (0.32, 0.25, 0.35, 0.25)),
    ],
)
@pytest.mark.parametrize("seed", range(3))
def test_agrees_with_a_direct_sparse_solve(shape, spacing, seed):
    spacing = np.array(spacing)
    free, goal = random_map(np.random.default_rng(seed), shape, share=0.7)
    log_u, *_ = solve(free, goal, spacing, TIGHT)
    expected = direct_log_u(free, goal, spacing)
    np.testing.assert_array_equal(np.isfinite(log_u), np.isfinite(expected))
    np.testing.assert_allclose(log_u, expected, atol=1e-8)


@pytest.mark.parametrize("spacing", [(1.0, 1.0), (0.2, 0.5)])
def test_agrees_with_a_direct_sparse_solve_behind_two_baffles(spacing):
    free, goal = baffles(24)
    log_u, *_ = solve(free, goal, np.array(spacing), TIGHT)
    expected = direct_log_u(free, goal, np.array(spacing))
    assert log_u[-1, -1] < np.log(1e-11)
    np.testing.assert_allclose(log_u, expected, atol=1e-8)


@settings(max_examples=60, deadline=None)
@given(
    n_joints=st.integers(2, 4),
    seed=st.integers(0, 2**32 - 1),
    blob=st.floats(0.4, 2.0),
    share=st.floats(0.3, 1.0),
    n_goals=st.integers(1, 6),
)
def test_no_extremum_but_on_the_boundary(n_joints, seed, blob, share, n_goals):
    """At the tolerance that planning uses."""
    shape = {2: (24, 17), 3: (9, 12, 8), 4: (8, 6, 7, 8)}[n_joints]
    rng = np.random.default_rng(seed)
    free, goal = random_map(rng, shape, blob, share, n_goals)
    spacing = rng.uniform(0.1, 0.4, n_joints)
    log_u, _, converged = solve(free, goal, spacing, PLANNING)
    assert converged
    assert_no_interior_extremum(log_u, goal)


@pytest.mark.parametrize("seed", range(2))
def test_no_extremum_on_a_grid_for_planning(seed):
    free, goal = random_map(np.random.default_rng(seed), (16,) * 4, 1.0 + seed)
    spacing = np.array([0.32, 0.25, 0.35, 0.25])
    log_u, sweeps, converged = solve(free, goal, spacing, PLANNING)
    assert converged
    assert sweeps < 50
    assert_no_interior_extremum(log_u, goal)


@pytest.mark.parametrize(
    ("mantissa", "exponent", "expected"),
    [
        ([0.0, 1.0, 0.3, 0.1, 0.01], [0, 0, 0, 0, 0], False),
        ([0.0, 1.0, 0.3, 0.1, 0.2], [0, 0, 0, 0, 0], True),
        ([0.0, 1.0, 0.3, 0.3, 0.1], [0, 0, 0, 0, 0], True),
        ([0.0, 1.0, 0.3, 9.0, 0.1], [0, 0, 0, -1, -1], False),
        ([0.0, 1.0, 0.3, 0.1, 9.0], [0, 0, 0, -1, -1], True),
        ([0.0, 1.0, 1.0, 0.3, 0.1], [0, 0, 0, 0, 0], True),
    ],
)
def test_a_planted_maximum_is_found(mantissa, exponent, expected):
    """In a row: wall, goal, three unknowns, wall; equal neighbours are no way up."""
    neighbours_in_row = np.array([[0, 0], [0, 2], [1, 3], [2, 4], [3, 0]], np.int32)
    values = np.array(mantissa), np.array(exponent, np.int32)
    assert relaxation.has_maximum(1, neighbours_in_row, *values) == expected


def test_gradient_outlives_the_form_with_goal_0():
    """p ~ e^(-pi L/w): 13 widths away from the goal all cells are equal in 1 - p."""
    width = 9
    far = 13 * (width + 1)
    log_u, *_ = solve(*channel(width, far + 20), np.ones(2), TIGHT)
    p = np.exp(log_u[width // 2])
    assert (1 - p)[far] == (1 - p)[far - 1] == 1
    decay = np.diff(log_u[width // 2])
    assert (decay[width:] < -0.9 * np.pi / (width + 1)).all()


def test_decay_outlives_double_precision():
    """One cell wide: 4 u_i = u_(i-1) + u_(i+1), so u falls by 2 - sqrt(3) per cell."""
    log_u = solve(*channel(1, 5000), np.ones(2), TIGHT).log_u[0]
    decay = np.log(2 - np.sqrt(3))
    assert np.exp(log_u[600]) == 0
    assert log_u[-1] < 8 * SMALLEST_DOUBLE
    cells = np.arange(4980)
    np.testing.assert_allclose(log_u[:4980], decay * cells, rtol=1e-12, atol=1e-9)


@pytest.mark.parametrize(
    ("free", "goal"), [serpentine(49), unequal_ways(700), channel(9, 900), baffles(60)]
)
@pytest.mark.parametrize("spacing", [(1.0, 1.0), (1.0, 2.0)])
def test_the_equation_holds_in_logarithms_whatever_the_range(free, goal, spacing):
    spacing = np.array(spacing)
    log_u, _, converged = solve(free, goal, spacing, TIGHT)
    assert converged
    assert log_equation_error(log_u, goal, spacing) < 1e-9


@pytest.mark.parametrize("over_relaxation", [1.0, 1.3, 1.7, 1.95])
@pytest.mark.parametrize(("free", "goal"), [channel(9, 300), baffles(30)])
def test_over_relaxation_changes_the_sweeps_and_not_the_solution(
    free, goal, over_relaxation
):
    """1.9 and more circle around the solution in a channel until they are reduced."""
    other = SolverSettings(over_relaxation, TIGHT.tolerance)
    expected, _, converged = solve(free, goal, np.ones(2), TIGHT)
    log_u, _, also = solve(free, goal, np.ones(2), other)
    assert converged
    assert also
    np.testing.assert_allclose(log_u, expected, atol=1e-8)


def test_a_fast_decay_is_not_over_relaxed():
    """One cell wide, 1.5 everywhere would amplify errors from cell to cell."""
    assert solve(*channel(1, 400), np.ones(2)).sweeps < 30


def test_while_a_maximum_is_left_it_has_not_converged(monkeypatch):
    monkeypatch.setattr(relaxation, "has_maximum", lambda *_: True)
    _, sweeps, converged = solve(
        *baffles(12), np.ones(2), SolverSettings(max_sweeps=90)
    )
    assert (sweeps, converged) == (90, False)


def test_a_test_of_the_residual_would_stop_too_early():
    """Far from the goal both u and its residual are small, whatever u is."""
    free, goal = channel(9, 400)
    exact = solve(free, goal, np.ones(2), TIGHT).log_u
    early = solve(free, goal, np.ones(2), SolverSettings(max_sweeps=200))
    u = np.exp(early.log_u)
    mean = 0.25 * neighbours(u, 0.0).sum(axis=(0, 1))
    assert np.abs(mean - u)[~goal].max() < 1e-15
    assert np.abs(early.log_u - exact).max() > 1
    assert not early.converged
    late = solve(free, goal, np.ones(2))
    assert late.converged
    assert np.abs(late.log_u - exact).max() < 0.05


def test_only_what_is_connected_to_a_goal_has_a_value():
    free, goal = random_map(np.random.default_rng(5), (40, 40), share=0.45)
    labels, n_parts = ndimage.label(free)
    connected = np.isin(labels, labels[goal])
    assert n_parts > 3
    assert 0 < connected.sum() < free.sum()
    log_u, *_ = solve(free, goal, np.ones(2))
    np.testing.assert_array_equal(np.isfinite(log_u), connected)
    assert (log_u[~connected] == -np.inf).all()


def test_more_goals_are_nearer():
    rng = np.random.default_rng(2)
    free, goal = random_map(rng, (8, 9, 7), share=0.8, n_goals=4)
    both, *_ = solve(free, goal, np.ones(3), TIGHT)
    for cells in pairwise([0, 1, 3, 4]):
        some = np.zeros_like(goal)
        some.flat[np.flatnonzero(goal)[slice(*cells)]] = True
        fewer, *_ = solve(free, some, np.ones(3), TIGHT)
        inside = np.isfinite(fewer) & ~goal
        assert (both[inside] > fewer[inside]).all()


def test_a_mirrored_map_has_the_mirrored_solution():
    free, goal = random_map(np.random.default_rng(3), (12, 15, 9), share=0.7)
    spacing = np.array([0.2, 0.3, 0.4])
    log_u, *_ = solve(free, goal, spacing, TIGHT)
    turned, *_ = solve(free.T[::-1], goal.T[::-1], spacing[::-1], TIGHT)
    np.testing.assert_allclose(turned, log_u.T[::-1], atol=1e-9)


def test_a_goal_in_an_obstacle_counts_and_what_goals_enclose_is_as_good():
    goal = np.zeros((7, 7), bool)
    goal[1:6, 1:6] = True
    goal[2:5, 2:5] = False
    free = ~goal
    log_u, _, converged = solve(free, goal, np.ones(2), TIGHT)
    assert converged
    np.testing.assert_allclose(log_u[1:6, 1:6], 0, atol=1e-10)


@pytest.mark.parametrize(
    "bad",
    [
        {"over_relaxation": 0.9},
        {"over_relaxation": 2.0},
        {"over_relaxation": np.nan},
        {"tolerance": 0.0},
        {"tolerance": 1.0},
        {"max_sweeps": 0},
        {"max_sweeps": 1.5},
    ],
)
def test_bad_settings_are_one_line(bad):
    with pytest.raises(InvalidValue, match=str(*bad.values())) as refusal:
        SolverSettings(**bad)
    assert "\n" not in str(refusal.value)


def test_bad_masks_are_one_line():
    grid = JointGrid((0.0, 0.0), (1.0, 1.0), (4, 5))
    free = np.ones(grid.shape, bool)
    with pytest.raises(InvalidValue, match="goal cells"):
        harmonic_field(grid, free, np.zeros_like(free))
    with pytest.raises(InvalidValue, match=r"\(5, 4\)"):
        harmonic_field(grid, free.T, free)
    with pytest.raises(InvalidValue, match="int64"):
        harmonic_field(grid, free, free.astype(np.int64))


def test_a_field_is_a_solution_on_a_grid():
    grid = JointGrid((-1.0, 0.0), (1.0, 3.0), (10, 12))
    free, goal = random_map(np.random.default_rng(1), grid.shape, share=0.6)
    field = harmonic_field(grid, free, goal)
    log_u, sweeps, converged = solve(free, goal, grid.spacing)
    np.testing.assert_array_equal(field.log_u, log_u)
    np.testing.assert_array_equal(field.connected, np.isfinite(log_u))
    assert (field.sweeps, field.converged) == (sweeps, converged)
