"""Which action may run, and which may be chosen: the whole truth table, by hand."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidChoice
from prospect_mj.supervisor.supervisor import MODES, Supervisor

HOLDERS = (None, "left", "right")
RUNS = {
    # grasp L, grasp R, swap L->R, swap R->L, insert L, insert R
    None: (1, 1, 0, 0, 0, 0),
    "left": (0, 0, 1, 0, 1, 0),
    "right": (0, 0, 0, 1, 0, 1),
}
CHOICES = {
    ("none", None): (1, 1, 1, 1, 1, 1),
    ("none", "left"): (1, 1, 1, 1, 1, 1),
    ("none", "right"): (1, 1, 1, 1, 1, 1),
    ("safe", None): (1, 1, 1, 1, 1, 1),
    ("safe", "left"): (0, 0, 1, 1, 1, 1),
    ("safe", "right"): (0, 0, 1, 1, 1, 1),
    ("productive", None): (1, 1, 0, 0, 0, 0),
    ("productive", "left"): (0, 0, 1, 0, 1, 0),
    ("productive", "right"): (0, 0, 0, 1, 0, 1),
}


def test_the_tables_are_complete():
    assert set(CHOICES) == {(mode, holder) for mode in MODES for holder in HOLDERS}


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("holder", HOLDERS)
def test_what_may_run_depends_on_the_grasp_predicates_alone(mode, holder):
    supervisor = Supervisor(mode)
    runs = tuple(int(supervisor.may_run(action, holder)) for action in Action)
    assert runs == RUNS[holder]


@pytest.mark.parametrize(("mode", "holder"), CHOICES)
def test_choice_set(mode, holder):
    mask = Supervisor(mode).choice_set(holder)
    assert mask.dtype == np.int8
    assert mask.shape == (6,)
    assert tuple(mask) == CHOICES[mode, holder]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("holder", HOLDERS)
def test_there_is_always_something_to_choose_that_runs(mode, holder):
    supervisor = Supervisor(mode)
    mask = supervisor.choice_set(holder)
    runnable = [action for action in Action if supervisor.may_run(action, holder)]
    assert runnable
    assert all(mask[action] for action in runnable)


@pytest.mark.parametrize("holder", HOLDERS)
def test_choice_sets_grow_from_productive_over_safe_to_none(holder):
    productive, safe, none = (
        Supervisor(mode).choice_set(holder) for mode in ("productive", "safe", "none")
    )
    assert (productive <= safe).all()
    assert (safe <= none).all()


def test_a_choice_set_is_the_callers_own():
    supervisor = Supervisor()
    supervisor.choice_set(None)[:] = 0
    assert supervisor.choice_set(None).all()


@pytest.mark.parametrize("mode", ["", "None", "strict", None])
def test_an_unknown_mode_is_refused_with_the_known_ones(mode):
    with pytest.raises(InvalidChoice, match="valid: none, safe, productive"):
        Supervisor(mode)
