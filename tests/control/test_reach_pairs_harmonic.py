"""Ten pairs per arm along streamlines: the fast variant of the gross motion study."""

import functools

import numpy as np
import pytest
from harmonic_reaches import run_harmonic
from reach_pairs import draw_pair
from reach_runs import table
from rig import SIDES

from prospect_mj.control.harmonic_motion import TIME_BUDGET
from prospect_mj.robot import names

N = 10
"""Pairs per arm, half of them with the post between start and goal."""


@functools.cache
def runs():
    pairs = [draw_pair(side, i, seed=1) for side in names.SIDES for i in range(N)]
    return [run_harmonic(pair) for pair in pairs]


@pytest.mark.parametrize("side", SIDES)
def test_all_that_can_be_planned_arrive_without_a_contact(side):
    reaches = [reach for reach, _ in runs() if reach.pair.side == side]
    able = [reach for reach in reaches if reach.pair.plannable]
    assert len(able) >= 0.9 * N
    assert sum(reach.pair.obstacle is not None for reach in able) >= 0.4 * N
    for reach in able:
        assert reach.arrived, table(reaches)
        assert not reach.contacts, table(reaches)
        assert reach.seconds < TIME_BUDGET


def test_every_reach_was_planned_and_seldom_more_than_once():
    plans = [plans for _, plans in runs()]
    assert all(each[0].found for each in plans)
    assert np.mean([len(each) for each in plans]) < 2
    # The solver is a part of a plan, and not all of it.
    solved = [plan for each in plans for plan in each if plan.solver > 0]
    assert len(solved) > N
    assert all(plan.solver < plan.seconds for plan in solved)
