"""What the abstract task came to.

The numbers are those of a rough study on a simulator without a robot, with made-up
histograms, whose code is gone ("Development feasibility", sections 3 to 5); its blocks
of ten trials are written as trials here, a range as its middle, and corrections that
are there to the end of its 600 trials as never gone.
"""

from collections.abc import Mapping
from math import inf, nan
from types import MappingProxyType
from typing import NamedTuple

from prospect_mj.experiment.development.study.causal import BASE, forced_name
from prospect_mj.experiment.development.study.settings import Part

Key = tuple[Part, str, str]
"""Part, name and rule of a row."""

_RATE = 0.005


class Abstract(NamedTuple):
    """What a row came to on the abstract task; NaN where it isn't told."""

    late_gone: float
    """[trials]; NaN: never above 10 %, infinite: never gone."""
    early_gone: float
    """[trials], likewise."""
    order: float = nan
    """[1]"""
    early_lead: float = nan
    """[trials]"""
    dominance: float = nan
    """[trials]"""
    late_most: float = nan
    """[1]"""
    early_most: float = nan
    """[1]"""
    other_first: float = nan
    """[1]"""
    optimal_last: float = nan
    """[1]"""
    easy_worst: float = nan
    """[1]"""
    other_optimal: float = nan
    """Share of the runs in which these alone prevail, one after the other [1]."""
    other_early_optimal: float = nan
    """[1], likewise."""
    late_early_optimal: float = nan
    """[1], likewise."""
    other_late_early_optimal: float = nan
    """[1], likewise."""


_LEARNERS = {
    ("linear", "allowed"): Abstract(
        250, nan, 0.0, 0, 20, 0.16, 0.03, 0.75, 0.97, 0.72, other_optimal=0.82
    ),
    ("linear", "suppressed"): Abstract(
        350, nan, 0.0, 0, 60, 0.93, 0.01, 0.22, 0.96, 0.95
    ),
    ("linear, step .02", "allowed"): Abstract(
        90, 410, 0.98, 0, 10, nan, nan, 0.54, 0.92, 0.77
    ),
    ("linear, step .05", "allowed"): Abstract(
        50, 320, 1.0, 0, 0, nan, nan, 0.35, 0.97, 0.62
    ),
    ("linear, step .1", "allowed"): Abstract(
        30, 240, 1.0, 0, 0, nan, nan, 0.23, 0.98, 0.47
    ),
    ("linear, step .02", "suppressed"): Abstract(
        100, nan, 0.0, 0, 20, nan, 0.01, 0.14, 0.98, 0.87
    ),
    ("linear, step .05", "suppressed"): Abstract(
        50, 160, 1.0, 0, 10, nan, 0.18, 0.09, 0.98, 0.68
    ),
    ("replay", "allowed"): Abstract(30, 70, 1.0, 40, 50, 0.10, 0.70, 0.61, 0.98, 0.97),
    ("replay", "suppressed"): Abstract(
        50,
        100,
        1.0,
        40,
        80,
        0.63,
        0.85,
        0.59,
        0.98,
        0.97,
        other_early_optimal=0.16,
        other_late_early_optimal=0.83,
    ),
    ("table", "suppressed"): Abstract(
        90, 100, 0.96, 0, 0, 0.17, 0.15, 0.45, 0.98, 0.97
    ),
    ("table, copied habit", "suppressed"): Abstract(
        130, nan, 0.0, 0, 60, 0.82, 0.01, 0.07, 0.98, 0.97
    ),
    ("table, copied habit, replays", "suppressed"): Abstract(
        70, nan, 0.0, 0, 60, 0.45, 0.01, 0.87, 0.98, 0.97
    ),
    ("table, copied habit, known correction", "suppressed"): Abstract(
        30, nan, 0.0, 0, nan, nan, 0.01, 0.005, 0.98, 0.97
    ),
    ("table, copied habit, known correction, replays", "suppressed"): Abstract(
        50, 140, 1.0, 80, nan, nan, 0.98, 0.005, 0.98, 0.97
    ),
    ("discovery", "allowed"): Abstract(
        60, 160, 1.0, 90, 120, 0.14, 0.92, 0.82, 0.95, 0.83, other_early_optimal=0.95
    ),
    ("discovery", "suppressed"): Abstract(
        80, 210, 1.0, 100, 170, 0.98, 0.94, 0.07, 0.93, 0.81, late_early_optimal=0.80
    ),
}


