"""Figures of the study, looked at as pictures: what is drawn is where it belongs."""

import re
from math import inf, nan
from pathlib import Path

import cv2
import numpy as np
import pytest
import study_by_hand
from hand_made_runs import B, E, L, X, population
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from study_by_hand import EXTENT, results

from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.figures import (
    found,
    intervals,
    pictures,
    shares,
    single_runs,
)
from prospect_mj.experiment.development.figures import jar as jar_figure
from prospect_mj.experiment.development.figures.grid import COLOURS
from prospect_mj.experiment.development.figures.shares import Panel
from prospect_mj.experiment.development.measures.sequences import NO_MAJORITY, sequences
from prospect_mj.experiment.development.study.found import Range
from prospect_mj.experiment.development.study.pictures import NO_JAR, JarPicture
from prospect_mj.experiment.development.study.settings import Extent
from prospect_mj.experiment.paper.measures.bootstrap import Interval

CHANGES = (
    "change_post_allowed",
    "change_post_suppressed",
    "change_lamp-right_allowed",
    "change_lamp-right_suppressed",
)
NAMES = {
    "learners": ("strategies", "sequences"),
    "causal": ("causal", "causal_splits", "causal_labels"),
    "population": ("population",),
    "worlds": ("worlds",),
    "change": CHANGES,
    "found": ("found",),
    "haptics": (
        "haptics_portraits",
        "haptics_separation",
        "haptics_strategies_standard",
        "haptics_strategies_wide-lid",
    ),
}


def decoded(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB).astype(int)


def where(image, colour):
    """Columns of the pixels of a colour."""
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    return np.nonzero(np.abs(image - rgb).max(axis=-1) <= 3)[1]


def jar(orientation, rows=12):
    """A jar whose columns are levels 0 to 99, with nothing round it."""
    level = np.full((rows, N_BINS + 2), NO_JAR)
    level[1:-1, 1:-1] = np.arange(N_BINS)
    return JarPicture(orientation, np.full((*level.shape, 3), 100, np.uint8), level)


@pytest.fixture(scope="module", autouse=True)
def no_rendering():
    with pytest.MonkeyPatch.context() as patch:
        jars = [jar("left"), jar("right")]
        patch.setattr(pictures, "jar_pictures", lambda recording: jars)
        yield


@pytest.fixture(scope="module")
def drawn():
    parts = [part for part in EXTENT.parts if part != "change"]
    made = results(Extent(tuple(parts)))
    return {name: decoded(png) for name, png in pictures.pictures(made, None)}


def test_every_part_has_its_figures(drawn):
    parts = [part for part in EXTENT.parts if part != "change"]
    assert list(drawn) == [name for part in parts for name in NAMES[part]]


def test_contributors_are_told_of_every_figure_and_its_part():
    text = Path(__file__).parents[4].joinpath("CONTRIBUTING.md").read_text("utf-8")
    lines = text.partition("| in `figures` |")[2].partition("\n\n")[0].splitlines()[2:]
    cells = [line.split("|") for line in lines]
    told = {
        (of.strip(" `"), name)
        for _, names, _, of, _ in cells
        for name in re.findall(r"`(\S+)\.png`", names)
    }
    made = {(part, name) for part, names in NAMES.items() for name in names}
    assert told == made | {("rivals", "rivals")}


def test_a_part_alone_is_drawn_alone():
    made = results(Extent(("change",), changes=("post",)))
    drawn = dict(pictures.pictures(made, None))
    assert tuple(drawn) == CHANGES[:2]
    for png in drawn.values():
        assert len(where(decoded(png), COLOURS[L])) > 100


def test_figures_are_of_a_size_that_a_page_has(drawn):
    for name, image in drawn.items():
        height, width, _ = image.shape
        assert 1100 <= width <= 1600, name
        assert 300 <= height <= 1800, name
        assert (image.min(axis=-1) < 128).mean() > 0.002, name


def test_shares_come_one_after_the_other():
    told = study_by_hand.findings("infant")
    image = decoded(shares.shares("Title", "of", [[Panel("one", told.development)]]))
    late, early, optimal = (np.median(where(image, COLOURS[k])) for k in (L, E, B))
    assert late < early < optimal


def test_names_stand_in_the_order_of_the_stages_and_rare_ones_nowhere(monkeypatch):
    written, write = [], Axes.text

    def text(axes, x, y, words, **style):
        written.append(words)
        return write(axes, x, y, words, **style)

    monkeypatch.setattr(Axes, "text", text)
    for kind, expected in (
        ("infant", ["late", "early", "optimal"]),
        ("at once", ["other", "optimal"]),
    ):
        written.clear()
        panel = Panel("one", study_by_hand.findings(kind).development)
        shares.shares("Title", "of", [[panel]])
        assert written == expected


def test_cells_are_what_prevails_in_ten_difficult_trials():
    slow = [[L] * 5, [L] * 5, [E] * 5, [E, E, B, B, B], [B] * 5, [B] * 5]
    fast = [[X] * 5, [X, X, L, L, L], *[[B] * 5] * 4]
    cells = single_runs.prevailing_cells(population([slow, fast]))
    # Ten trials are two blocks; who is optimal first is above.
    assert cells.tolist() == [[X, B, B], [L, E, B]]


def test_what_has_no_majority_is_left_white_and_is_in_no_sequence():
    tied = population([[*[[L] * 5] * 3, *[[E] * 5] * 3]])
    assert single_runs.prevailing_cells(tied).tolist() == [[L, NO_MAJORITY, E]]
    ((sequence, _),) = sequences(tied)
    assert sequence == (L, E)
    shown, whole = (
        decoded(single_runs.single_runs({"one": population(runs)}))
        for runs in ([[*[[L] * 5] * 3, *[[E] * 5] * 3]], [[[L] * 5] * 6])
    )
    assert len(where(shown, COLOURS[L])) < len(where(whole, COLOURS[L])) / 2


