import itertools

import numpy as np
import pytest
from told import Draws, random_steps, seen, step

from prospect_mj.actions.action import Action
from prospect_mj.agent import TableQ, TableSettings
from prospect_mj.agent.haptics import n_haptic
from prospect_mj.errors import InvalidChoice, InvalidValue

LID_LEFT, LID_RIGHT = 0, 1
FREE, IN_LEFT, IN_RIGHT = 0, 1, 2


def at(haptic, orientation=LID_LEFT):
    return seen(haptic=haptic, orientation=orientation)


def learn(learner, haptic, action, after, terminated=False, orientation=LID_LEFT):
    given = step(at(haptic, orientation), action, at(after, orientation), terminated)
    return learner.update(given, np.random.default_rng(0))


def test_update_by_hand():
    learner = TableQ()
    learner.values[LID_LEFT, IN_LEFT] = [-5, -4, -3, -6, -2, -7]
    learner.values[LID_LEFT, FREE, 0] = -3.0
    # -1 + .99 x -2 + 3 = .02; .1 of it.
    assert learn(learner, FREE, 0, IN_LEFT) == pytest.approx(0.02)
    assert learner.values[LID_LEFT, FREE, 0] == pytest.approx(-2.998)
    # The end: -1 + 2 = 1.
    assert learn(learner, IN_LEFT, 4, IN_LEFT, terminated=True) == 1
    assert learner.values[LID_LEFT, IN_LEFT, 4] == pytest.approx(-1.9)
    assert not learner.values[LID_RIGHT].any()
    assert learner.n_updates == 2


def test_maximum_is_over_what_is_allowed():
    learner = TableQ(TableSettings(step_size=1.0, discount=1.0))
    learner.values[LID_LEFT, IN_LEFT] = [-5, -4, -3, -6, -2, -7]
    allowed = [True, False, False, True, False, False]
    learner.update(step(at(FREE), 0, at(IN_LEFT), allowed=allowed), None)
    assert learner.values[LID_LEFT, FREE, 0] == -6


def test_orientations_have_values_of_their_own():
    learner = TableQ()
    learn(learner, FREE, 1, IN_RIGHT, orientation=LID_RIGHT)
    assert learner.q_values(at(FREE, LID_RIGHT))[1] == pytest.approx(-0.1)
    assert not learner.q_values(at(FREE, LID_LEFT)).any()


def test_choice_is_epsilon_greedy_by_its_cell():
    learner = TableQ()
    learner.values[LID_RIGHT, IN_RIGHT] = [0, 0, 0, 0, 1, 2]
    assert learner.select(at(IN_RIGHT, LID_RIGHT), Draws(0.9, 0.0)).action == 5
    mask = [True] * 5 + [False]
    assert learner.select(at(IN_RIGHT, LID_RIGHT), Draws(0.9, 0.0), mask).action == 4
    assert learner.select(at(IN_RIGHT, LID_RIGHT), Draws(0.04, 0.5)).action == 3


def test_initial_values_have_their_deviation():
    settings = TableSettings(initial_sd=0.5, n_actions=5000)
    values = TableQ(settings, np.random.default_rng(0)).values
    assert values.std() == pytest.approx(0.5, rel=0.02)
    assert values[0, 0, 0] != values[1, 0, 0]


def test_a_new_orientation_begins_with_the_habit():
    learner = TableQ(TableSettings(copied_habit=True), np.random.default_rng(1))
    own = learner.values[LID_LEFT].copy()
    # Nothing is known of either: both have their own initial values.
    np.testing.assert_array_equal(learner.q_values(at(FREE)), own[FREE])
    for _ in range(50):
        learn(learner, FREE, 1, IN_RIGHT, orientation=LID_RIGHT)
    habit = learner.values[LID_RIGHT].copy()
    np.testing.assert_array_equal(learner.q_values(at(FREE)), habit[FREE])
    # With its first experience the copy is its own, and the other stays as it is.
    learn(learner, FREE, 0, IN_LEFT)
    changed = learner.values[LID_LEFT] != habit
    assert np.argwhere(changed).tolist() == [[FREE, 0]]
    np.testing.assert_array_equal(learner.values[LID_RIGHT], habit)
    learn(learner, FREE, 1, IN_RIGHT, orientation=LID_RIGHT)
    assert learner.q_values(at(FREE))[1] == habit[FREE, 1]


