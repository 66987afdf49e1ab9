import numpy as np
import pytest
from matplotlib.figure import Figure

from prospect_mj.experiment.paper.figures.direct_labels import (
    Named,
    best_place,
    write_names,
)

FRAME = np.array([0.0, 0.0, 800.0, 400.0])
HALF = np.array([60.0, 10.0])
NO_GRID = np.empty(0)
X = np.linspace(0, 800, 161)
NEAR, FAR = 6.0, 30.0


def line(heights):
    return np.column_stack([X, np.broadcast_to(heights, X.shape)])


def distance(centre, points, half=HALF):
    """Of a box from the nearest point."""
    away = np.maximum(np.abs(points - centre) - half, 0)
    return np.hypot(*away.T).min()


def test_a_name_stands_at_its_own_line_on_the_side_away_from_the_other():
    own, other = line(200.0), line(240.0)
    place = best_place(FRAME, NO_GRID, HALF, own, other)
    assert place[1] < 200
    assert NEAR <= distance(place, own) < NEAR + 5
    assert np.array_equal(place, best_place(FRAME, NO_GRID, HALF, own, other))


def test_it_stands_where_only_its_own_line_goes():
    own, other = line(200.0), line(200.0 + 150 * np.tanh((X - 400) / 100))
    bump = line(200.0 - 150 * np.tanh((X - 400) / 100))
    place = best_place(FRAME, NO_GRID, HALF, own, np.concatenate([other, bump]))
    assert not 300 < place[0] < 500
    assert distance(place, own) < FAR < distance(place, other)


@pytest.mark.parametrize("seed", range(5))
def test_it_is_clear_of_all_curves_and_of_the_grid(seed):
    rng = np.random.default_rng(seed)
    turns = rng.uniform(20, 380, (3, 6))
    at = np.linspace(0, 800, 6)
    own, *others = (line(np.interp(X, at, heights)) for heights in turns)
    grid = np.arange(0.0, 401.0, 80.0)
    place = best_place(FRAME, grid, HALF, own, np.concatenate(others))
    for points in (own, *others):
        assert distance(place, points) >= NEAR
    assert np.abs(place[1] - grid).min() > HALF[1]
    assert (FRAME[:2] < place - HALF).all()
    assert (place + HALF < FRAME[2:]).all()


def test_a_grid_too_dense_for_the_name_is_ignored():
    grid = np.arange(0.0, 401.0, 10.0)
    own = line(200.0)
    place = best_place(FRAME, grid, HALF, own, line(390.0))
    assert NEAR <= distance(place, own) < NEAR + 5


def test_names_in_a_figure_keep_clear_of_each_other_and_of_the_lines():
    axes = Figure(figsize=(8, 4), layout="constrained").add_subplot()
    axes.set(xlim=(0, 10), ylim=(0, 1))
    ends = np.array([[0.0, 0.5], [10.0, 0.5]])
    curves = [Named(name, "black", [ends]) for name in ("one", "two", "three")]
    write_names(axes, curves, [ends + [0, 0.1]])
    axes.figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in axes.texts]
    assert [text.get_text() for text in axes.texts] == ["one", "two", "three"]
    for number, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:number])
        low, high = axes.transData.transform([[0, 0.5], [0, 0.6]])[:, 1]
        assert not any(box.y0 <= height <= box.y1 for height in (low, high))
