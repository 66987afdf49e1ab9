"""The picture of several learning curves, by what is drawn."""

import numpy as np
import pytest

from prospect_mj.experiment.estimate import band_of_few
from prospect_mj.experiment.seeds import curves_figure
from prospect_mj.experiment.seeds.curves_figure import learning_curves


def runs(n_runs=5, n_trials=100):
    return np.random.default_rng(4).integers(2, 11, (n_runs, n_trials))


@pytest.fixture
def drawn(monkeypatch):
    """What `_draw` is given, part by part."""
    parts = []
    draw = curves_figure._draw

    def remembering(axes, *given):
        parts.append(given)
        draw(axes, *given)

    monkeypatch.setattr(curves_figure, "_draw", remembering)
    return parts


def test_equal_runs_give_equal_bytes():
    picture = learning_curves(runs(), 0, 10)
    assert picture.startswith(b"\x89PNG")
    assert learning_curves(runs(), 0, 10) == picture


def test_curves_are_of_sets_of_ten_trials(drawn):
    n_actions = runs()
    learning_curves(n_actions, 0, 10)
    ((middles, curves, bounds),) = drawn
    np.testing.assert_array_equal(middles, np.arange(5, 100, 10))
    np.testing.assert_allclose(curves, n_actions.reshape(5, 10, 10).mean(axis=2))
    mean = curves.mean(axis=0)
    assert (bounds[0] < mean).all()
    assert (mean < bounds[1]).all()


def test_the_band_is_that_of_a_mean(drawn):
    learning_curves(runs(40), 0, 10)
    ((_, curves, bounds),) = drawn
    reach = 1.96 * curves.std(axis=0) / np.sqrt(len(curves))
    np.testing.assert_allclose((bounds[1] - bounds[0]) / 2, reach, rtol=0.06)


def test_the_band_of_few_covers_the_mean_as_often_as_it_says():
    values = np.random.default_rng(1).normal(size=(4, 4000))
    low, high = band_of_few(values)
    assert np.mean((low < 0) & (high > 0)) == pytest.approx(0.95, abs=0.015)


def test_no_line_leads_from_pretraining_to_what_follows(drawn):
    learning_curves(runs(), 40, 10)
    ends = [(middles[0], middles[-1]) for middles, *_ in drawn]
    assert ends == [(5, 35), (45, 95)]


@pytest.mark.parametrize("shape", [(1, 100), (1, 1), (3, 7), (2, 49)])
def test_few_runs_and_short_ones_can_be_drawn(shape, drawn):
    learning_curves(runs(*shape), 0, 10)
    assert sum(len(middles) for middles, *_ in drawn) == (
        10 if shape[1] == 100 else shape[1]
    )
