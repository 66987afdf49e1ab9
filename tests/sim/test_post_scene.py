"""A post in the receptacle, and a lid with a hollow that goes over it."""

from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from prospect_mj.recording.worlds import WORLDS
from prospect_mj.sim.props import Jar, Props
from prospect_mj.sim.scene import SceneSettings, compile_scene
from prospect_mj.task.scoring import is_inserted

PROPS = WORLDS["post"].props
JAR, WELL = PROPS.jar, PROPS.well
LINING = {f"jar/recess_{part}" for part in [*range(12), "end"]}
LID_UP, LID_DOWN = Rotation.identity(), Rotation.from_euler("x", np.pi)
STANDING = np.array([*WELL.position, WELL.floor_height + JAR.length / 2])
"""Centre of a jar that stands on the receptacle's floor [m]."""


@pytest.fixture(scope="module")
def model():
    return compile_scene(SceneSettings(props=PROPS))


def may_touch(model, one, other):
    """MuJoCo's filter (manual, "Collision detection"): bits, and not the same body."""
    first, second = model.geom(one), model.geom(other)
    meet = first.contype[0] & second.conaffinity[0]
    meet |= second.contype[0] & first.conaffinity[0]
    return bool(meet) and first.bodyid[0] != second.bodyid[0]


def partners(model, name):
    others = {model.geom(i).name for i in range(model.ngeom)}
    return {other for other in others if may_touch(model, name, other)}


def of_other_bodies(model, name):
    """All that can be met, but for the lining."""
    geoms = [model.geom(i) for i in range(model.ngeom)]
    own = model.geom(name).bodyid[0]
    return {g.name for g in geoms if g.bodyid[0] != own} - LINING - {"jar/visual"}


def test_the_lining_of_the_recess_meets_the_post_and_nothing_else(model):
    names = {model.geom(i).name for i in range(model.ngeom)}
    assert names >= LINING
    for name in LINING:
        assert partners(model, name) == {"well/post"}


def test_the_post_meets_everything_but_the_hollow_lid(model):
    expected = of_other_bodies(model, "well/post") - {"jar/lid"} | LINING
    assert "jar/body" in expected
    assert partners(model, "well/post") == expected


def test_the_hollow_lid_meets_everything_but_the_post(model):
    expected = of_other_bodies(model, "jar/lid") - {"well/post"}
    assert {"well/floor", "pedestal/far"} <= expected
    assert partners(model, "jar/lid") == expected


def test_the_body_meets_everything_and_the_post(model):
    assert partners(model, "jar/body") == of_other_bodies(model, "jar/body")
    assert "well/post" in partners(model, "jar/body")


def test_the_recess_weighs_nothing(model):
    flat = compile_scene(SceneSettings(props=Props(jar=Jar(lid_radius=JAR.lid_radius))))
    for one in ("mass", "inertia", "ipos"):
        hollow, solid = (getattr(m.body("jar/"), one) for m in (model, flat))
        assert hollow == pytest.approx(solid)


def test_only_the_lid_end_goes_down_to_the_floor():
    """By numbers alone: both ends go in between the walls, one goes over the post."""
    assert max(JAR.lid_radius, JAR.body_radius) < WELL.half_width - 0.003
    assert JAR.recess.depth > WELL.post.height + 0.003
    # The walls stop the jar aside before the lining meets the post.
    play = WELL.half_width - JAR.lid_radius
    assert JAR.recess.radius - WELL.post.radius > play + 0.005
    # Its height is more than a jar may miss the floor by, and it hides below the rim.
    assert 0.01 < WELL.post.height < WELL.depth


class Drop:
    """The scene alone, its jar put where a test wants it."""

    def __init__(self, model):
        self.model, self.data = model, mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, self.data, 0)
        self.settings = SimpleNamespace(props=PROPS)

    def place(self, position, rotation, seconds=0.0):
        start = self.model.joint("jar/").qposadr[0]
        self.data.qpos[start : start + 3] = position
        self.data.qpos[start + 3 : start + 7] = rotation.as_quat(scalar_first=True)
        self.data.qvel[:] = 0
        mujoco.mj_forward(self.model, self.data)
        if seconds:
            mujoco.mj_step(self.model, self.data, round(seconds / 0.0025))
        mujoco.mj_forward(self.model, self.data)
        return self

    @property
    def jar_position(self):
        return self.data.body("jar/").xpos.copy()

    @property
    def jar_axis(self):
        return self.data.body("jar/").xmat.reshape(3, 3)[:, 2].copy()

    def touching(self, name):
        """What touches a part."""
        names = [
            {self.model.geom(i).name for i in pair}
            for pair in self.data.contact.geom[: self.data.ncon]
        ]
        return set().union(*(pair for pair in names if name in pair)) - {name}


@pytest.fixture
def drop(model):
    return Drop(model)


def test_a_jar_pushed_against_the_post_is_met_by_the_lining(drop):
    """15 mm aside the post is in the lid's cylinder, and through the hole's wall."""
    drop.place(STANDING + [0.015, 0, 0.02], LID_DOWN)
    touching = drop.touching("well/post")
    assert touching
    assert touching <= LINING


def test_a_body_on_the_post_is_met_by_the_post(drop):
    drop.place(STANDING + [0, 0, WELL.post.height - 0.001], LID_UP)
    assert drop.touching("well/post") == {"jar/body"}


@pytest.mark.parametrize("aside", [(0, 0), (0.003, 0), (-0.002, 0.002)])
def test_dropped_lid_first_it_falls_over_the_post_and_is_in(aside, drop):
    drop.place(STANDING + [*aside, 0.01], LID_DOWN, seconds=0.5)
    assert drop.jar_position[2] == pytest.approx(STANDING[2], abs=1e-3)
    assert is_inserted(drop)


@pytest.mark.parametrize("aside", [(0, 0), (0.003, 0), (-0.002, 0.002)])
def test_dropped_body_first_it_stops_on_the_post_and_is_not_in(aside, drop):
    drop.place(STANDING + [*aside, 0.04], LID_UP, seconds=0.3)
    stopped = WELL.rim_height + WELL.stop_height(JAR.lid_radius)
    bottom = drop.jar_position[2] - JAR.length / 2
    assert bottom == pytest.approx(stopped, abs=1e-3)
    assert stopped == pytest.approx(WELL.rim_height - 0.002)
    assert not is_inserted(drop)
