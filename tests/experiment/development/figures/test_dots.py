"""Dots of equal values, none of which hides another."""

from itertools import pairwise
from math import inf

import cv2
import numpy as np
import pytest
import study_by_hand
from small_study import SETTINGS

from prospect_mj.experiment.development.figures import crossed, intervals
from prospect_mj.experiment.development.figures.dots import SIZE, asides
from prospect_mj.experiment.development.study import causal
from prospect_mj.experiment.paper.measures.bootstrap import Interval

COLOURS = "#d55e00", "#009e73"
"""Late and early corrections, in both kinds of figures."""


def pixels(png, colour):
    """Rows and columns of the pixels of a colour, those of words below left out."""
    image = cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB).astype(int)
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    there = np.argwhere(np.abs(image - rgb).max(axis=-1) <= 3)
    return there[there[:, 0] < image.shape[0] - 110]


def equal(value):
    """Late and early corrections that are gone at the same time."""
    return {kind: Interval(value, value, value) for kind in ("late_gone", "early_gone")}


def in_rows(value):
    return intervals.intervals(
        "Title", "of", {"one": equal(value)}, (intervals.GONE_COLUMN,)
    )


def in_columns(value):
    row = study_by_hand.causal_row(causal.rows(SETTINGS)[0])
    one = row._replace(measured={**row.measured, **equal(value)})
    return crossed.crossed("Title", "of", ["a"], ["b"], [0.1], lambda *names: one)


def test_dots_of_one_place_are_a_dot_apart_round_its_middle():
    assert asides(1) == [0.0]
    for number in (2, 3):
        places = asides(number)
        assert sum(places) == pytest.approx(0.0)
        assert all(after - before > SIZE for before, after in pairwise(places))


@pytest.mark.parametrize("value", [200.0, inf])
@pytest.mark.parametrize("draw", [in_rows, in_columns])
def test_both_of_two_equal_dots_are_seen_whole(draw, value):
    late, early = (pixels(draw(value), colour) for colour in COLOURS)
    assert len(late) > 30
    assert len(late) == pytest.approx(len(early), rel=0.1)


def test_dots_are_moved_across_the_axis_of_values_only():
    late, early = (pixels(in_rows(200.0), c).mean(axis=0) for c in COLOURS)
    assert late[1] == pytest.approx(early[1], abs=0.6)
    assert late[0] < early[0] - 5
    late, early = (pixels(in_columns(200.0), c).mean(axis=0) for c in COLOURS)
    assert late[0] == pytest.approx(early[0], abs=0.6)
    assert late[1] < early[1] - 5


def test_never_is_beyond_all_trials():
    never, last = (pixels(in_columns(value), COLOURS[0])[:, 0] for value in (inf, 600))
    assert never.mean() < last.mean()
