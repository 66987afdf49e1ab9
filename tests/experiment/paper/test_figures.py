import itertools
from types import SimpleNamespace

import cv2
import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pytest
from synthetic import improving, pair, sampled

from prospect_mj.experiment.paper.figures import (
    actions_figure,
    captions,
    figure_frame,
    pictures,
)
from prospect_mj.experiment.paper.figures.actions_figure import Mark
from prospect_mj.experiment.paper.figures.figure_frame import Heading
from prospect_mj.experiment.paper.figures.figure_tables import (
    STRATEGIES,
    actions_table,
    strategy_table,
)
from prospect_mj.experiment.paper.figures.strategy_figure import LOOKS
from prospect_mj.experiment.paper.live.live_check import SCHEMA as LIVE_SCHEMA
from prospect_mj.experiment.paper.reproduce_config import ReproduceConfig
from prospect_mj.experiment.populations.optimum import BySide, Optimum
from prospect_mj.experiment.populations.scenario import Scenario

HEADING = Heading("Title", "mean of many")
SWITCHED = Heading("Title", "mean of many", 400)
BEST = Optimum(
    actions=BySide(2.0, 2.5), exploring=BySide(2.1, 2.6), optimal=BySide(0.75, 1.0)
)

# Machado, Oliveira and Fernandes (2009), "A physiologically-based model for simulation
# of color vision deficiency", severity 1.0: linear RGB as the colour-blind see it.
COLOUR_BLIND = {
    "deuteranopia": [
        [0.367322, 0.860646, -0.227968],
        [0.280085, 0.672501, 0.047413],
        [-0.011820, 0.042940, 0.968881],
    ],
    "protanopia": [
        [0.152286, 1.052583, -0.204868],
        [0.114503, 0.786281, 0.099216],
        [-0.003882, -0.048116, 1.051998],
    ],
    "tritanopia": [
        [1.255528, -0.076749, -0.178779],
        [-0.078411, 0.930809, 0.147602],
        [0.004733, 0.691367, 0.303900],
    ],
    "none": np.eye(3),
}


@pytest.fixture(scope="module")
def sample():
    return sampled(*pair())


@pytest.fixture(scope="module")
def made(sample):
    found = pictures.published(sample, BEST, ReproduceConfig(runs=40), 10)
    return {picture.name: picture for picture in found}


def picture(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB).astype(int)


def draw(table, heading, marks):
    return actions_figure.actions(table, heading, 10, marks, 2.1)


def rgb(colour):
    return np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])


def mask(image, colour):
    return np.abs(image - rgb(colour)).max(axis=-1) <= 3


def panels(image):
    """The axes, found by their black spines: left, right, and (top, bottom) of each."""
    black = image.max(axis=-1) < 50
    left = int(black.sum(axis=0).argmax())
    bottoms = np.flatnonzero(black[:, left + 2 :].mean(axis=1) > 0.8)
    bottoms = [row for row in bottoms if row + 1 not in bottoms]
    right = int(np.flatnonzero(black[bottoms[0]]).max())
    rows = []
    for bottom in bottoms:
        top = bottom
        while black[top - 1, left]:
            top -= 1
        rows.append((int(top), int(bottom)))
    return left, right, rows


def height_of(row, panel, limit):
    """What a row of pixels stands for on an axis from 0 to a limit."""
    top, bottom = panel
    return limit * (bottom - row) / (bottom - top)


def test_there_are_the_papers_four_figures_as_wide_as_each_other(made):
    assert list(made) == list(captions.FIGURES)
    shapes = [picture(figure.png).shape for figure in made.values()]
    assert [shape[1] for shape in shapes] == [1200] * 4


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


def test_the_floor_is_drawn_where_the_optimum_is(made):
    image = picture(made["figure_5a"].png)
    _, _, (panel,) = panels(image)
    row = mask(image, figure_frame.INK).sum(axis=1).argmax()
    assert height_of(row, panel, 10) == pytest.approx(2.25, abs=0.05)


def test_figure_6_has_the_best_possible_share_as_a_line(made):
    # Easy trials have the lid to the right, the dominant hand's side.
    assert set(made["figure_6a"].table["optimum"].to_pylist()) == {1.0}
    table = made["figure_6b"].table
    assert set(table["optimum"].to_pylist()) == {0.75}
    image = picture(made["figure_6b"].png)
    row = mask(image, figure_frame.INK).sum(axis=1).argmax()
    assert height_of(row, panels(image)[2][0], 1.09) == pytest.approx(0.75, abs=0.005)


def test_figure_6b_has_the_axis_of_the_others_and_begins_after_the_pretraining(made):
    table = made["figure_6b"].table
    assert pc.min(table["trial"]).as_py() == 400
    image = picture(made["figure_6b"].png)
    left, right, _ = panels(image)
    drawn = np.flatnonzero(mask(image, LOOKS["late"].colour).any(axis=0))
    assert (drawn.min() - left) / (right - left) == pytest.approx(0.4, abs=0.02)
    assert drawn.max() > right - 0.02 * (right - left)


def test_pretraining_is_shaded_where_it_is(made):
    assert pc.min(made["figure_6a"].table["trial"]).as_py() == 0
    for name in ("figure_5b", "figure_6a", "figure_6b"):
        image = picture(made[name].png)
        left, right, _ = panels(image)
        shaded = np.flatnonzero(mask(image, figure_frame.SHADE).sum(axis=0) > 20)
        end = (shaded.max() - left) / (right - left)
        assert end == pytest.approx(0.4, abs=0.005)


def test_every_strategy_is_drawn_in_its_colour(made):
    for name in ("figure_6a", "figure_6b"):
        image = picture(made[name].png)
        for look in LOOKS.values():
            assert mask(image, look.colour).sum() > 1000


