"""A skill on the bench is what the task does, and all that came of it is told."""

from dataclasses import fields

import numpy as np
import pytest

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.episodes import episode_file
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.robot import barrett_hand
from prospect_mj.robot.names import SIDES
from prospect_mj.skills import Sensors, Workbench
from prospect_mj.task.pick_place import PickPlaceTask

pytestmark = pytest.mark.gl

JAR_WEIGHT = 0.4 * 9.81


@pytest.fixture(scope="module")
def grasped(bench):
    """A grasp, the moment after it, and the physics then."""
    bench.reset("left", seed=5)
    done = bench.run("grasp-left")
    return done, bench.save(), bench.task.simulation.save()


def test_it_does_what_the_task_does(grasped):
    done, _, state = grasped
    with PickPlaceTask() as task:
        task.reset("left", np.random.default_rng(5))
        outcome = task.execute(Action.GRASP_LEFT)
        np.testing.assert_array_equal(task.simulation.save(), state)
    assert (done.result, done.executed) == (outcome.result, outcome.executed)
    assert (done.sim_seconds, done.results) == (outcome.sim_seconds, outcome.runs)
    assert done.succeeded


def test_a_trajectory_has_every_control_period_and_the_end(grasped):
    done, *_ = grasped
    way = done.trajectory
    periods = round(done.sim_seconds / CONTROL_PERIOD)
    np.testing.assert_allclose(way.times, np.arange(periods + 1) * CONTROL_PERIOD)
    for field in fields(Sensors):
        for side in SIDES:
            rows, last = (
                getattr(part, field.name)[side] for part in (way, done.sensors)
            )
            assert rows.shape == (periods + 1, *last.shape)
            np.testing.assert_array_equal(rows[-1], last)


def test_velocities_are_how_the_joints_move(grasped):
    way = grasped[0].trajectory
    joints, velocities = way.joints["left"], way.velocities["left"]
    moved = np.diff(joints, axis=0) / CONTROL_PERIOD
    mean = (velocities[1:] + velocities[:-1]) / 2
    assert np.abs(moved).max() > 0.5
    # Not to the last digit: a command jumps in every period, and the joint after it.
    assert np.corrcoef(moved.ravel(), mean.ravel())[0, 1] > 0.99
    assert np.sqrt(np.mean((moved - mean) ** 2)) < 0.1 * moved.std()
    assert np.abs(np.diff(way.joints["right"], axis=0)).max() < 1e-3


def test_what_the_hand_holds_is_felt_by_wrist_and_fingertips(grasped):
    done, *_ = grasped
    felt, way = done.sensors, done.trajectory
    loaded = np.linalg.norm(felt.wrist_force["left"])
    hand = barrett_hand.MASS * 9.81
    assert loaded == pytest.approx(hand + JAR_WEIGHT, abs=2.0)
    assert np.linalg.norm(felt.wrist_force["right"]) == pytest.approx(hand, abs=0.3)
    assert felt.touching["left"].all()
    assert not way.touching["left"][0].any()
    assert felt.touch_force["left"].min() > 4.0
    assert not way.touching["right"].any()


def test_controllers_are_told_with_their_times_and_results(grasped):
    done, *_ = grasped
    ran = [(part.name, part.side, part.status) for part in done.controllers]
    assert ran == [(r.name, r.side, r.result.status) for r in done.results]
    assert done.controllers[0].start == 0.0
    assert done.controllers[-1].end == pytest.approx(done.sim_seconds)
    (probe,) = [r.result for r in done.results if r.name == "GraspController"]
    residual = done.measured("residual", "left")
    seen = residual[~np.isnan(residual)]
    np.testing.assert_allclose(seen, [eps for _, eps in probe.trajectory], rtol=1e-6)
    assert np.isnan(done.measured("residual", "right")).all()
    assert len(done.signals.times) == len(residual) == len(done.trajectory.times) - 1
    first = done.paths[0]
    assert first.start == 0.0
    np.testing.assert_allclose(
        first.joints[0], done.trajectory.joints["left"][0], atol=0.05
    )


def test_a_moment_comes_back_bit_by_bit(bench, grasped):
    _, moment, state = grasped
    bench.restore(moment)
    np.testing.assert_array_equal(bench.task.simulation.save(), state)
    first = bench.run("insert-left")
    assert bench.inserted
    bench.restore(moment)
    assert not bench.inserted
    again = bench.run("insert-left")
    np.testing.assert_array_equal(
        first.trajectory.joints["left"], again.trajectory.joints["left"]
    )
    # What was before the moment is not in it, but for the look.
    assert [span.name for span in bench.episode().actions] == ["insert-left"]
    assert bench.look is moment.look


