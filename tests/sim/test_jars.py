"""What jars of other sizes look like, and that the shipped one is the default."""

import cv2
import numpy as np
import pytest
import trimesh

from prospect_mj import paths
from prospect_mj.recording.worlds import WORLDS
from prospect_mj.sim import jar_files
from prospect_mj.sim.props import Jar

JARS = {name: world.props.jar for name, world in WORLDS.items()}
PIXEL = Jar().length / jar_files.ROWS
"""Of the texture, along the jar [m]."""


def rings(jar):
    """Radius and height (n, 2) [m] of every vertex of the mesh that is drawn."""
    text = trimesh.util.wrap_as_stream(jar_files.obj(jar).decode())
    mesh = trimesh.load(text, file_type="obj", process=False)
    x, y, z = mesh.vertices.T
    return np.column_stack([np.hypot(x, y), z])


def widest(vertices, low, high):
    between = (vertices[:, 1] > low) & (vertices[:, 1] < high)
    return vertices[between, 0].max()


def test_the_shipped_files_are_the_default_jars():
    assert jar_files.obj(Jar()) == paths.jar_obj().read_bytes()
    assert jar_files.png(Jar()) == paths.jar_png().read_bytes()


@pytest.mark.parametrize("world", ["wide-lid", "narrow-lid", "ring-label", "post"])
def test_another_jar_looks_otherwise(world):
    files = jar_files.obj(JARS[world]), jar_files.png(JARS[world])
    assert files != (jar_files.obj(Jar()), jar_files.png(Jar()))


@pytest.mark.parametrize("world", JARS)
def test_the_mesh_has_the_sizes_of_its_jar(world):
    jar = JARS[world]
    vertices, rim = rings(jar), jar.length / 2 - jar.lid_length
    ends = vertices[:, 1].min(), vertices[:, 1].max()
    assert ends == pytest.approx((-jar.length / 2, jar.length / 2), abs=1e-6)
    lid, body = widest(vertices, rim + 1e-4, 1), widest(vertices, -1, rim - 1e-4)
    assert lid == pytest.approx(jar.lid_radius, abs=1e-6)
    assert body == pytest.approx(jar.body_radius, abs=1e-6)


def test_a_recess_is_a_hole_with_a_wall_and_an_end():
    jar = JARS["post"]
    radius, height = rings(jar).T
    top, end = jar.length / 2, jar.length / 2 - jar.recess.depth
    upper = height > jar.length / 2 - jar.lid_length + 1e-6
    inside = upper & (radius < jar.recess.radius - 1e-6)
    assert height[inside] == pytest.approx(end, abs=1e-6)
    wall = upper & (np.abs(radius - jar.recess.radius) < 1e-6)
    assert {*np.round(height[wall], 6)} == {round(top, 6), round(end, 6)}


@pytest.mark.parametrize("world", JARS)
def test_label_and_lid_are_where_the_jar_has_them(world):
    jar = JARS[world]
    content = np.frombuffer(jar_files.png(jar), np.uint8)
    column = cv2.imdecode(content, cv2.IMREAD_COLOR)[:, 0, ::-1]
    for colour, (low, high) in {
        jar_files.LABEL: jar.label,
        jar_files.LID: (jar.length / 2 - jar.lid_length, jar.length / 2),
    }.items():
        rows = np.flatnonzero((column == colour).all(axis=1))
        # The first row is the top of the lid.
        found = jar.length / 2 - PIXEL * np.array([rows.max() + 1, rows.min()])
        assert found == pytest.approx((low, high), abs=PIXEL)
        assert len(rows) == pytest.approx((high - low) / PIXEL, abs=1)