def test_a_figure_is_drawn_from_its_table_alone(sample):
    table = baseline(sample)
    once, again = (draw(table, HEADING, []) for _ in range(2))
    assert once == again
    higher = table.set_column(1, "actions", pc.add(table["actions"], 0.5))
    assert draw(higher, HEADING, []) != once


def baseline(sample):
    mean, many = sample.mean.baseline, sample.resampled.baseline
    return actions_table(mean, many, np.full(100, 2.0))


def marked(sample, mark):
    """Where a mark changes the picture, with the axes: columns, rows as shares."""
    table = baseline(sample)
    plain = picture(draw(table, HEADING, []))
    image = picture(draw(table, HEADING, [mark]))
    rows, columns = np.nonzero((plain != image).any(axis=-1))
    left, right, (panel,) = panels(image)
    return (columns - left) / (right - left), height_of(rows, panel, 10)


def test_what_the_paper_says_of_a_trial_has_no_height(sample):
    places, heights = marked(sample, Mark(600, ""))
    assert places == pytest.approx(0.6, abs=0.004)
    assert heights.min() < 0.1
    assert heights.max() > 9.9


def test_what_the_paper_says_was_exceeded_points_upwards_from_there(sample):
    places, heights = marked(sample, Mark(400, "", 6.0))
    assert heights.min() == pytest.approx(6.0, abs=0.1)
    assert heights.max() > 6.5
    # The middle of the set of ten that begins there.
    assert np.median(places) == pytest.approx(0.405, abs=0.004)


def test_a_mark_outside_of_the_axes_is_not_drawn(sample):
    table = baseline(sample)
    plain = draw(table, HEADING, [])
    assert draw(table, HEADING, [Mark(5000, "far off")]) == plain


def test_no_line_leads_from_one_task_to_the_next(sample):
    # Between the middles of the sets before and after the change.
    def blue(heading):
        image = picture(draw(baseline(sample), heading, []))
        left, right, ((top, bottom),) = panels(image)
        column = left + round(0.4 * (right - left))
        return mask(image[top:bottom], figure_frame.BLUE)[:, column].any()

    assert blue(HEADING)
    assert not blue(SWITCHED)


def live_table(away):
    trials = np.arange(0, 1000, 10)
    recorded = np.linspace(8, 2, 100)
    columns = {
        "trial": trials,
        "live": recorded + away,
        "recorded": recorded,
        "low": recorded - 0.5,
        "high": recorded + 0.5,
    }
    return pa.table(columns, schema=LIVE_SCHEMA)


def test_live_runs_are_shown_by_their_difference_too():
    image = picture(actions_figure.live(live_table(0.25), HEADING, 10, 2.0, 20))
    _, _, (above, below) = panels(image)
    drawn = mask(image, figure_frame.VERMILION)
    rows = np.flatnonzero(drawn[slice(*below)].sum(axis=1) > 500)
    # The axis shows the band, -0.5 to 0.5, with a margin of 5 % to either side.
    middle = height_of(rows.mean() + below[0], below, 1.1) - 0.55
    assert middle == pytest.approx(0.25, abs=0.02)
    falling = np.flatnonzero(drawn[slice(*above)].any(axis=1))
    assert np.ptp(falling) > 0.5 * np.ptp(above)


@pytest.mark.parametrize(("away", "outside"), [(0.4, False), (0.6, True)])
def test_sets_outside_of_the_band_are_ringed(away, outside):
    aways = np.zeros(100)
    calm = picture(actions_figure.live(live_table(aways), HEADING, 10, 2.0, 20))
    aways[50:53] = away
    image = picture(actions_figure.live(live_table(aways), HEADING, 10, 2.0, 20))
    # With rings the legend has one line more; without any, the panel above is calm
    # but for the line itself.
    left, right, (above, _) = panels(image)
    legend = slice(left + (right - left) * 6 // 10, right)
    changed = (image != calm)[slice(*above), legend].any()
    assert changed == outside


def test_a_set_without_such_a_trial_in_one_resample_is_left_out():
    mean, many = np.full((1, 4, 3), 0.25), np.full((5, 4, 3), 0.25)
    many[2, :, 1] = np.nan
    table = strategy_table(mean, many, 1.0)
    assert set(table["trial"].to_pylist()) == {0, 20}


def test_the_shortest_study_is_drawn_with_the_optima_of_either_dominant_hand():
    scenarios = Scenario(700), Scenario(700, 400, "left")
    short = sampled(*(improving(8, scenario, 0) for scenario in scenarios))
    config = SimpleNamespace(runs=8, scenarios=scenarios)
    found = pictures.published(short, BEST, config, 10)
    best = {one.name: one.table["optimum"].to_pylist() for one in found}
    assert best["figure_5b"] == [2.0] * 40 + [2.25] * 30
    assert set(best["figure_6a"]) == {0.75}
    assert set(best["figure_6b"]) == {1.0}


def lab(colour, matrix):
    linear = (rgb(colour) / 255.0) ** 2.2
    seen = np.clip(np.asarray(matrix) @ linear, 0, 1) ** (1 / 2.2)
    return cv2.cvtColor(seen.astype(np.float32)[None, None], cv2.COLOR_RGB2LAB)[0, 0]


@pytest.mark.parametrize("kind", COLOUR_BLIND)
def test_the_colour_blind_tell_the_curves_of_a_panel_apart(kind):
    for names in (("optimal", "other", "correction"), ("early", "late")):
        seen = [lab(LOOKS[name].colour, COLOUR_BLIND[kind]) for name in names]
        for one, other in itertools.combinations(seen, 2):
            # A difference of 2.3 is just noticeable (CIE 1976).
            assert np.linalg.norm(one - other) > 20, (kind, names)
