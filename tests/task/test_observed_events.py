"""What physics does, also when it goes wrong, is what the supervisor's model foresees.

The failures are provoked as in `tests/actions/test_failures.py`; the predicates are
observed by the robot's own sensing, and the monitor raises on what is not foreseen.
"""

import numpy as np
import pytest
from rig import (
    GRASP,
    INSERT,
    OTHER,
    SIDES,
    SWAP_FROM,
    Rig,
    holding,
    holding_wrong,
    shared_rig,
)

from prospect_mj.actions.belief import Belief
from prospect_mj.actions.workspace import PRESENTATION, workspace
from prospect_mj.robot import names
from prospect_mj.sim.props import Jar as JarProps
from prospect_mj.sim.props import Props
from prospect_mj.sim.scene import SceneSettings
from prospect_mj.supervisor.constraints import violated
from prospect_mj.supervisor.monitor import Monitor
from prospect_mj.supervisor.predicates import (
    PRESENTED,
    ArmState,
    Jar,
    Place,
    carrying,
    state_of,
)
from prospect_mj.task.predicate_sensor import PredicateSensor


class Watched:
    """A rig whose every action is followed by the monitor."""

    def __init__(self, rig):
        self.rig, self.monitor = rig, Monitor()
        places = workspace(rig.simulation.settings.props)
        self.sensor = PredicateSensor(rig.twin, places)

    @property
    def now(self):
        return self.monitor.predicates

    def observe(self):
        return self.sensor.observe(self.rig.torso.read(), self.rig.belief)

    def present(self, **how):
        self.rig.present(**how)
        self.monitor.begin(self.observe())

    def resume(self, side, snapshot):
        """Go on from a grasp that has succeeded, which the monitor is told of."""
        self.present()
        self.rig.restore(snapshot)
        self.monitor.follow(GRASP[side], "success", self.observe())

    def act(self, action):
        (outcome,) = self.rig.act(action)
        self.monitor.follow(action, outcome.result, self.observe())
        assert not violated(self.now)
        return outcome.result


@pytest.fixture
def watched():
    return Watched(shared_rig())


class Travel:
    """How far a palm is from where it was [m], and how far it ever got."""

    def __init__(self, rig, side):
        self.body = rig.model.body(names.palm(side)).id
        self.start, self.most = rig.data.xpos[self.body].copy(), 0.0

    def __call__(self, data):
        now = float(np.linalg.norm(data.xpos[self.body] - self.start))
        self.most = max(self.most, now)
        return now


class Tie:
    """Ties the palm by a spring to where it is when `begins` is first true."""

    def __init__(self, rig, side, begins, stiffness=3000.0):
        self.body = rig.model.body(names.palm(side)).id
        self.begins, self.stiffness, self.knot = begins, stiffness, None

    def __call__(self, data):
        if self.knot is None and self.begins(data):
            self.knot = data.xpos[self.body].copy()
        if self.knot is not None:
            pull = self.stiffness * (self.knot - data.xpos[self.body])
            damping = 60.0 * data.cvel[self.body, 3:]
            data.xfrc_applied[self.body, :3] = pull - damping


@pytest.fixture
def disturb(watched):
    """Install something that disturbs the physics; it is gone after the test."""

    def install(observer):
        watched.rig.simulation.observer = observer

    yield install
    watched.rig.simulation.observer = None
    watched.rig.data.xfrc_applied[:] = 0


def from_now(data):
    return True


@pytest.mark.parametrize("side", SIDES)
def test_a_trial_with_a_late_correction(watched, side):
    wrong = OTHER[side]
    watched.present(lid=side)
    assert watched.now == PRESENTED
    assert watched.act(GRASP[wrong]) == "success"
    assert watched.now == carrying(wrong)
    assert watched.act(INSERT[wrong]) == "jammed"
    assert watched.now == carrying(wrong)
    assert watched.act(SWAP_FROM[wrong]) == "success"
    assert watched.now == carrying(side)
    assert watched.act(INSERT[side]) == "success"
    assert watched.now == PRESENTED._replace(jar=Jar.INSERTED)


