"""Spheres that cover a geom contain it, and stand out by no more than is said."""

import mujoco
import numpy as np
import pytest

from prospect_mj.errors import InvalidChoice
from prospect_mj.planning.sphere_cover import bounding_sphere, cover

GEOM = mujoco.mjtGeom
SIZES = [(0.055, 0.165), (0.042, 0.038), (0.04, 0.015), (0.009, 0.035), (0.03, 0.0005)]
"""Radius and half length [m], from slender to flat."""


def points_in(kind, radius, half, rng, n=4000):
    """Random points (n, 3) [m] in a geom along z, half of them on its surface."""
    turn = rng.uniform(0, 2 * np.pi, n)
    out = np.where(np.arange(n) % 2, radius, radius * np.sqrt(rng.uniform(0, 1, n)))
    around = np.column_stack([out * np.cos(turn), out * np.sin(turn), np.zeros(n)])
    if kind == GEOM.mjGEOM_SPHERE:
        half = 0.0
    heights = rng.uniform(-half, half, n)
    heights[: n // 4] = np.sign(heights[: n // 4]) * half
    side = around + np.outer(heights, [0, 0, 1])
    if kind == GEOM.mjGEOM_CYLINDER:
        return side
    ball = rng.standard_normal((n, 3))
    ball *= radius / np.linalg.norm(ball, axis=1, keepdims=True)
    ends = ball + np.outer(np.sign(ball[:, 2]) * half, [0, 0, 1])
    return ends if half == 0 else np.concatenate([side, ends])


def on_axis(along):
    return np.column_stack([np.zeros((len(along), 2)), along[:, 0]]), along[:, 1]


KINDS = (GEOM.mjGEOM_SPHERE, GEOM.mjGEOM_CAPSULE, GEOM.mjGEOM_CYLINDER)


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
@pytest.mark.parametrize("size", SIZES)
def test_every_point_of_the_geom_is_in_one_of_the_spheres(kind, size):
    points = points_in(kind, *size, np.random.default_rng(0))
    centres, radii = on_axis(cover(int(kind), np.array([*size, 0.0])))
    away = np.linalg.norm(points[:, None] - centres, axis=2) - radii
    assert away.min(axis=1).max() < 1e-12


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.name)
@pytest.mark.parametrize("size", SIZES)
def test_across_the_axis_it_stands_out_by_a_twelfth_of_the_radius_at_most(kind, size):
    """Where that is less than what spheres 2 cm apart stand out: by as much as those.

    With spheres d apart: sqrt(r^2 + (d/2)^2) - r.
    """
    radius = size[0]
    _, radii = on_axis(cover(int(kind), np.array([*size, 0.0])))
    allowed = max(radius / 12, np.hypot(radius, 0.01) - radius)
    assert 0 <= radii.max() - radius <= allowed


@pytest.mark.parametrize("size", SIZES)
def test_a_capsules_cover_ends_where_the_capsule_ends(size):
    radius, half = size
    along = cover(int(GEOM.mjGEOM_CAPSULE), np.array([*size, 0.0]))
    assert along[[0, -1], 0] == pytest.approx([-half, half])
    excess = along[-1].sum() - (half + radius)
    assert excess == pytest.approx(along[0, 1] - radius)


def test_a_long_geom_gets_as_many_spheres_as_its_slenderness_asks_for():
    for half in (0.1, 0.4):
        along = cover(int(GEOM.mjGEOM_CAPSULE), np.array([0.05, half, 0.0]))
        apart = np.diff(along[:, 0])
        assert apart == pytest.approx(apart[0])
        assert 0.5 * 0.8 * 0.05 < apart[0] <= 0.8 * 0.05 + 1e-12


@pytest.mark.parametrize("kind", [GEOM.mjGEOM_BOX, GEOM.mjGEOM_MESH, GEOM.mjGEOM_PLANE])
def test_another_geom_is_refused_by_name(kind):
    with pytest.raises(InvalidChoice, match=rf"{kind.name}.*valid: sphere, capsule"):
        cover(int(kind), np.array([0.1, 0.1, 0.1]))


def test_a_bounding_sphere_contains_all_and_touches_one():
    rng = np.random.default_rng(1)
    for _ in range(50):
        spheres = np.column_stack(
            [rng.uniform(-1, 1, (7, 3)), rng.uniform(0.01, 0.5, 7)]
        )
        bound = bounding_sphere(spheres)
        reach = np.linalg.norm(spheres[:, :3] - bound[:3], axis=1) + spheres[:, 3]
        assert reach.max() == pytest.approx(bound[3])
        alone = bounding_sphere(spheres[:1])
        assert alone == pytest.approx(spheres[0])
