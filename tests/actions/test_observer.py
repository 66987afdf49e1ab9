"""Watching the controllers of an action, which must change nothing."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings

pytestmark = pytest.mark.gl

ACTIONS = (Action.GRASP_LEFT, Action.INSERT_LEFT)


class Watched:
    """What an observer is told, as plain numbers."""

    def __init__(self):
        self.periods = []

    def __call__(self, controllers, reading):
        self.periods.append(
            [
                (type(c).__name__, c.side, c.measured, c.planned_path, c.result)
                for c in controllers
            ]
        )

    def of(self, name):
        return [told for period in self.periods for told in period if told[0] == name]

    def measured(self, name, quantity):
        values = [getattr(measured, quantity) for _, _, measured, *_ in self.of(name)]
        return np.array([value for value in values if value is not None])


def run(observer=None):
    with PickPlaceTask(TaskSettings()) as task:
        task.runner.observer = observer
        task.reset("left", np.random.default_rng(3))
        outcomes = [task.execute(action) for action in ACTIONS]
        return outcomes, task.simulation.save()


@pytest.fixture(scope="module")
def watched():
    observer = Watched()
    return observer, *run(observer)


def test_who_watches_changes_nothing(watched):
    _, outcomes, state = watched
    alone, without = run()
    assert alone == outcomes
    np.testing.assert_array_equal(state, without)


def test_every_control_period_of_every_controller_is_told(watched):
    observer, outcomes, _ = watched
    for run_ in (run_ for outcome in outcomes for run_ in outcome.runs):
        assert observer.of(run_.name)
    seconds = sum(outcome.sim_seconds for outcome in outcomes)
    assert len(observer.periods) == round(seconds / CONTROL_PERIOD)
    ended = [told for period in observer.periods for told in period if told[-1]]
    assert len(ended) == sum(len(outcome.runs) for outcome in outcomes)


def test_a_reach_follows_a_plan_whose_rest_becomes_shorter(watched):
    observer, *_ = watched
    paths = [told[3] for told in observer.of("HarmonicReach") if told[3] is not None]
    assert all(path.ndim == 2 and path.shape[1] == 7 for path in paths)
    left = observer.measured("HarmonicReach", "way_left")
    assert left[0] > 0.5
    assert np.diff(left).max() < 0.5 * left[0]


def test_fine_motion_ends_within_its_tolerance(watched):
    observer, *_ = watched
    errors = observer.measured("FineMotion", "position_error")
    assert errors.max() > 0.01
    assert errors[-1] < 0.005


def test_a_grasp_tells_its_residual_and_an_insertion_its_force(watched):
    observer, outcomes, _ = watched
    told = observer.measured("GraspController", "residual")
    grasped = next(r for r in outcomes[0].runs if r.name == "GraspController").result
    np.testing.assert_array_equal(told, [eps for _, eps in grasped.trajectory])
    forces = observer.measured("InsertionController", "contact_force")
    inserted = outcomes[1].runs[-1].result
    for run_ in outcomes[1].runs:
        if run_.name == "InsertionController":
            inserted = run_.result
    assert forces.max() == pytest.approx(inserted.peak_force)
