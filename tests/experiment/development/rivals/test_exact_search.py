"""Search in exact models: shortest sequences, and an honest count of what they took."""

from time import sleep

import numpy as np
import pytest

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.development.rivals.planner import prices, wrong_physics
from prospect_mj.experiment.development.rivals.planner.clock import Clock
from prospect_mj.experiment.development.rivals.planner.search import (
    backward,
    breadth_first,
    tried_out,
)
from prospect_mj.experiment.development.rivals.planner.simulators import (
    RecordedSimulator,
    useful,
)
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.tree import usual_actions


@pytest.fixture(scope="module")
def recording():
    return Recording.load()


def first(recording, lid):
    return int(np.flatnonzero(recording.presentations.lid == lid)[0])


@pytest.mark.parametrize(("lid", "simulated"), [(LEFT, 4), (RIGHT, 6)])
def test_the_blind_search_finds_the_shortest(recording, lid, simulated):
    """Two grasps, then swap and insertion of the left hand, then of the right one."""
    start = int(recording.presentations.root[first(recording, lid)])
    found = breadth_first(RecordedSimulator(recording), start, depth=4)
    assert found.actions == (GRASPS[lid], INSERTIONS[lid])
    assert found.simulated == simulated
    assert found.expanded == simulated // 2
    assert found.sim_seconds == pytest.approx(5 * simulated, rel=0.2)


def test_a_search_that_is_too_short_finds_nothing(recording):
    start = int(recording.presentations.root[first(recording, LEFT)])
    found = breadth_first(RecordedSimulator(recording), start, depth=1)
    assert (found.actions, found.simulated) == (None, 2)


@pytest.mark.parametrize("lid", [LEFT, RIGHT])
def test_backward_finds_the_same_and_needs_the_whole_tree(recording, lid):
    number = first(recording, lid)
    found = backward(recording, number)
    assert found.actions == (GRASPS[lid], INSERTIONS[lid])
    assert found.simulated == usual_actions(10)
    assert found.sim_seconds > 2000


def test_a_plan_is_tried_out_as_far_as_it_goes(recording):
    start = int(recording.presentations.root[first(recording, LEFT)])
    simulator = RecordedSimulator(recording)
    right = GRASPS[LEFT], INSERTIONS[LEFT]
    assert tried_out(simulator, start, (*right, right[0])).actions == right
    wrong = tried_out(simulator, start, (GRASPS[RIGHT], INSERTIONS[RIGHT]))
    assert (wrong.actions, wrong.simulated) == (None, 2)


def test_what_cant_change_anything_is_not_tried(recording):
    roots = recording.presentations.root
    state = recording.predicates.states[recording.nodes.predicates[roots[0]]]
    assert useful(state) == (GRASPS[LEFT], GRASPS[RIGHT])


def test_prices_without_live_physics(recording):
    settings = RivalSettings(live_presentations=0)
    rows = {row["method"]: row for row in _prices(recording, settings)}
    assert rows[prices.CHAINING]["actions"] == 2
    assert rows[prices.BLIND]["simulated"] == 5
    assert rows[prices.WHOLE]["simulated"] == usual_actions(10)
    assert rows[prices.LEARNER]["simulated"] is None
    spent = [
        rows[method]["processor_seconds"]
        for method in (prices.LEARNER, prices.CHAINING)
    ]
    assert 0 < 10 * spent[0] < spent[1]


def test_a_clock_counts_only_what_the_processor_did():
    clock = Clock()
    sleep(0.05)
    slept = clock.spent
    assert slept.processor < 0.04 < slept.wall
    np.linalg.svd(np.random.default_rng(0).normal(size=(200, 200)))
    assert clock.spent.processor > slept.processor + 1e-4


@pytest.mark.slow
@pytest.mark.gl
def test_live_physics_is_searched_as_it_was_recorded(recording):
    settings = RivalSettings(live_presentations=1)
    rows = {row["method"]: row for row in _prices(recording, settings)}
    assert rows[prices.BLIND_LIVE]["actions"] == 2
    assert rows[prices.BLIND_LIVE]["simulated"] == 5
    verified = rows[prices.VERIFIED]
    assert (verified["actions"], verified["simulated"]) == (2, 2)
    assert verified["motion_plans"] > 0
    assert verified["ik_solutions"] > 10 * verified["motion_plans"]


@pytest.mark.slow
@pytest.mark.gl
def test_physics_with_too_narrow_a_receptacle_gives_no_plan(recording):
    settings = RivalSettings(live_errors=(-5,), depth=2)
    rows = wrong_physics.searched(recording, settings, 10).to_pylist()
    assert [row["orientation"] for row in rows] == list(NUMBERS)
    for row in rows:
        assert (row["plan"], row["inserted"], row["actions"]) == ("", False, 10)
        assert row["simulated"] == usual_actions(2)


@pytest.mark.slow
@pytest.mark.gl
def test_a_receptacle_that_takes_the_lid_misleads_the_search(recording):
    """The left hand is tried first: right where it has the lid, wrong elsewhere."""
    settings = RivalSettings(live_errors=(4, 5))
    rows = {
        (row["error"], row["orientation"]): row
        for row in wrong_physics.searched(recording, settings, 10).to_pylist()
    }
    assert all(row["inserted"] for (error, _), row in rows.items() if error == 4)
    assert rows[5, "left"]["plan"] == rows[5, "right"]["plan"] != ""
    assert [rows[5, lid]["actions"] for lid in NUMBERS] == [2, 10]
    assert [rows[5, lid]["inserted"] for lid in NUMBERS] == [True, False]


def _prices(recording, settings):
    if settings.live_presentations:
        live = prices.live_prices(recording, settings)
    else:
        live = prices.PRICES.empty_table()
    return prices.prices(recording, settings, 10, live).to_pylist()
