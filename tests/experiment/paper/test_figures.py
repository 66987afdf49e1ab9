import cv2
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pytest
from synthetic import pair, sampled

from prospect_mj.experiment.paper import figures, pictures
from prospect_mj.experiment.paper.figure_tables import (
    STRATEGIES,
    actions_table,
    strategy_table,
)
from prospect_mj.experiment.paper.figures import Heading, Mark
from prospect_mj.experiment.paper.optimum import BySide, Optimum
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig

HEADING = Heading("Title", "mean of many", 400)


@pytest.fixture(scope="module")
def sample():
    return sampled(*pair())


@pytest.fixture(scope="module")
def made(sample):
    config = ReproduceConfig(runs=40)
    best = Optimum(BySide(2.0, 2.5), BySide(0.75, 1.0))
    found = pictures.published(sample, best, config, 10)
    return {picture.name: picture for picture in found}


def picture(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB).astype(int)


def pixels(image, colour):
    wanted = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return (np.abs(image - wanted).max(axis=-1) <= 3).sum()


def test_there_are_the_papers_four_figures(made):
    assert list(made) == ["figure_5a", "figure_5b", "figure_6a", "figure_6b"]
    for figure in made.values():
        assert picture(figure.png).shape == (675, 1200, 3)


def test_figure_5_tells_the_mean_in_its_band_over_the_optimum(sample, made):
    table = made["figure_5b"].table
    mean, low, high = (table[name].to_numpy() for name in ("actions", "low", "high"))
    np.testing.assert_allclose(mean, sample.mean.dominant.actions[0])
    assert (low <= mean).all()
    assert (mean <= high).all()
    assert (low < high).all()
    # In pretraining the lid lies to the right, afterwards to either side.
    assert table["optimum"].to_pylist() == [2.5] * 40 + [2.25] * 60
    assert made["figure_5a"].table["optimum"].to_pylist() == [2.25] * 100
    assert table["trial"].to_pylist() == list(range(0, 1000, 10))


def test_figure_6_tells_every_strategy_and_both_corrections_together(made):
    table = made["figure_6a"].table
    shares = {
        name: table.filter(pc.field("strategy") == name)["share"].to_numpy()
        for name in STRATEGIES
    }
    four = [shares[name] for name in ("optimal", "early", "late", "other")]
    np.testing.assert_allclose(np.sum(four, axis=0), 1)
    both = shares["early"] + shares["late"]
    np.testing.assert_allclose(shares["correction"], both)
    assert table.num_rows == 100 * len(STRATEGIES)


def test_figure_6_has_the_best_possible_share_as_a_line(made):
    # Easy trials have the lid to the right, the dominant hand's side.
    assert set(made["figure_6a"].table["optimum"].to_pylist()) == {1.0}
    table = made["figure_6b"].table
    assert set(table["optimum"].to_pylist()) == {0.75}
    image = picture(figures.strategies(table, HEADING))
    lower = pa.array(np.full(table.num_rows, 0.5))
    moved = table.set_column(table.column_names.index("optimum"), "optimum", lower)
    rows = np.flatnonzero((image != picture(figures.strategies(moved, HEADING))).any(2))
    height = np.unique(rows // image.shape[1])
    # The axis goes up to 1.2, and is drawn on 0.08 to 0.83 of the height.
    assert height.min() == pytest.approx((0.83 - 0.79 / 1.2 * 0.75) * 675, abs=25)


def test_there_are_no_difficult_trials_in_pretraining(made):
    assert pc.min(made["figure_6b"].table["trial"]).as_py() == 400
    assert pc.min(made["figure_6a"].table["trial"]).as_py() == 0


def test_every_strategy_is_drawn_in_its_colour(sample, made):
    image = picture(made["figure_6b"].png)
    for colour in figures._COLOURS.values():
        assert pixels(image, colour) > 200
    table = made["figure_6b"].table
    without = table.filter(pc.field("strategy") != "late")
    image = picture(figures.strategies(without, HEADING))
    assert pixels(image, figures._COLOURS["late"]) < 200


def test_a_figure_is_drawn_from_its_table_alone(sample):
    mean, many = sample.mean.baseline, sample.resampled.baseline
    table = actions_table(mean, many, np.full(100, 2.0))
    draw = [figures.actions(table, HEADING, 10, []) for _ in range(2)]
    assert draw[0] == draw[1]
    higher = table.set_column(1, "actions", pc.add(table["actions"], 0.5))
    assert figures.actions(higher, HEADING, 10, []) != draw[0]


def test_marks_are_drawn_where_the_paper_says(sample):
    mean, many = sample.mean.baseline, sample.resampled.baseline
    table = actions_table(mean, many, np.full(100, 2.0))
    plain = picture(figures.actions(table, HEADING, 10, []))
    marked = picture(figures.actions(table, HEADING, 10, [Mark(600, 8.0, "here")]))
    rows, columns = np.nonzero((plain != marked).any(axis=-1))
    height, width = plain.shape[:2]
    # The axes span about 0.06 to 0.97 of the width, and 0.08 to 0.9 of the height.
    assert columns.min() == pytest.approx((0.06 + 0.6 * 0.91) * width, abs=30)
    assert rows.max() == pytest.approx((0.9 - 8 / 11 * 0.82) * height, abs=30)


def test_a_set_without_such_a_trial_in_one_resample_is_left_out():
    mean, many = np.full((1, 4, 3), 0.25), np.full((5, 4, 3), 0.25)
    many[2, :, 1] = np.nan
    table = strategy_table(mean, many, 1.0)
    assert set(table["trial"].to_pylist()) == {0, 20}