def _row(
    late_gone: float,
    early_gone: float,
    order: float = nan,
    early_lead: float = nan,
    early_most: float = nan,
    optimal_last: float = nan,
    easy_worst: float = nan,
) -> Abstract:
    """A row of the discovery learner, of which less is told."""
    return Abstract(
        late_gone,
        early_gone,
        order,
        early_lead,
        early_most=early_most,
        optimal_last=optimal_last,
        easy_worst=easy_worst,
    )


_CAUSAL = {
    BASE: _row(80, 210, 1.0, 90, 0.93, 0.93, 0.81),
    "values inherited": _row(inf, nan, 0.0, 0, 0.06, 0.79, 0.30),
    "values from stored targets": _row(80, 210, 1.0, 100, 0.96, 0.96, 0.75),
    "TD labels, all cached": _row(60, 100, 1.0, 30, 0.91, 0.91, 0.70),
    "return labels": _row(90, 210, 1.0, 100, 0.94, 0.88, 0.81),
    "return labels, all cached": _row(60, inf, 1.0, 0, 0.29, 0.81, 0.66),
    "first feature shared": _row(80, 240, 1.0, 100, 0.90, 0.95, 0.87),
    "first feature shared, values inherited": _row(320, nan, 0.11, 0, 0.07, 0.97, 0.84),
    "no feature re-used": _row(80, 210, 1.0, 100, 0.94, 0.91),
    "no search after the first": _row(80, 230, 1.0, 100, 0.94, 0.93),
    "one feature per context": _row(80, 200, 1.0, 90, 0.95, 0.96, 0.81),
    "guard .05": _row(70, 550, early_lead=100),
    "guard 1e-7": _row(90, 240, early_lead=110),
    "least rate .002": _row(150, 480, 1.0, 260, 0.98, 0.93, 0.86),
    "least rate .01": _row(60, 130, 1.0, 50, 0.87, 0.93, 0.66),
    "least rate .02": _row(40, 110, 1.0, 20, 0.65, 0.93, 0.45),
    "least rate .05": _row(40, 100, 1.0, 0, 0.32, 0.93, 0.26),
    "least rate .1": _row(40, 100, 1.0, 0, 0.40, 0.93, 0.40),
    "surprise .25": _row(50, 130, early_lead=60),
    "discount .9": _row(90, 260, 1.0, 130),
    "epsilon .1": _row(80, 200, 1.0, 100),
    "pretraining 0": _row(50, 100, 1.0, 20, 0.46),
    "pretraining 100": _row(60, 180, 1.0, 90, 0.80, 0.925),
    "pretraining 800": _row(80, 190, 1.0, 90, 0.97, 0.925),
    forced_name("insertion first", "examples", _RATE): _row(
        50, 150, 1.0, 100, 0.99, 0.98, 0.95
    ),
    forced_name("both at once", "examples", _RATE): _row(
        50, 60, 1.0, 0, 0.34, 0.98, 0.63
    ),
    forced_name("grasp first", "examples", _RATE): _row(
        150, 160, 1.0, 0, 0.30, 0.98, 0.15
    ),
    forced_name("insertion first", "inherit", _RATE): _row(
        300, nan, 0.2, 0, 0.08, 0.98, 0.95
    ),
}

_UNLIKE = Abstract(120, 380, 1.0, 90, 150, easy_worst=0.80)

TOLD: Mapping[Key, Abstract] = MappingProxyType(
    {("learners", *key): told for key, told in _LEARNERS.items()}
    | {("causal", name, "suppressed"): told for name, told in _CAUSAL.items()}
    | {("population", "discovery", "suppressed"): _UNLIKE}
)
"""By the row of the study that has the same learners on the recorded task."""
