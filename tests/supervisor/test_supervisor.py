"""Which action may run, and which may be chosen: the whole truth table, by hand."""

import numpy as np
import pytest
from states import state

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.supervisor.plant import supervision
from prospect_mj.supervisor.supervisor import MODES, Supervisor

# grasp L, grasp R, swap L->R, swap R->L, insert L, insert R
NOBODY = (1, 1, 0, 0, 0, 0)
LEFT = (0, 0, 1, 0, 1, 0)
RIGHT = (0, 0, 0, 1, 0, 1)
RUNS = {
    "rrs": NOBODY,
    "rr-": NOBODY,
    "rri": NOBODY,
    "ars": NOBODY,
    "aa-": NOBODY,
    "Fr-": LEFT,
    "Ar-": LEFT,
    "Fa-": LEFT,
    "rF-": RIGHT,
    "rA-": RIGHT,
    "aF-": RIGHT,
}
ANY = (1, 1, 1, 1, 1, 1)
NO_GRASP = (0, 0, 1, 1, 1, 1)
CHOICES = {
    # state: none, safe, productive
    "rrs": (ANY, ANY, NOBODY),
    "ras": (ANY, ANY, NOBODY),
    "Fr-": (ANY, NO_GRASP, LEFT),
    "rF-": (ANY, NO_GRASP, RIGHT),
    "aA-": (ANY, NO_GRASP, RIGHT),
    # Nothing is of use any more: all that is safe.
    "rr-": (ANY, ANY, ANY),
    "rai": (ANY, ANY, ANY),
}


@pytest.fixture(scope="module")
def reachable():
    """The predicate states that a supervised trial can come to between actions."""
    situations = supervision().automaton.reachable()
    return [s.predicates for s in situations if s.running is None]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("letters", RUNS)
def test_what_may_run_is_the_same_in_all_modes(mode, letters):
    supervisor = Supervisor(mode)
    runs = tuple(int(supervisor.may_run(a, state(letters))) for a in Action)
    assert runs == RUNS[letters]


@pytest.mark.parametrize("letters", CHOICES)
def test_choice_set(letters):
    for mode, expected in zip(MODES, CHOICES[letters], strict=True):
        mask = Supervisor(mode).choice_set(state(letters))
        assert mask.dtype == np.int8
        assert mask.shape == (6,)
        assert tuple(mask) == expected


def test_what_runs_depends_on_who_holds_alone(reachable):
    """In the states that occur: the foundation's rule, now a theorem."""
    assert len(reachable) == 20
    for here in reachable:
        (holder,) = here.holders or (None,)
        expected = {None: NOBODY, "left": LEFT, "right": RIGHT}[holder]
        runs = tuple(int(Supervisor().may_run(a, here)) for a in Action)
        assert runs == expected


@pytest.mark.parametrize("mode", MODES)
def test_there_is_always_something_to_choose_and_all_that_runs_can_be(mode, reachable):
    supervisor = Supervisor(mode)
    for here in reachable:
        mask = supervisor.choice_set(here)
        assert mask.any()
        useless = here.jar != "seen" and not here.holders
        runs = [a for a in Action if supervisor.may_run(a, here)]
        assert useless or all(mask[a] for a in runs)


def test_choice_sets_grow_from_productive_over_safe_to_none(reachable):
    for here in reachable:
        productive, safe, none = (
            Supervisor(mode).choice_set(here) for mode in ("productive", "safe", "none")
        )
        assert (productive <= safe).all()
        assert (safe <= none).all()


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("letters", ["FF-", "Rr-", "ffs"])
def test_in_a_forbidden_state_nothing_runs_and_nothing_is_offered(mode, letters):
    supervisor, here = Supervisor(mode), state(letters)
    assert not any(supervisor.may_run(action, here) for action in Action)
    with pytest.raises(InvalidValue, match="one that supervision allows"):
        supervisor.choice_set(here)


def test_a_choice_set_is_the_callers_own():
    supervisor = Supervisor()
    supervisor.choice_set(state("rrs"))[:] = 0
    assert supervisor.choice_set(state("rrs")).all()


@pytest.mark.parametrize("mode", ["", "None", "strict", None])
def test_an_unknown_mode_is_refused_with_the_known_ones(mode):
    with pytest.raises(InvalidChoice, match="valid: none, safe, productive"):
        Supervisor(mode)
