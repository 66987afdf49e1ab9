"""A post that can stand in the way: same in scene and twin, movable, off by default."""

import numpy as np
import pytest
from reach_runs import Bench

from prospect_mj.control.kinematics import KinematicTwin
from prospect_mj.control.straight_reach import StraightReach
from prospect_mj.errors import InvalidValue
from prospect_mj.robot import names, posture
from prospect_mj.sim.placement import JarPlacement
from prospect_mj.sim.props import Obstacle, Props
from prospect_mj.sim.scene import SceneSettings, compile_scene, compile_twin
from prospect_mj.sim.simulation import Simulation

POST = Obstacle(radius=0.03, height=0.5)
WITH = SceneSettings(props=Props(obstacle=POST))
PLACE = np.array([0.55, 0.30])


NOMINAL = JarPlacement(WITH.props.pedestal.nominal, 0.0, lid_left=True)


def geoms(model):
    return {model.geom(i).name for i in range(model.ngeom)}


@pytest.mark.parametrize(
    "compiled",
    [compile_scene, lambda settings: compile_twin(settings, posture.OPEN)],
    ids=["scene", "twin"],
)
def test_it_adds_one_geom_and_changes_nothing_else(compiled):
    without, model = compiled(SceneSettings()), compiled(WITH)
    assert geoms(model) - geoms(without) == {"obstacle/post"}
    kept = [i for i in range(model.ngeom) if model.geom(i).name != "obstacle/post"]
    for field in ("geom_size", "geom_pos", "geom_quat", "geom_solref"):
        expected = getattr(without, field)
        assert np.array_equal(getattr(model, field)[kept], expected)
    assert np.array_equal(model.qpos0, without.qpos0)
    assert np.array_equal(model.key_qpos, without.key_qpos)
    assert model.nmocap == without.nmocap + 1
    assert model.nv == without.nv


@pytest.mark.parametrize("placed", [False, True])
def test_scene_and_twin_have_it_upright_on_the_table_at_its_place(placed):
    simulation, twin = Simulation(WITH), KinematicTwin(WITH)
    place = np.array(POST.position)
    if placed:
        place = PLACE
        simulation.place_obstacle(place)
        twin.place_obstacle(place)
        twin.configuration.update()
    for model, data in (
        (simulation.model, simulation.data),
        (twin.model, twin.configuration.data),
    ):
        post, size = data.geom("obstacle/post"), model.geom("obstacle/post").size
        assert size[:2] == pytest.approx([POST.radius, POST.height / 2])
        assert post.xpos == pytest.approx([*place, POST.height / 2])
        assert np.abs(post.xmat[[2, 5, 8]]) == pytest.approx([0, 0, 1])


def test_a_reset_takes_it_back_to_its_own_place_where_it_touches_nothing():
    simulation = Simulation(WITH)
    simulation.place_obstacle(PLACE)
    simulation.reset(NOMINAL)
    post = simulation.data.geom("obstacle/post")
    assert post.xpos[:2] == pytest.approx(POST.position)
    assert post.id not in simulation.data.contact.geom[: simulation.data.ncon]


def test_a_scene_without_one_says_so():
    place = np.zeros(2)
    for owner in (Simulation(), KinematicTwin(SceneSettings())):
        with pytest.raises(InvalidValue, match=r"Props\.obstacle is None"):
            owner.place_obstacle(place)


@pytest.mark.parametrize("told", [True, False])
@pytest.mark.parametrize("side", names.SIDES)
def test_an_arm_keeps_clear_of_it_exactly_if_it_is_told(side, told):
    """A straight reach whose way is barred stops short, or pushes against the post."""
    bench = Bench()
    bench.simulation.reset(NOMINAL)
    bench.twin.update(bench.torso.read())
    start = bench.twin.grasp_pose(side)
    forward = np.array([0.40, 0.0, 0.0])
    target = start.copy()
    target.wxyz_xyz[4:] += forward
    between = (start.translation() + forward / 2)[:2]
    bench.simulation.place_obstacle(between)
    if told:
        bench.twin.place_obstacle(between)
    post, touched = bench.model.geom("obstacle/post").id, []
    bench.simulation.observer = lambda data: touched.append(
        post in data.contact.geom[: data.ncon]
    )
    bench.drive(StraightReach(bench.arms[side], target, posture.home(side)))
    assert len(touched) > 100
    assert any(touched) is not told