def test_single_runs_are_few_and_coloured(drawn):
    many = population([[[L] * 5] * 4] * (single_runs.RUNS + 9))
    assert single_runs.prevailing_cells(many).shape == (single_runs.RUNS, 2)
    assert len(where(drawn["sequences"], COLOURS[L])) > 1000


def dots(*measured):
    """Where dots of rows with such measures are, for each row."""
    column = intervals.Column(
        "title", (intervals.Dots("late_gone", "late", "#d55e00"),), 680
    )
    rows = {f"row {number}": {"late_gone": one} for number, one in enumerate(measured)}
    png = intervals.intervals("Title", "of", rows, (column,))
    return where(decoded(png), "#d55e00")


def test_dots_stand_where_their_numbers_are():
    middles = [np.median(dots(Interval(n, n, n, 0.0))) for n in (100, 200, 300, 600)]
    steps = np.diff(middles)
    # The key below the axis moves the median a little.
    assert steps[0] == pytest.approx(steps[1], abs=15)
    assert steps[2] == pytest.approx(3 * steps[0], rel=0.1)


def test_never_is_at_the_end_and_nothing_is_nowhere():
    there = len(dots(Interval(100, 90, 110, 0.0)))
    nothing = len(dots(Interval(nan, nan, nan, 1.0)))
    never = dots(Interval(inf, 300, inf, 0.0))
    assert nothing < there
    assert never.max() > dots(Interval(600, 600, 600, 0.0)).max()


def test_only_pixels_of_levels_that_say_something_are_marked():
    levels = np.zeros(N_BINS)
    levels[10:20], levels[60:70], levels[80] = 2.0, -2.0, 0.1
    image = jar_figure.marked(jar("left"), levels).astype(int)[5, 1:-1]
    blue, red = image[:, 2] - image[:, 0], image[:, 0] - image[:, 2]
    assert np.flatnonzero(blue > 20).tolist() == list(range(10, 20))
    assert np.flatnonzero(red > 20).tolist() == list(range(60, 70))
    assert (image[80] == image[0]).all()
    around = jar_figure.marked(jar("left"), levels)[0]
    assert len(np.unique(around)) == 1


def test_nothing_is_marked_where_nothing_is_said():
    image = jar_figure.marked(jar("right"), np.zeros(N_BINS))
    assert (image == image.min(axis=-1, keepdims=True)).all()


def test_a_picture_stands_in_the_middle_of_a_larger_one():
    image = np.full((2, 3, 3), 7, np.uint8)
    shown = jar_figure.amid(image, np.array([4, 3]))
    assert shown.shape == (4, 3, 3)
    assert (shown[1:3] == image).all()
    assert len(np.unique(shown[[0, 3]])) == 1
    assert (jar_figure.amid(image, np.array([2, 3])) == image).all()


def drawn_panels(monkeypatch, *jars, example=None):
    """Panels of what was found, laid out."""
    figures = []
    monkeypatch.setattr(found, "png", lambda figure: figures.append(figure) or b"")
    what = study_by_hand.found()
    found.found(what if example is None else what._replace(example=example), jars)
    (figure,) = figures
    figure.draw_without_rendering()
    return figure.axes


def test_what_a_feature_takes_off_is_hollow_and_on_a_line_of_its_own(monkeypatch):
    taking = [Range("grasp", 9, 12, 70, 71, 0)]
    axes = drawn_panels(monkeypatch, jar("left"), jar("right"), example=taking)
    (panel,) = (one for one in axes if one.get_title("left").startswith("discovery: g"))
    bars = [one for one in panel.patches if isinstance(one, Rectangle)]
    assert [one.get_fill() and one.get_facecolor()[3] > 0 for one in bars] == [1, 0]
    added, taken = bars
    assert (added.get_x(), added.get_width()) == (8.5, 3)
    assert (taken.get_x(), taken.get_width()) == (69.5, 1)
    assert taken.get_y() + taken.get_height() < added.get_y()
    # Both are below the histograms.
    assert added.get_y() + added.get_height() < 0


def test_pictures_of_both_orientations_are_of_one_height_at_one_level(monkeypatch):
    axes = drawn_panels(monkeypatch, jar("left", 60), jar("right", 12))
    places = [one.get_window_extent() for one in axes if one.images]
    assert len(places) == 8
    for left, right in zip(places[::2], places[1::2], strict=True):
        assert (left.y0, left.y1) == pytest.approx((right.y0, right.y1), abs=1.0)


def test_scales_reach_to_what_is_drawn_and_start_at_nothing(monkeypatch):
    axes = drawn_panels(monkeypatch, jar("left"), jar("right"))
    under, over = (
        [one for one in axes if one.get_ylabel() in label]
        for label in (("histogram [1]",), ("share [1]", "weight [1]"))
    )
    assert len(under) == len(over) == 4
    for one in (*under, *over):
        ticks = one.get_yticks()
        assert ticks[0] == 0.0
        # What is said reaches half as high as the histograms, on whose panel it is.
        room = one.get_ylim()[1] * (0.5 if one in over else 1.0)
        assert ticks[-1] >= room / 2
        assert one.get_ylim()[0] <= 0.0 < ticks[-1] <= one.get_ylim()[1]
    for pair in zip(under, over, strict=True):
        nothing = [np.interp(0.0, one.get_ylim(), (0, 1)) for one in pair]
        assert nothing[0] == pytest.approx(nothing[1])
