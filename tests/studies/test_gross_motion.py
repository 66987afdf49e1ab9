"""Gross motion between 500 random pairs of hand poses per arm; run by `make study`.

An independent sampling planner decides which of them can be done at all. Half of them
have a tall post between start and goal.
"""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from harmonic_reaches import plan_table, run_harmonic_in_parallel
from reach_pairs import draw_in_parallel
from reach_runs import run_in_parallel, table

from prospect_mj.control.result import Status
from prospect_mj.control.straight_reach import GROSS, StraightReach
from prospect_mj.robot import names

pytestmark = pytest.mark.slow
PAIRS = 500
"""Per arm."""
SEED = 0
LONGEST_PLAN = 0.050
"""Of the median plan, on a grid of 16 cells per joint [s]."""
straight = partial(StraightReach, settings=replace(GROSS, time_budget=10.0))
"""With time enough that none fails for want of it alone."""


@pytest.fixture(scope="module")
def pairs():
    return draw_in_parallel(PAIRS, SEED, jobs=2)


@pytest.fixture(scope="module")
def straight_reaches(pairs):
    return run_in_parallel(pairs, straight, jobs=2)


@pytest.fixture(scope="module")
def harmonic_runs(pairs):
    return run_harmonic_in_parallel(pairs, jobs=2)


def test_the_pairs_are_plannable_and_half_of_them_obstructed(pairs):
    assert len(pairs) == PAIRS * len(names.SIDES)
    assert sum(pair.plannable for pair in pairs) >= 0.98 * len(pairs)
    obstructed = sum(pair.obstacle is not None for pair in pairs)
    assert obstructed == len(pairs) / 2


def test_the_straight_reach_gets_stuck_or_touches_where_a_way_exists(straight_reaches):
    """What planning is for; and it never says that it arrived when it did not."""
    print("\nstraight\n" + table(straight_reaches))
    able = [reach for reach in straight_reaches if reach.pair.plannable]
    clean = sum(reach.arrived and not reach.contacts for reach in able)
    assert 0.3 * len(able) < clean < 0.9 * len(able), table(straight_reaches)
    for reach in straight_reaches:
        assert reach.arrived is (reach.status is Status.CONVERGED)


def test_along_streamlines_all_that_can_be_planned_arrive_clean(harmonic_runs):
    reaches = [reach for reach, _ in harmonic_runs]
    print("\nharmonic\n" + table(reaches))
    failed = [
        f"{reach.pair.side} {reach.pair.index}: {reach.status} {reach.reason}"
        f" {reach.contacts or ''}"
        for reach in reaches
        if reach.pair.plannable and (not reach.arrived or reach.contacts)
    ]
    assert not failed, "\n".join(failed)
    for reach in reaches:
        assert reach.arrived is (reach.status is Status.CONVERGED)


def test_the_median_plan_is_quick(harmonic_runs):
    """After the static part, which the first plan of a process may still have to make.

    Read it on a machine that does nothing else.
    """
    plans = [plan for _, plans in harmonic_runs for plan in plans]
    print("\n" + plan_table(plans))
    assert len(plans) >= len(harmonic_runs)
    assert np.median([plan.seconds for plan in plans]) <= LONGEST_PLAN