@pytest.mark.parametrize("side", SIDES)
def test_a_jar_that_is_too_smooth(side):
    jar = JarProps(friction=(0.01, 1e-4, 1e-6))
    icy = Watched(Rig(SceneSettings(props=Props(jar=jar))))
    icy.present(lid=side)
    assert icy.act(GRASP[side]) == "not_grasped"
    assert icy.now == PRESENTED


@pytest.mark.parametrize("bias", [(0.08, 0, 0), (-0.08, 0, 0)])
def test_a_jar_that_is_not_where_it_was_seen(watched, bias):
    watched.present(bias=bias)
    assert watched.act(GRASP["left"]) in ("not_grasped", "not_reached")
    assert watched.now == PRESENTED


def test_a_jar_that_was_not_seen(watched):
    watched.present()
    watched.rig.runner.begin(Belief())
    watched.monitor.begin(watched.observe())
    assert watched.act(GRASP["right"]) == "not_seen"


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("action", [INSERT, SWAP_FROM], ids=["insert", "swap"])
def test_a_jar_that_is_torn_away(watched, disturb, side, action):
    """As soon as the hand that it was in has moved: from it, or from the taker's."""
    rig = watched.rig
    watched.resume(side, holding(side))
    jar, travel = rig.model.body("jar/").id, Travel(rig, side)

    def tear(data):
        if travel(data) > 0.04:
            data.xfrc_applied[jar, 2] = -80.0

    disturb(tear)
    assert watched.act(action[side]) == "lost"
    assert watched.now == PRESENTED._replace(jar=Jar.UNKNOWN)


@pytest.mark.parametrize("side", SIDES)
def test_a_hand_that_cannot_get_to_the_jar(watched, disturb, side):
    watched.present(lid=side)
    disturb(Tie(watched.rig, side, from_now))
    assert watched.act(GRASP[side]) == "not_reached"
    assert not watched.now.holders
    assert watched.now.jar is Jar.SEEN


@pytest.mark.parametrize("side", SIDES)
def test_a_hand_that_stays_astray_with_the_jar(watched, disturb, side):
    """Tied where it is over the receptacle: neither forward nor back."""
    watched.resume(side, holding_wrong(side))
    rig, front = watched.rig, np.array(PRESENTATION)
    hand = rig.model.site(names.grasp_site(side)).id

    def is_over_the_well(data):
        return np.linalg.norm(data.site_xpos[hand] - front) > 0.15

    disturb(Tie(rig, side, is_over_the_well))
    assert watched.act(INSERT[side]) == "not_reached"
    astray = ArmState(True, Place.ASTRAY)
    assert watched.now == state_of(side, astray, PRESENTED.arm("left"), Jar.UNKNOWN)


@pytest.mark.parametrize("side", SIDES)
def test_an_empty_hand_that_does_not_come_home(watched, disturb, side):
    """The fingers close beside the jar; then the hand is held on its way back."""
    rig = watched.rig
    watched.present(bias=(0.08, 0, 0))
    travel = Travel(rig, side)
    disturb(Tie(rig, side, lambda data: travel(data) < travel.most - 0.08))
    assert watched.act(GRASP[side]) in ("not_grasped", "not_reached")
    astray = ArmState(False, Place.ASTRAY)
    assert watched.now == state_of(side, astray, PRESENTED.arm("left"), Jar.SEEN)
    # Let go, it stays there; the next action of that hand takes it home.
    disturb(None)
    rig.data.xfrc_applied[:] = 0
    assert watched.act(GRASP[side]) in ("not_grasped", "not_reached")
    assert watched.now == PRESENTED


def test_the_sensor_tells_an_open_hand_from_one_that_holds(watched):
    """At rest with the fingers round something is not at rest."""
    watched.present()
    reading = watched.rig.torso.read()
    reading["left"].fingers[:] += 0.3
    here = watched.sensor.observe(reading, watched.rig.belief)
    assert here.left.place is Place.ASTRAY
    assert here.right.place is Place.REST
