"""Backward chaining, its model held against recorded physics, and its wrong beliefs."""

from itertools import product

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.rivals.planner import model_errors
from prospect_mj.experiment.development.rivals.planner.execution import (
    Belief,
    carry_out,
)
from prospect_mj.experiment.development.rivals.planner.facts import (
    ENDS,
    INSERTED,
    consistent,
    empty,
    holder,
    holds,
    presented,
    turned_round,
)
from prospect_mj.experiment.development.rivals.planner.geometry import (
    Geometry,
    SizeError,
)
from prospect_mj.experiment.development.rivals.planner.operators import operators
from prospect_mj.experiment.development.rivals.planner.regression import plan
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.hands import GRASPS, INSERTIONS, NUMBERS, SWAPS, hand_of
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import SIDES, other

ALLOWED, SUPPRESSED = "allowed", "suppressed"


@pytest.fixture(scope="module")
def recording():
    return Recording.load()


@pytest.fixture(scope="module")
def root(recording):
    """The root of the first presentation of a side."""
    shown = recording.presentations
    return lambda lid: int(shown.root[shown.lid == NUMBERS[lid]][0])


def rng():
    return np.random.default_rng(0)


def wider(millimetres):
    return Geometry(SizeError(half_width=millimetres / 1000))


@pytest.mark.parametrize("lid", SIDES)
def test_the_plan_is_to_grasp_by_the_lid_and_to_insert(lid):
    made = plan(presented(lid), Geometry(), rng())
    assert made.actions == (GRASPS[NUMBERS[lid]], INSERTIONS[NUMBERS[lid]])
    assert made.regressions >= len(made.actions)
    assert 2 <= made.queries <= 6


@pytest.mark.parametrize("hand", SIDES)
def test_a_jar_held_by_the_body_is_handed_over_first(hand):
    facts = frozenset({holds(hand, "body"), empty(other(hand))})
    made = plan(facts, Geometry(), rng())
    assert made.actions == (SWAPS[NUMBERS[hand]], INSERTIONS[NUMBERS[other(hand)]])


def test_every_plan_does_what_it_promises_step_by_step():
    for lid, error, seed in product(SIDES, (0, 6), range(10)):
        facts = presented(lid)
        made = plan(facts, wider(error), np.random.default_rng(seed))
        for operator in made.operators:
            assert operator.needs <= facts
            facts = operator.applied(facts)
            assert consistent(facts)
        assert INSERTED in facts


def test_regression_undoes_an_operator():
    for operator, _ in operators():
        before = operator.regressed(operator.adds)
        assert before == operator.needs
        assert operator.applied(before) >= operator.adds
        assert operator.regressed(operator.deletes - operator.adds) is None


def test_what_excludes_each_other_is_seen():
    jar = holds("left", "lid")
    assert consistent(frozenset({jar, empty("right")}))
    assert not consistent(frozenset({jar, empty("left")}))
    assert not consistent(frozenset({jar, INSERTED}))
    assert not consistent(frozenset({jar, holds("right", "body")}))
    assert not consistent(presented("left") | presented("right"))
    assert turned_round(presented("left")) == presented("right")


def test_the_model_says_of_success_what_physics_does(recording, root):
    """Every operator whose needs are met in a situation does there what it says."""
    nodes, told = recording.nodes, 0
    for lid in SIDES:
        waiting = [(root(lid), presented(lid))]
        while waiting:
            node, facts = waiting.pop()
            for operator, possible in operators():
                if not operator.needs <= facts or nodes.depth[node] >= 3:
                    continue
                led_to = int(nodes.child[node, operator.action])
                after = operator.applied(facts)
                assert nodes.inserted[led_to] == (
                    INSERTED in after and possible(Geometry())
                )
                if INSERTED not in after:
                    assert hand_of(int(nodes.holding[led_to])) == holder(after)
                    waiting.append((led_to, after))
                told += 1
    # Two actions at first; then two where a hand holds the jar, and one more level.
    assert told == 2 * (2 + 4 + 4)


