"""Inverse kinematics on the twin alone: q <- q + v dt, no physics."""

import mink
import mujoco
import numpy as np
import pytest

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.differential_ik import DifferentialIK, IKSettings
from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.robot import posture
from prospect_mj.sim.scene import SceneSettings

SIDES = ("left", "right")
OTHER = {"left": "right", "right": "left"}
SPEEDS = np.array([1.2, 1.2, 1.6, 1.6, 1.8, 1.8, 1.8])
REFERENCES = (posture.home, posture.presenting, posture.over_well)


class Loop:
    """The twin with the arm's angles following every solution exactly."""

    def __init__(self, twin, side):
        self.twin, self.side = twin, side
        self.ik = DifferentialIK(twin, side)
        for each in SIDES:
            self.put(posture.home(each), each)

    def put(self, angles, side=None):
        configuration = self.twin.configuration.q.copy()
        configuration[self.twin.columns(side or self.side)] = angles
        self.twin.configuration.update(configuration)

    @property
    def angles(self):
        return self.twin.configuration.q[self.twin.columns(self.side)]

    @property
    def limits(self):
        return self.twin.model.jnt_range[self.twin.columns(self.side)]

    def pose(self):
        return self.twin.grasp_pose(self.side)

    def step(self, target, reference, free_roll=False):
        velocity = self.ik.solve(target, reference, free_roll)
        self.put(self.angles + velocity * CONTROL_PERIOD)
        return velocity

    def error(self, target):
        return (self.pose().inverse() @ target).log()


@pytest.fixture(scope="module")
def twin():
    return KinematicTwin(SceneSettings())


@pytest.fixture(params=SIDES)
def loop(twin, request):
    return Loop(twin, request.param)


def at(position, rotation=None):
    rotation = mink.SO3.identity() if rotation is None else rotation
    return mink.SE3.from_rotation_and_translation(rotation, np.array(position, float))


@pytest.mark.parametrize("seed", range(6))
def test_error_falls_strictly_and_converges(loop, seed):
    """From seeded starts about home to seeded poses about all three postures."""
    rng = np.random.default_rng(seed)
    reference = REFERENCES[seed % 3](loop.side)
    loop.put(reference + rng.uniform(-0.2, 0.2, 7))
    target = loop.pose()
    loop.put(posture.home(loop.side) + rng.uniform(-0.2, 0.2, 7))
    last = np.linalg.norm(loop.error(target))
    for tick in range(90):
        loop.step(target, reference)
        error = loop.error(target)
        length = np.linalg.norm(error)
        assert length < last, f"rose at tick {tick}"
        last = length
        if np.linalg.norm(error[:3]) < 1e-3 and np.linalg.norm(error[3:]) < 5e-3:
            return
    pytest.fail(f"still {error} off after {tick} ticks")


def test_free_roll_leaves_the_turn_about_the_palm_to_the_posture(loop):
    """A target that differs by roll alone is no error then, and one otherwise."""
    turned = loop.pose() @ at([0, 0, 0], mink.SO3.from_z_radians(0.8))
    start = loop.angles
    free = loop.ik.solve(turned, start, free_roll=True)
    locked = loop.ik.solve(turned, start, free_roll=False)
    assert np.abs(free).max() < 1e-6
    assert np.abs(locked).max() > 0.5


@pytest.mark.parametrize("direction", [[1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, -1]])
def test_no_limit_is_violated_on_the_way_to_a_target_a_kilometre_away(loop, direction):
    target = at(1e3 * np.array(direction))
    for _ in range(150):
        velocity = loop.step(target, posture.home(loop.side))
        assert (np.abs(velocity) <= SPEEDS * (1 + 1e-4)).all()
        margin = np.minimum(
            loop.angles - loop.limits[:, 0], loop.limits[:, 1] - loop.angles
        )
        assert margin.min() > 0.0299
    assert loop.ik.counters.held_still == 0


def test_velocity_limits_are_within_the_published_one():
    """2.0 rad/s for every joint of the WAM (barrett_model URDF)."""
    assert len(IKSettings().velocity) == 7
    assert max(IKSettings().velocity) <= 2.0
    assert IKSettings().velocity == pytest.approx(SPEEDS)


def test_the_arm_does_all_by_itself(loop):
    """With the other one frozen the error still falls; nothing is left to it."""
    target = loop.pose() @ at([0.05, 0.05, 0.1])
    for _ in range(20):
        loop.step(target, posture.home(loop.side))
    assert np.linalg.norm(loop.error(target)) < 0.01


