"""A trial goes on from a saved state as if it had never been left, bit by bit."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidValue
from prospect_mj.supervisor.predicates import Place
from prospect_mj.task.pick_place import PickPlaceTask
from prospect_mj.task.trial_state import TrialState

pytestmark = pytest.mark.gl

PATH = (Action.GRASP_RIGHT, Action.INSERT_RIGHT, Action.SWAP_RIGHT_TO_LEFT)


@pytest.fixture(scope="module")
def task():
    with PickPlaceTask() as task:
        yield task


@pytest.fixture(scope="module")
def stations(task):
    """State before, outcome and state after each action of one trial."""
    task.reset("left", np.random.default_rng(8))
    found = []
    for action in PATH:
        before = task.save()
        found.append((before, task.execute(action), task.save()))
    return found


def assert_same(one: TrialState, other: TrialState):
    np.testing.assert_array_equal(one.physics, other.physics)
    assert one.predicates == other.predicates
    assert repr(one.belief) == repr(other.belief)


@pytest.mark.parametrize("number", [2, 0, 1])
def test_an_action_goes_the_same_way_from_a_restored_state(task, stations, number):
    """In another order than at first, after a trial with another cradle and lamp."""
    before, outcome, after = stations[number]
    task.reset("right", np.random.default_rng(9))
    task.restore(before)
    assert_same(task.save(), before)
    again = task.execute(outcome.action)
    assert repr(again) == repr(outcome)
    assert_same(task.save(), after)


def test_acting_leaves_a_saved_state_alone(task, stations):
    before = stations[0][0]
    held, physics = dict(before.belief.held), before.physics.copy()
    task.restore(before)
    task.execute(PATH[0])
    assert before.belief.held == held
    np.testing.assert_array_equal(before.physics, physics)


def test_the_controllers_know_the_cradle_of_the_restored_trial(task, stations):
    """Also where the jar has long left it."""
    after = stations[-1][2]
    assert after.belief.seen is None
    task.restore(after)
    pedestal = task.runner.twin.data.mocap_pos[0].copy()
    np.testing.assert_allclose(pedestal, after.belief.cradle.position)


def test_an_unseen_jar_leaves_the_cradle_where_it_is_by_default(task, stations):
    """And not where another trial has seen it."""
    task.restore(stations[0][0])
    task.runner.begin(type(task.runner.belief)())
    nominal = task.settings.scene.props.pedestal.nominal
    np.testing.assert_allclose(task.runner.twin.data.mocap_pos[0], nominal)


def test_the_sensors_of_a_restored_state_are_those_of_that_state(task, stations):
    """They depend on nothing that was simulated before it."""
    task.restore(stations[1][2])
    first = task.simulation.data.sensordata.copy()
    task.simulation.step(40)
    task.restore(stations[1][2])
    task.simulation.refresh()
    np.testing.assert_array_equal(task.simulation.data.sensordata, first)


def test_a_state_that_no_trial_reaches_is_refused(task, stations):
    before = stations[0][0]
    both = before.predicates._replace(
        left=before.predicates.left._replace(holding=True, place=Place.FRONT),
        right=before.predicates.right._replace(holding=True, place=Place.FRONT),
    )
    bad = TrialState(before.physics, before.belief, both)
    with pytest.raises(InvalidValue, match="left holds in front, right holds"):
        task.restore(bad)
