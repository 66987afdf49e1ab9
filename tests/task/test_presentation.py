"""How the jar is presented: bounds, spread and independence of the draws."""

import numpy as np
import pytest

from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.task.presentation import (
    ORIENTATIONS,
    PresentationSettings,
    checked_orientation,
    draw_presentation,
)

NOMINAL = np.array([0.62, 0.0, 0.20])
BOUNDS = np.array([0.02, 0.02, 0.01, np.deg2rad(10), 0.10])
"""x, y, z [m], yaw [rad], lamp: half widths."""


def draws(n, settings=None, seed=0):
    """(n, 5) deviations from the nominal presentation."""
    rng = np.random.default_rng(seed)
    settings = PresentationSettings() if settings is None else settings
    rows = []
    for _ in range(n):
        drawn = draw_presentation(settings, NOMINAL, "left", rng)
        place = drawn.placement
        rows.append([*(place.position - NOMINAL), place.yaw, drawn.lamp_gain - 1.0])
    return np.array(rows)


def test_presentations_are_uniform_within_their_bounds():
    """4000 draws: never outside, near the edges, and with a uniform's moments."""
    rows = draws(4000) / BOUNDS
    assert np.abs(rows).max() <= 1.0
    assert (rows.max(axis=0) > 0.99).all()
    assert (rows.min(axis=0) < -0.99).all()
    # Standard errors: 1/sqrt(3 n) = 0.009 of the mean, 0.005 of the variance.
    assert np.abs(rows.mean(axis=0)).max() < 0.04
    assert rows.var(axis=0) == pytest.approx(np.full(5, 1 / 3), abs=0.02)


def test_the_deviations_are_independent():
    correlation = np.corrcoef(draws(4000).T) - np.eye(5)
    assert np.abs(correlation).max() < 0.07


def test_the_same_seed_draws_the_same_presentations():
    assert np.array_equal(draws(5, seed=3), draws(5, seed=3))
    assert not np.array_equal(draws(5, seed=3), draws(5, seed=4))


@pytest.mark.parametrize("orientation", ORIENTATIONS)
def test_the_orientation_is_the_side_of_the_lid(orientation):
    rng = np.random.default_rng(0)
    drawn = draw_presentation(PresentationSettings(), NOMINAL, orientation, rng)
    assert drawn.orientation == orientation
    assert drawn.placement.lid_left == (orientation == "left")


def test_both_orientations_are_presented_at_the_same_places():
    pair = [
        draw_presentation(
            PresentationSettings(), NOMINAL, orientation, np.random.default_rng(9)
        )
        for orientation in ORIENTATIONS
    ]
    assert np.array_equal(pair[0].placement.position, pair[1].placement.position)
    assert pair[0].placement.yaw == pair[1].placement.yaw
    assert pair[0].lamp_gain == pair[1].lamp_gain


def test_without_spread_every_presentation_is_nominal():
    none = PresentationSettings(across=0, height=0, yaw=0, lamp=0)
    assert not draws(3, none).any()


@pytest.mark.parametrize(
    "bad",
    [
        {"across": -0.01},
        {"across": 0.5},
        {"height": 0.05},
        {"yaw": -0.1},
        {"yaw": 3.0},
        {"lamp": 1.0},
        {"lamp": -0.1},
        {"across": float("nan")},
    ],
)
def test_absurd_spreads_are_refused_by_name(bad):
    (name,) = bad
    with pytest.raises(InvalidValue, match=name):
        PresentationSettings(**bad)


@pytest.mark.parametrize("bad", ["", "up", "LEFT", None, 0])
def test_unknown_orientations_are_refused_with_the_known_ones(bad):
    with pytest.raises(InvalidChoice, match="valid: left, right"):
        checked_orientation(bad)
