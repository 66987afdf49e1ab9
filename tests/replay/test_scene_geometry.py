"""Shapes in Rerun are those that MuJoCo draws."""

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from prospect_mj.replay import geometry
from prospect_mj.sim.scene import SceneSettings, compile_scene


@pytest.fixture(scope="module")
def model():
    return compile_scene(SceneSettings())


@pytest.fixture(scope="module")
def shapes(model):
    return dict(geometry.shapes(model))


def numbers(batch):
    return np.array(batch.as_arrow_array().to_pylist())


def test_every_visible_geom_has_a_shape(model, shapes):
    visible = np.flatnonzero(model.geom_group != 3)
    kinds = {(int(model.geom_bodyid[g]), int(model.geom_type[g])) for g in visible}
    assert len(shapes) == len(kinds)
    drawn = sum(
        len(shape.colors or []) for shape in shapes.values() if hasattr(shape, "colors")
    )
    meshes = np.count_nonzero(model.geom_type[visible] == mujoco.mjtGeom.mjGEOM_MESH)
    assert drawn == len(visible) - meshes


def test_a_capsule_begins_where_its_axis_does(model, shapes):
    geom = model.geom("left_upper")
    capsule = shapes["scene/left_link3/capsule"]
    number = [
        g
        for g in range(model.ngeom)
        if model.geom_bodyid[g] == geom.bodyid[0] and model.geom_type[g] == geom.type[0]
    ].index(geom.id)
    start = numbers(capsule.translations)[number]
    length = numbers(capsule.lengths)[number]
    turn = Rotation.from_quat(numbers(capsule.quaternions)[number])
    ends = sorted([start[2], (start + turn.apply([0, 0, length]))[2]])
    middle, half = geom.pos[2], geom.size[1]
    np.testing.assert_allclose(ends, [middle - half, middle + half], atol=1e-6)
    assert numbers(capsule.radii)[number] == pytest.approx(geom.size[0])


def test_the_jars_mesh_is_as_large_as_the_jar(model, shapes):
    jar = SceneSettings().props.jar
    corners = numbers(shapes["scene/jar/mesh"].vertex_positions)
    sizes = np.ptp(corners, axis=0)
    np.testing.assert_allclose(
        sizes, [2 * jar.lid_radius, 2 * jar.lid_radius, jar.length], atol=1e-3
    )
    # The lid is at the end to which its axis points.
    radii = np.hypot(corners[:, 0], corners[:, 1])
    assert radii[corners[:, 2] > 0.4 * jar.length].max() > 0.99 * jar.lid_radius
    assert radii[corners[:, 2] < -0.4 * jar.length].max() < 1.01 * jar.body_radius


def test_the_floor_is_a_plate_whose_top_is_the_plane(model, shapes):
    plate = shapes["scene/table/plane"]
    floor = model.geom("table/floor")
    centre, half = numbers(plate.centers)[0], numbers(plate.half_sizes)[0]
    np.testing.assert_allclose(centre[2] + half[2], floor.pos[2], atol=1e-6)