def test_an_arm_beyond_its_limit_comes_back_without_an_exception(loop):
    """The QP with velocity limits has no solution there: solved without, and counted.

    The outcome still respects the velocity limits.
    """
    beyond = posture.home(loop.side)
    beyond[1] = loop.limits[1, 1] + 0.2
    loop.put(beyond)
    target = at([0.5, 0.2, 0.4])
    for _ in range(60):
        velocity = loop.step(target, posture.home(loop.side))
        assert (np.abs(velocity) <= SPEEDS * (1 + 1e-4)).all()
        if loop.angles[1] < loop.limits[1, 1] - 0.03:
            break
    else:
        pytest.fail("it did not come back")
    assert loop.ik.counters.without_velocity_limit > 0
    assert loop.ik.counters.held_still == 0
    before = loop.ik.counters.without_velocity_limit
    loop.step(target, posture.home(loop.side))
    assert loop.ik.counters.without_velocity_limit == before


def test_a_problem_without_any_solution_holds_the_arm_still(loop):
    """Both limits of a joint crossed: no displacement satisfies them."""
    model = loop.twin.model
    joint = loop.twin.columns(loop.side)[1]
    limit = loop.ik._limits[0]
    lower, upper = limit.lower.copy(), limit.upper.copy()
    limit.lower[joint], limit.upper[joint] = 1.0, 0.5
    try:
        velocity = loop.ik.solve(at([0.5, 0.2, 0.4]), posture.home(loop.side), False)
    finally:
        limit.lower[:], limit.upper[:] = lower, upper
    assert not velocity.any()
    assert loop.ik.counters.held_still == 1
    assert loop.ik.counters.without_velocity_limit == 1
    assert model.nv == 14


def clearance(loop, obstacles):
    """Least distance [m] of the moving arm from geoms, by MuJoCo's own measure."""
    model, data = loop.twin.model, loop.twin.configuration.data
    moving = [
        i
        for i in range(model.ngeom)
        if model.geom(i).name.startswith(f"{loop.side}_")
        and model.body(model.geom_bodyid[i]).name not in ("head", f"{loop.side}_link1")
        and not model.geom(i).name.endswith(("_tip", "_proximal", "_shoulder"))
    ]
    assert len(moving) > 8
    return min(
        mujoco.mj_geomDistance(model, data, i, j, 1.0, None)
        for i in moving
        for j in obstacles
    )


@pytest.mark.parametrize("below", [0.05, 0.3])
def test_a_hand_sent_through_the_table_stops_above_it(loop, below):
    mirror = 1 if loop.side == "left" else -1
    table = [loop.twin.model.geom("table/top").id]
    target = at([0.6, mirror * 0.25, -below], loop.pose().rotation())
    nearest = np.inf
    for _ in range(150):
        loop.step(target, posture.home(loop.side), free_roll=True)
        nearest = min(nearest, clearance(loop, table))
    assert nearest > 0.008
    # It came as near as it may, so it was the limit that stopped it.
    assert nearest < 0.02
    assert loop.pose().translation()[2] > -below + 0.05


def test_a_hand_sent_into_the_other_hand_keeps_its_distance(loop):
    model = loop.twin.model
    others = [
        i
        for i in range(model.ngeom)
        if model.geom(i).name.startswith(f"{OTHER[loop.side]}_")
        and model.body(model.geom_bodyid[i]).name != "head"
        and not model.geom(i).name.endswith(("_tip", "_proximal", "_shoulder"))
    ]
    rotation = loop.pose().rotation()
    target = at(loop.twin.grasp_pose(OTHER[loop.side]).translation(), rotation)
    nearest = np.inf
    for _ in range(100):
        loop.step(target, posture.home(loop.side))
        nearest = min(nearest, clearance(loop, others))
    assert 0.008 < nearest < 0.05


def test_solving_for_a_posture_goes_there_straight(loop):
    goal = posture.presenting(loop.side)
    distance = np.abs(loop.angles - goal).max()
    for _ in range(120):
        velocity = loop.ik.solve_posture(goal)
        assert (np.abs(velocity) <= SPEEDS * (1 + 1e-4)).all()
        loop.put(loop.angles + velocity * CONTROL_PERIOD)
    assert distance > 0.5
    assert np.abs(loop.angles - goal).max() < 1e-3
