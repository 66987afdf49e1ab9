"""Watching the controllers of an action, which must change nothing."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings

pytestmark = pytest.mark.gl

ACTIONS = (Action.GRASP_LEFT, Action.INSERT_LEFT)


class Watched:
    """What an observer is told, each controller apart."""

    def __init__(self):
        self.periods, self.controllers = 0, []
        self.measured, self.paths = {}, {}

    def __call__(self, controllers, reading):
        self.periods += 1
        for controller in controllers:
            key = id(controller)
            if key not in self.measured:
                # Kept, so that no other one gets its number.
                self.controllers.append(controller)
                self.measured[key], self.paths[key] = [], []
            self.measured[key].append(controller.measured)
            self.paths[key].append(controller.planned_path)

    def of(self, name):
        return [c for c in self.controllers if type(c).__name__ == name]

    def values(self, controller, quantity):
        told = [getattr(each, quantity) for each in self.measured[id(controller)]]
        return np.array([value for value in told if value is not None])


def run(observer=None):
    with PickPlaceTask(TaskSettings()) as task:
        task.runner.watcher = observer
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
    ran = [(run_.name, run_.side, run_.result) for o in outcomes for run_ in o.runs]
    told = [(type(c).__name__, c.side, c.result) for c in observer.controllers]
    assert sorted(map(str, told)) == sorted(map(str, ran))
    for controller in observer.controllers:
        # The one in which it ends is not in its own time.
        ran = round(controller.result.seconds / CONTROL_PERIOD)
        assert len(observer.measured[id(controller)]) == ran + 1
    seconds = sum(outcome.sim_seconds for outcome in outcomes)
    assert observer.periods == round(seconds / CONTROL_PERIOD)


def test_a_reach_follows_a_plan_whose_rest_becomes_shorter(watched):
    observer, *_ = watched
    reaches = observer.of("HarmonicReach")
    assert reaches
    for reach in reaches:
        paths = [p for p in observer.paths[id(reach)] if p is not None]
        assert all(path.ndim == 2 and path.shape[1] == 7 for path in paths)
        left = observer.values(reach, "way_left")
        assert left[-1] < 0.5 * left[0]
        # Where it plans anew the way may be a cell longer.
        assert np.diff(left).max() < 0.3


def test_a_motion_tells_an_error_that_falls_below_its_tolerance(watched):
    observer, *_ = watched
    motions = observer.of("FineMotion")
    assert motions
    for motion in motions:
        errors = observer.values(motion, "position_error")
        assert len(errors) == len(observer.measured[id(motion)])
        assert errors[-1] < motion.DEFAULTS.position_tolerance + 1e-9 or (
            errors[-1] < 0.5 * errors[0]
        )


def test_a_grasp_tells_its_residual_and_an_insertion_its_force(watched):
    observer, *_ = watched
    (grasp,) = observer.of("GraspController")
    residuals = observer.values(grasp, "residual")
    np.testing.assert_array_equal(residuals, [e for _, e in grasp.result.trajectory])
    (insertion,) = observer.of("InsertionController")
    forces = observer.values(insertion, "contact_force")
    assert 0 < forces.max() <= insertion.result.peak_force
