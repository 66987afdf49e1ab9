import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from prospect_mj.agent.failed_actions import FailedActionRule
from prospect_mj.errors import InvalidChoice

FREE, IN_LEFT, IN_RIGHT = 0, 1, 2
ALL = np.ones(6, bool)


def left_over(rule, holding, allowed=ALL):
    return np.flatnonzero(rule.remaining(holding, allowed)).tolist()


def test_a_late_correction_by_hand():
    """Grasp right, insert in vain, swap, insert: what may be chosen on the way."""
    rule = FailedActionRule("suppressed")
    assert left_over(rule, FREE) == [0, 1, 2, 3, 4, 5]
    rule.note(FREE, 4, FREE, inserted=False)
    assert left_over(rule, FREE) == [0, 1, 2, 3, 5]
    rule.note(FREE, 1, IN_RIGHT, inserted=False)
    # What failed with no jar in hand has not failed with one.
    assert left_over(rule, IN_RIGHT) == [0, 1, 2, 3, 4, 5]
    rule.note(IN_RIGHT, 5, IN_RIGHT, inserted=False)
    assert left_over(rule, IN_RIGHT) == [0, 1, 2, 3, 4]
    rule.note(IN_RIGHT, 3, IN_LEFT, inserted=False)
    assert left_over(rule, IN_LEFT) == [0, 1, 2, 3, 4, 5]
    rule.note(IN_LEFT, 4, IN_LEFT, inserted=True)
    assert left_over(rule, IN_LEFT) == [0, 1, 2, 3, 4, 5]
    # Back in the other hand, it has still failed.
    assert left_over(rule, IN_RIGHT) == [0, 1, 2, 3, 4]
    assert left_over(rule, FREE) == [0, 1, 2, 3, 5]


def test_the_rule_is_lifted_where_nothing_would_remain():
    rule, grasps = FailedActionRule("suppressed"), np.arange(6) < 2
    for action in (0, 1):
        rule.note(FREE, action, FREE, inserted=False)
    assert left_over(rule, FREE, grasps) == [0, 1]
    assert left_over(rule, FREE) == [2, 3, 4, 5]
    for action in range(2, 6):
        rule.note(FREE, action, FREE, inserted=False)
    assert left_over(rule, FREE) == [0, 1, 2, 3, 4, 5]


MASKS = st.lists(st.booleans(), min_size=6, max_size=6)
HOLDING = st.integers(0, 2)
NOTES = st.lists(st.tuples(HOLDING, st.integers(0, 5), HOLDING, st.booleans()))


@given(notes=NOTES, holding=HOLDING, mask=MASKS)
def test_what_remains_is_allowed_and_something_if_anything_is(notes, holding, mask):
    rule, free = FailedActionRule("suppressed"), FailedActionRule("allowed")
    for note in notes:
        rule.note(*note)
        free.note(*note)
    remaining = rule.remaining(holding, mask)
    assert not (remaining & ~np.array(mask)).any()
    assert remaining.any() == any(mask)
    failed = {a for h, a, after, done in notes if h == after == holding and not done}
    left = set(np.flatnonzero(mask)) - failed
    assert set(np.flatnonzero(remaining)) == (left or set(np.flatnonzero(mask)))
    np.testing.assert_array_equal(free.remaining(holding, mask), mask)


def test_masks_are_neither_changed_nor_shared():
    rule, mask = FailedActionRule("suppressed"), np.ones(6, np.int8)
    rule.note(FREE, 0, FREE, inserted=False)
    first, second = (rule.remaining(FREE, mask) for _ in range(2))
    first[:] = False
    assert mask.all()
    assert second.tolist() == [False, True, True, True, True, True]


def test_unknown_rules_are_refused():
    with pytest.raises(InvalidChoice, match="'never'; valid: allowed, suppressed"):
        FailedActionRule("never")