def test_geometry_is_asked_once():
    geometry = Geometry()
    answers = [[geometry.fits(end) for end in ENDS] for _ in range(3)]
    assert answers == [[False, True]] * 3
    assert geometry.queries == 2
    reached = geometry.reaches_cradle, geometry.reaches_hand
    assert all(reaches(side) for side in SIDES for reaches in reached)
    assert geometry.queries == 6


@pytest.mark.parametrize(
    ("error", "ends"), [(-5, []), (-4, ["body"]), (4, ["body"]), (5, ["lid", "body"])]
)
def test_an_end_fits_as_far_as_it_is_believed_to(error, ends):
    assert [end for end in ENDS if wider(error).fits(end)] == ends


def test_no_end_that_fits_is_no_plan(recording, root):
    made = plan(presented("left"), wider(-5), rng())
    assert made.operators is None
    assert made.actions == ()
    belief = Belief("left", SUPPRESSED)
    done = carry_out(recording, root("left"), belief, wider(-5), rng())
    assert (done.actions, done.inserted, done.cost(10)) == ((), False, 10)


@pytest.mark.parametrize("lid", SIDES)
def test_a_right_belief_takes_two_actions(recording, root, lid):
    for rule in (ALLOWED, SUPPRESSED):
        belief = Belief(lid, rule)
        done = carry_out(recording, root(lid), belief, Geometry(), rng())
        assert done.inserted
        assert done.cost(10) == 2


@pytest.mark.parametrize("lid", SIDES)
def test_a_wrong_side_is_a_late_correction_or_none(recording, root, lid):
    wrong = NUMBERS[other(lid)]
    jammed = GRASPS[wrong], INSERTIONS[wrong]
    once = carry_out(
        recording, root(lid), Belief(other(lid), SUPPRESSED), Geometry(), rng()
    )
    assert once.inserted
    assert once.actions == (*jammed, SWAPS[wrong], INSERTIONS[NUMBERS[lid]])
    again = carry_out(
        recording, root(lid), Belief(other(lid), ALLOWED), Geometry(), rng()
    )
    assert not again.inserted
    assert again.actions == (jammed[0], *[jammed[1]] * 9)


def test_a_jar_that_was_lost_is_nowhere():
    belief = Belief("left", ALLOWED)
    grasp = next(
        one.operator
        for one in operators()
        if one.operator.action is Action.GRASP_LEFT
        and one.operator.needs <= belief.facts
    )
    belief.felt(grasp, "left")
    insert = next(
        one.operator for one in operators() if one.operator.needs <= belief.facts
    )
    belief.felt(insert, None)
    assert holder(belief.facts) is None
    assert plan(belief.facts, Geometry(), rng()).operators is None


def test_the_table_of_errors_says_where_the_plan_breaks(recording):
    settings = RivalSettings(size_errors=(-5, 0, 5), flips=(0.0, 1.0))
    told = {
        (row["kind"], row["error"], row["failed_actions"]): row
        for row in model_errors.believed(recording, settings, 10).to_pylist()
    }
    assert len(told) == 2 * (3 + 3 + 2)
    for rule in (ALLOWED, SUPPRESSED):
        assert told[model_errors.WIDTH, 0, rule]["actions"] == 2
        assert told[model_errors.LID, 5, rule]["actions"] == 2
        assert told[model_errors.WIDTH, -5, rule]["failures"] == 1
    wide = [told[model_errors.WIDTH, 5, rule] for rule in (ALLOWED, SUPPRESSED)]
    # With two ends that fit, one is taken by chance.
    assert wide[0]["failures"] == pytest.approx(0.5, abs=0.2)
    assert wide[0]["actions"] == pytest.approx(2 + 8 * wide[0]["failures"])
    assert wide[1]["failures"] == 0
    assert wide[1]["actions"] == pytest.approx(3, abs=0.4)
    flipped = [told[model_errors.FLIP, 1, rule] for rule in (ALLOWED, SUPPRESSED)]
    assert [one["actions"] for one in flipped] == [10, 4]
    assert [one["failures"] for one in flipped] == [1, 0]


def test_an_error_that_leaves_no_jar_is_refused():
    with pytest.raises(InvalidValue, match="error of lid_radius"):
        SizeError(lid_radius=-0.045)
