"""The skill of the example works in full physics, and keeps the belief true."""

import numpy as np
import pytest

from prospect_mj.actions.belief import SeenJar
from prospect_mj.robot import names
from prospect_mj.supervisor.predicates import PRESENTED, carrying

pytestmark = pytest.mark.gl


@pytest.mark.parametrize(("lid", "seed"), [("left", 11), ("right", 12)])
def test_a_jar_put_back_can_be_grasped_by_the_other_hand(bench, put_back, lid, seed):
    bench.reset(lid, seed)
    before = bench.task.simulation.jar_position
    wrong = names.other(lid)
    bench.run(f"grasp-{wrong}")
    assert np.linalg.norm(bench.task.simulation.jar_position - before) > 0.1
    done = bench.run(put_back, wrong)
    assert (done.name, done.result) == (f"put-back-{wrong}", "success")
    assert np.linalg.norm(bench.task.simulation.jar_position - before) < 0.006
    assert not done.sensors.touching[wrong].any()
    assert bench.task.predicates == PRESENTED
    assert bench.run(f"grasp-{lid}").succeeded
    assert bench.run(f"insert-{lid}").succeeded
    assert bench.inserted


def test_a_hand_that_holds_nothing_puts_nothing_back(bench, put_back):
    bench.reset("left", seed=11)
    before = bench.task.simulation.save()
    done = bench.run(put_back, "left")
    assert (done.result, done.executed) == ("not_allowed", False)
    np.testing.assert_array_equal(bench.task.simulation.save(), before)


def test_a_jar_that_cant_be_put_down_is_kept(bench, put_back):
    bench.reset("right", seed=11)
    bench.run("grasp-left")
    cradle = bench.robot.belief.cradle
    far = SeenJar(cradle.position + [2.0, 0, 0], cradle.axis)
    bench.robot.belief.cradle = far
    done = bench.run(put_back, "left")
    assert done.result == "not_reached"
    assert bench.task.predicates == carrying("left")
    assert bench.run("insert-left").result == "jammed"
