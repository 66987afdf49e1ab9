"""Distances to solids are MuJoCo's own."""

import mujoco
import numpy as np
import pytest

from prospect_mj.errors import InvalidChoice
from prospect_mj.planning.arm_kernels import distance
from prospect_mj.planning.solids import cylinder, solids

TIP = 1e-3
"""Radius of the sphere that stands for a point [m]."""
SHAPES = {
    "sphere": "0.07",
    "capsule": "0.05 0.12",
    "cylinder": "0.06 0.09",
    "box": "0.05 0.11 0.02",
}
PARTNERS = 0b1010


def scene(shape, size):
    return mujoco.MjModel.from_xml_string(
        f"""<mujoco><option ccd_tolerance="1e-10" ccd_iterations="200"/><worldbody>
        <body mocap="true"><geom type="{shape}" size="{size}"/></body>
        <body mocap="true"><geom type="sphere" size="{TIP}"/></body>
        </worldbody></mujoco>"""
    )


def posed(model, rng):
    """The shape anywhere, turned anyhow, and a point in its neighbourhood."""
    data = mujoco.MjData(model)
    data.mocap_pos[0] = rng.uniform(-0.5, 0.5, 3)
    quat = rng.standard_normal(4)
    data.mocap_quat[0] = quat / np.linalg.norm(quat)
    data.mocap_pos[1] = data.mocap_pos[0] + rng.uniform(-0.25, 0.25, 3)
    mujoco.mj_kinematics(model, data)
    return data, data.mocap_pos[1]


@pytest.mark.parametrize(("shape", "size"), SHAPES.items())
def test_it_is_mujocos_distance_outside_of_the_solid(shape, size):
    model, rng = scene(shape, size), np.random.default_rng(0)
    outside = 0
    for _ in range(300):
        data, point = posed(model, rng)
        expected = mujoco.mj_geomDistance(model, data, 0, 1, 1.0, None)
        if expected > 0:
            outside += 1
            rows = solids(model, data, [0], PARTNERS)
            found = distance(*point, rows, 0) - TIP
            assert found == pytest.approx(expected, abs=1e-6)
    assert outside > 150


@pytest.mark.parametrize(("shape", "size"), SHAPES.items())
def test_inside_it_is_minus_the_depth(shape, size):
    """The depth of a point: what the shortest way out of it is long.

    By bisection along many directions with the distance's own sign: an upper bound
    that no direction undercuts.
    """
    model, rng = scene(shape, size), np.random.default_rng(1)
    inside = 0
    while inside < 8:
        data, point = posed(model, rng)
        rows = solids(model, data, [0], PARTNERS)
        depth = -distance(*point, rows, 0)
        if depth <= 0:
            continue
        inside += 1
        rays = rng.standard_normal((1500, 3))
        rays /= np.linalg.norm(rays, axis=1, keepdims=True)
        shorter = [distance(*(point + 0.99 * depth * ray), rows, 0) for ray in rays]
        longer = [distance(*(point + 1.15 * depth * ray), rows, 0) for ray in rays]
        assert max(shorter) < 0 < max(longer)


@pytest.mark.parametrize(("shape", "size"), SHAPES.items())
def test_a_row_has_the_partners_and_a_radius_that_contains_the_solid(shape, size):
    model, rng = scene(shape, size), np.random.default_rng(2)
    data, _ = posed(model, rng)
    (row,) = solids(model, data, [0], PARTNERS)
    assert row[2] == PARTNERS
    rays = rng.standard_normal((500, 3))
    rays *= 1.0001 * row[1] / np.linalg.norm(rays, axis=1, keepdims=True)
    beyond = [distance(*(row[3:6] + ray), row[None], 0) for ray in rays]
    assert min(beyond) > 0
    assert row[1] == pytest.approx(model.geom_rbound[0])


def test_a_cylinder_made_by_hand_is_the_one_of_a_model():
    model = scene("cylinder", SHAPES["cylinder"])
    data, _ = posed(model, np.random.default_rng(3))
    turn = data.geom_xmat[0].reshape(3, 3)
    made = cylinder(data.geom_xpos[0], turn, 0.06, 0.09, PARTNERS)
    assert made == pytest.approx(solids(model, data, [0], PARTNERS)[0])


@pytest.mark.parametrize(("shape", "size"), [("ellipsoid", "0.1 0.1 0.2")])
def test_a_geom_of_another_type_is_refused_by_name(shape, size):
    model = scene(shape, size)
    data, _ = posed(model, np.random.default_rng(4))
    with pytest.raises(InvalidChoice, match=r"mjGEOM_ELLIPSOID.*valid: mjGEOM_SPHERE"):
        solids(model, data, [0], PARTNERS)
