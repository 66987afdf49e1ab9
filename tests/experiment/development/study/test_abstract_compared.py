"""Which recorded numbers are alike to those of the abstract task."""

from math import inf, nan

import pytest

from prospect_mj.experiment.development.study import causal
from prospect_mj.experiment.development.study.abstract_compared import COMPARED
from prospect_mj.experiment.development.study.abstract_told import Abstract
from prospect_mj.experiment.development.study.measured import Measured
from prospect_mj.experiment.development.study.settings import StudySettings
from prospect_mj.experiment.paper.measures.bootstrap import Interval

BY_NAME = {each.name: each for each in COMPARED}
ROW = causal.rows(StudySettings())[0]


def told(**numbers):
    return Abstract(**({"late_gone": nan, "early_gone": nan} | numbers))


def row(name, estimate, low=None, high=None, order=nan):
    low, high = (estimate if one is None else one for one in (low, high))
    return Measured(ROW, 20, {name: Interval(estimate, low, high)}, order)


@pytest.mark.parametrize(
    ("name", "said", "interval", "outside", "differs"),
    [
        ("late_gone", 80, (80, 80, 90), False, False),
        # One block of ten is alike, two are not; a tenth of a large number is.
        ("late_gone", 80, (90, 90, 100), True, False),
        ("late_gone", 80, (100, 100, 100), True, True),
        ("early_gone", 400, (440, 440, 450), True, False),
        ("early_gone", 400, (450, 450, 450), True, True),
        ("late_gone", inf, (600, 590, inf), False, False),
        ("late_gone", inf, (500, 490, 510), True, True),
        ("late_gone", nan, (50, 50, 50), True, True),
        ("late_gone", 50, (nan, nan, nan), True, True),
        ("late_gone", nan, (nan, nan, nan), False, False),
        # Shares are told to hundredths, and ten points are alike.
        ("late_most", 0.5, (0.504, 0.504, 0.52), False, False),
        ("late_most", 0.5, (0.55, 0.51, 0.59), True, False),
        ("late_most", 0.5, (0.65, 0.61, 0.7), True, True),
        ("late_most", nan, (0.65, 0.61, 0.7), False, False),
    ],
)
def test_numbers_are_outside_or_differ(name, said, interval, outside, differs):
    each, abstract = BY_NAME[name], told(**{name: said})
    one = row(name, *interval)
    assert each.is_outside(abstract, one) == outside
    assert each.differs(abstract, one) == differs


@pytest.mark.parametrize(
    ("said", "found", "differs"),
    [(1.0, 0.94, False), (0.0, 0.4, True), (0.11, 0.81, True), (nan, 1.0, False)],
)
def test_orders_have_no_interval_and_are_alike_within_ten_points(said, found, differs):
    each, one = BY_NAME["order"], row("late_gone", 80, order=found)
    assert each.differs(told(order=said), one) == differs
    assert each.is_outside(told(order=said), one) == differs


@pytest.mark.parametrize(
    ("after", "brought", "nearer"),
    [
        ((100, 100, 110), True, False),
        # A wider interval alone brings nothing, nor does what overshoots.
        ((200, 90, 260), False, False),
        ((150, 150, 160), False, True),
        ((190, 190, 190), False, False),
        ((230, 220, 240), False, False),
        ((10, 10, 10), False, True),
        ((nan, nan, nan), False, False),
    ],
)
def test_a_change_brings_a_number_to_the_abstract_one_or_nearer(after, brought, nearer):
    each, abstract = BY_NAME["early_gone"], told(early_gone=100)
    before = row("early_gone", 200, 190, 210)
    changed = row("early_gone", *after)
    assert each.brought(abstract, before, changed) == brought
    assert each.nearer(abstract, before, changed) == nearer


def test_what_is_not_there_is_brought_by_being_there():
    each, abstract = BY_NAME["early_gone"], told(early_gone=100)
    lacking, there = row("early_gone", nan), row("early_gone", 100)
    assert each.brought(abstract, lacking, there)
    assert not each.brought(abstract, lacking, lacking)
    assert each.brought(told(), there, lacking)