@pytest.mark.parametrize("new", [LID_LEFT, LID_RIGHT])
def test_known_correction_has_its_right_values(new):
    settings = TableSettings(copied_habit=True, known_correction=True)
    learner, old = TableQ(settings, np.random.default_rng(1)), 1 - new
    learn(learner, FREE, old, 1 + old, orientation=old)
    with_wrong, with_right = learner.q_values(at(1 + old, new)), None
    with_right = learner.q_values(at(1 + new, new))
    swap = (Action.SWAP_RIGHT_TO_LEFT, Action.SWAP_LEFT_TO_RIGHT)[new]
    insert = (Action.INSERT_LEFT, Action.INSERT_RIGHT)[new]
    assert with_wrong[swap] == pytest.approx(-1.99)
    assert with_right[insert] == -1
    differs = [
        (haptic, action)
        for haptic, action in itertools.product(range(3), range(6))
        if learner.q_values(at(haptic, new))[action]
        != learner.values[old, haptic, action]
    ]
    assert sorted(differs) == sorted([(1 + old, swap), (1 + new, insert)])


def test_known_correction_holds_for_every_category_of_the_grasp():
    settings = TableSettings(
        copied_habit=True, known_correction=True, n_haptic=n_haptic(2)
    )
    learner = TableQ(settings)
    learn(learner, FREE, 1, 3, orientation=LID_RIGHT)
    values = [learner.q_values(at(haptic)) for haptic in range(5)]
    assert [v[Action.INSERT_LEFT] for v in values] == [0, -1, -1, 0, 0]
    swaps = [v[Action.SWAP_RIGHT_TO_LEFT] for v in values]
    assert swaps == pytest.approx([0, 0, 0, -1.99, -1.99])


def test_replays_repeat_what_was_experienced():
    """Of one transition again and again, the error shrinks by (1 - alpha)^(1 + n)."""
    learner = TableQ(TableSettings(replays=4, buffer=1))
    errors = [learn(learner, FREE, 0, FREE, terminated=True) for _ in range(2)]
    assert errors == [-1, pytest.approx(-(0.9**5))]
    assert learner.n_updates == 2


def test_nothing_is_drawn_and_remembered_without_replays():
    learner, rng = TableQ(), np.random.default_rng(3)
    before = rng.bit_generator.state
    for given in random_steps(20, seed=4):
        learner.update(given, rng)
    assert rng.bit_generator.state == before
    assert learner.state().keys() == {"values", "seen", "n_updates"}


@pytest.mark.parametrize(("to", "of"), [(0, 4), (4, 0)])
def test_experience_belongs_to_a_table_with_replays(to, of):
    state = TableQ(TableSettings(replays=of)).state()
    with pytest.raises(InvalidChoice):
        TableQ(TableSettings(replays=to)).restore(state)


@pytest.mark.parametrize(
    ("told", "words"),
    [
        (at(3), "haptic state is 3; expected an integer from 0 to 2"),
        (at(0, 2), "orientation is 2; expected an integer from 0 to 1"),
        (at(0, -1), "orientation is -1"),
    ],
)
def test_states_out_of_the_table_are_refused(told, words):
    with pytest.raises(InvalidValue, match=words):
        TableQ().q_values(told)


@pytest.mark.parametrize("action", [6, -1, 1.5, "left"])
def test_actions_out_of_the_table_are_refused(action):
    with pytest.raises(InvalidValue, match="action"):
        learn(TableQ(), FREE, action, FREE)


def test_known_correction_belongs_to_a_copy():
    with pytest.raises(InvalidValue, match="copied_habit"):
        TableSettings(known_correction=True)