def test_what_may_not_run_moves_nothing(bench):
    bench.reset("right", seed=1)
    before = bench.task.simulation.save()
    done = bench.run(Action.SWAP_LEFT_TO_RIGHT)
    assert (done.result, done.executed) == (ActionResult.NOT_ALLOWED, False)
    assert (done.sim_seconds, done.controllers) == (0.0, ())
    np.testing.assert_array_equal(done.trajectory.times, [0.0])
    np.testing.assert_array_equal(bench.task.simulation.save(), before)


def stay(robot):
    yield tuple(robot.assume(side, robot.arms[side].joints()) for side in SIDES)
    return ActionResult.SUCCESS


def stay_by(robot, side):
    yield (robot.assume(side, robot.arms[side].joints()),)
    return ActionResult.SUCCESS


def test_a_plan_of_ones_own_is_a_skill_with_a_name(bench, tmp_path):
    bench.reset("left", seed=2)
    done = [bench.run(stay), bench.run(stay_by, "right")]
    assert [one.name for one in done] == ["stay", "stay-by-right"]
    assert all(one.executed and one.succeeded for one in done)
    assert [part.side for part in done[1].controllers] == ["right"]
    # It is kept in the episode's file under its name, too.
    path = tmp_path / "own.npz"
    episode_file.write(path, bench.episode(), "no run")
    read = episode_file.read(path).actions
    assert [span.name for span in read] == ["stay", "stay-by-right"]
    assert [span.outcome for span in read] == [
        span.outcome for span in bench.episode().actions
    ]


def no_tuple(robot):
    yield robot.assume("left", robot.arms["left"].joints())
    return ActionResult.SUCCESS


def no_controllers(robot):
    yield ("home",)
    return ActionResult.SUCCESS


def no_result(robot):
    yield ()


@pytest.mark.parametrize(
    ("skill", "side", "kind", "words"),
    [
        ("grasp-up", None, InvalidChoice, "skill is 'grasp-up'; valid: grasp-left"),
        (["grasp-left"], None, InvalidChoice, "valid: grasp-left"),
        ("grasp-left", "left", InvalidValue, "side is 'left'; expected none"),
        (stay, "left", InvalidValue, "expected what stay takes"),
        (stay_by, None, InvalidValue, "expected what stay-by takes"),
        (dict, None, InvalidValue, "expected what dict takes"),
        (stay_by, "up", InvalidChoice, "side is 'up'; valid: left, right"),
        (lambda robot: None, None, InvalidValue, "expected a generator"),
        (no_tuple, None, InvalidValue, "expected a tuple of controllers"),
        (no_controllers, None, InvalidValue, "yielded is .'home',.; expected a tuple"),
        (no_result, None, InvalidValue, "result is None; expected an ActionResult"),
    ],
)
def test_what_is_no_skill_is_refused_and_moves_nothing(bench, skill, side, kind, words):
    bench.reset("left", seed=2)
    before = bench.task.simulation.save()
    with pytest.raises(kind, match=words):
        bench.run(skill, side)
    np.testing.assert_array_equal(bench.task.simulation.save(), before)
    assert bench.episode().actions == ()


def test_a_quantity_that_nobody_measures_is_refused(grasped):
    with pytest.raises(InvalidChoice, match="quantity is 'eps'; valid: position_error"):
        grasped[0].measured("eps", "left")


def test_without_a_jar_there_is_nothing_to_do():
    with Workbench() as empty:
        for use in (lambda: empty.run("grasp-left"), empty.save, empty.episode):
            with pytest.raises(InvalidValue, match="one that began with a reset"):
                use()


def test_any_seed_that_an_environment_takes_presents_a_jar(bench):
    assert bench.reset("left", LARGEST_SEED).status == "found"


@pytest.mark.parametrize(
    ("lid", "seed"),
    [("up", 0), ("left", -1), ("left", 0.5), ("left", LARGEST_SEED + 1)],
)
def test_a_jar_that_cant_be_presented_is_refused(bench, lid, seed):
    with pytest.raises((InvalidChoice, InvalidValue)):
        bench.reset(lid, seed)


@pytest.fixture(scope="module")
def closed():
    """A workbench that was closed twice, and what it was before."""
    with Workbench.present("left", seed=2) as bench:
        moment = bench.save()
        bench.close()
    return bench, moment


@pytest.mark.parametrize(
    "use",
    [
        lambda bench, _: bench.reset("left"),
        lambda bench, _: bench.run("grasp-left"),
        lambda bench, _: bench.run(stay),
        lambda bench, _: bench.sense(),
        lambda bench, _: bench.robot,
        lambda bench, _: bench.look,
        lambda bench, _: bench.inserted,
        lambda bench, _: bench.save(),
        lambda bench, moment: bench.restore(moment),
        lambda bench, _: bench.episode(),
    ],
)
def test_a_closed_workbench_says_so_and_does_nothing(closed, use):
    bench, moment = closed
    before = bench.task.simulation.save()
    with pytest.raises(InvalidValue, match="workbench is 'closed'; expected an open"):
        use(bench, moment)
    np.testing.assert_array_equal(bench.task.simulation.save(), before)
