"""The synthesised supervisor on the real plant, by exhaustion and by brute force.

The checks go back to the tables of effects and the constraints themselves; of the
synthesis they use its result alone.
"""

import pytest
from states import mirrored, state

from prospect_mj.actions.action import Action
from prospect_mj.supervisor import constraints
from prospect_mj.supervisor.effects import outcomes
from prospect_mj.supervisor.plant import (
    INITIAL,
    End,
    Situation,
    Start,
    forbidden,
    is_marked,
    plant,
    progress,
    supervision,
)
from prospect_mj.supervisor.predicates import Jar, every_state
from prospect_mj.supervisor.synthesis import Cause, synthesise

STATES = tuple(every_state())
FORBIDDEN = {s for s in STATES if constraints.violated(s)}


def allowed(predicates):
    """The actions that the synthesis lets start."""
    here, kept = Situation(predicates), supervision().kept
    return {a for a in Action if here in kept and Situation(predicates, a) in kept}


def ends(action, predicates):
    return {after for _, after in outcomes(action, predicates)}


KEPT = {s for s in STATES if Situation(s) in supervision().kept}


def test_supervision_is_possible():
    assert INITIAL in supervision().kept


def test_no_forbidden_state_is_reachable():
    """From every kept predicate state, by every way in which actions can go."""
    assert KEPT
    assert not KEPT & FORBIDDEN
    for here in KEPT:
        for action in allowed(here):
            assert not ends(action, here) & FORBIDDEN
            assert ends(action, here) <= KEPT


def test_only_forbidden_states_are_given_up():
    """Nothing happens between actions, so a state that is not forbidden can be kept."""
    assert set(STATES) == KEPT | FORBIDDEN


def hopeful_ends(action, here):
    return {after for result, after in outcomes(action, here) if result != "lost"}


def test_none_is_blocking_and_none_counts_on_losing_the_jar():
    """Back from where a trial may end, by allowed actions that do not lose the jar."""
    done = {s for s in KEPT if is_marked(s)}
    while True:
        more = {
            s
            for s in KEPT - done
            for action in allowed(s)
            if hopeful_ends(action, s) & done
        }
        if not more:
            break
        done |= more
    assert done == KEPT


def test_a_jar_that_is_seen_or_held_can_be_inserted():
    done = {s for s in KEPT if s.jar is Jar.INSERTED}
    for _ in STATES:
        done |= {s for s in KEPT if any(hopeful_ends(a, s) & done for a in allowed(s))}
    reachable = {
        s.predicates for s in supervision().automaton.reachable() if s[1] is None
    }
    hopeless = reachable - done
    assert hopeless
    assert all(s.jar is Jar.UNKNOWN and not s.holders for s in hopeless)


def test_it_is_the_least_restrictive_by_a_naive_search():
    """The greatest set in which some actions can be chosen that never leave it."""
    safe = {s for s in STATES if not constraints.violated(s)}
    while True:
        may = {s: {a for a in Action if ends(a, s) <= safe} for s in safe}
        alive = {s for s in safe if is_marked(s)}
        for _ in STATES:
            alive |= {
                s for s in safe if any(hopeful_ends(a, s) & alive for a in may[s])
            }
        if alive == safe:
            break
        safe = alive
    assert safe == KEPT
    assert all(allowed(s) == may[s] for s in safe)


def test_to_allow_any_more_would_be_dangerous():
    """Each disabled transition alone, put back, can end in a forbidden state."""
    disabled = supervision().disabled
    assert disabled
    for (situation, event), reason in disabled.items():
        assert isinstance(event, Start)
        assert ends(event.action, situation.predicates) & FORBIDDEN
        assert reason.cause is Cause.FORBIDDEN
        assert reason.state.predicates in FORBIDDEN
        assert all(isinstance(step, End) for step in reason.path)
        after = plant().enabled(situation)[event]
        assert plant().run(reason.path, after).state == reason.state
    total = sum(len(allowed(s)) for s in KEPT) + len(disabled)
    assert total == len(KEPT) * len(Action)


def test_the_danger_in_a_trial_is_to_grasp_what_is_held():
    """Derived: no constraint and no table of effects says so."""
    for situation in supervision().automaton.reachable():
        if situation.running is None:
            here = situation.predicates
            grasps = {Action.GRASP_LEFT, Action.GRASP_RIGHT} if here.holders else set()
            assert set(Action) - allowed(here) == grasps


def test_the_danger_need_not_be_a_held_jar():
    """A hand left in front, empty: the other may not bring the jar there, too."""
    assert allowed(state("frs")) == set(Action) - {Action.GRASP_RIGHT}


@pytest.mark.parametrize("name", constraints.CONSTRAINTS)
def test_every_constraint_matters(name):
    """Without it more would be allowed."""
    others = [Situation(s) for s in STATES if set(constraints.violated(s)) - {name}]
    assert supervision().kept < synthesise(plant(), others, progress()).kept


def test_without_constraints_nothing_is_disabled():
    assert not synthesise(plant(), (), progress()).disabled


def test_left_mirrors_right():
    for here in STATES:
        reflected = {Action(action ^ 1) for action in allowed(mirrored(here))}
        assert allowed(here) == reflected


def test_the_model_is_the_same_in_every_process():
    """Reasons and forbidden states come in one order, whatever the hashes are."""
    assert [s.predicates for s in forbidden()] == [s for s in STATES if s in FORBIDDEN]
    (reason,) = [
        reason
        for (situation, event), reason in supervision().disabled.items()
        if situation == Situation(state("Fr-")) and event.action is Action.GRASP_RIGHT
    ]
    assert [str(step) for step in reason.path] == [
        "success: left empty in front, right holds in front, jar unknown"
    ]
