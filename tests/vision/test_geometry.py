"""Silhouette, view and stereo on an ideal cylinder that is drawn, not rendered."""

import cv2
import numpy as np
import pytest

from prospect_mj.sim.pinhole import Pinhole
from prospect_mj.vision.segmentation import Region
from prospect_mj.vision.silhouette import silhouette_of
from prospect_mj.vision.stereo import StereoSettings, locate
from prospect_mj.vision.view import View

RADIUS, LENGTH = 0.04, 0.16
SIZE = (320, 240)


def eye_at(y):
    """An eye at (0, y, 0.85) that looks at (0.6, 0, 0.2)."""
    position = np.array([0.0, y, 0.85])
    forward = np.array([0.6, 0.0, 0.2]) - position
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, [0, 0, 1.0])
    right /= np.linalg.norm(right)
    rotation = np.column_stack([right, np.cross(forward, right), forward])
    return Pinhole(position, rotation, 620.0, SIZE)


def axis_of(yaw):
    return np.array([-np.sin(yaw), np.cos(yaw), 0.0])


def drawn(eye, centre, axis):
    """Mask and painted image of a closed cylinder with bright and dark rings."""
    rings = np.linspace(-LENGTH / 2, LENGTH / 2, 400)
    around = np.linspace(0, 2 * np.pi, 400)
    side = np.cross(axis, [0, 0, 1.0])
    circle = RADIUS * (
        np.outer(np.cos(around), side) + np.outer(np.sin(around), [0, 0, 1.0])
    )
    mask, image = np.zeros(SIZE[::-1], np.uint8), np.zeros(SIZE[::-1], np.float32)
    ends = [centre + s * LENGTH / 2 * axis + circle for s in (-1, 1)]
    hull = cv2.convexHull(eye.project(np.vstack(ends)).astype(np.float32))
    cv2.fillPoly(mask, [np.rint(16 * hull).astype(np.int32)], 1, shift=4)
    to_eye = eye.position - centre
    near = circle[circle @ to_eye > 0.2 * RADIUS * np.linalg.norm(to_eye)]
    for ring in rings:
        shade = 120 + 80 * np.sin(2 * np.pi * ring / 0.05)
        columns, rows = np.rint(eye.project(centre + ring * axis + near)).astype(int).T
        image[rows, columns] = shade
    return mask, cv2.GaussianBlur(cv2.dilate(image, np.ones((3, 3))), (5, 5), 0)


def view_of(eye, centre, axis):
    mask, image = drawn(eye, centre, axis)
    return View(eye, silhouette_of(mask, Region(0, 0, *SIZE)), image)


@pytest.mark.parametrize("yaw", [-0.15, 0.0, 0.1])
@pytest.mark.parametrize("shift", [(0.0, 0.0, 0.0), (0.02, -0.02, 0.01)])
def test_stereo_locates_a_cylinder_it_knows_nothing_of(yaw, shift):
    centre, axis = np.array([0.6, 0.0, 0.2]) + shift, axis_of(yaw)
    views = [view_of(eye_at(y), centre, axis) for y in (0.05, -0.05)]
    found = locate(*views, StereoSettings())
    assert np.linalg.norm(found.position - centre) < 0.004
    assert np.degrees(np.arccos(found.axis @ axis)) < 0.5
    assert found.length == pytest.approx(LENGTH, abs=0.004)
    assert found.radii == pytest.approx([RADIUS] * 2, abs=0.0015)
    assert found.correlation > 0.95
    assert found.disagreement < np.radians(1.0)


def test_surface_points_project_onto_their_pixels_and_lie_one_radius_off():
    centre, axis = np.array([0.6, 0.01, 0.2]), axis_of(0.1)
    view = view_of(eye_at(0.05), centre, axis)
    pixels = view.silhouette.even_pixels(10, 3.0)[::50]
    surface = view.surface(pixels, centre, axis)
    inner = surface.turn < 0.8
    assert inner.sum() > 50
    assert view.eye.project(surface.points) == pytest.approx(pixels, abs=1e-6)
    offsets = surface.points[inner] - centre
    distances = np.linalg.norm(np.cross(offsets, axis), axis=1)
    # A pixel is 1.4 mm there, and the drawn mask is half a pixel too wide.
    assert distances == pytest.approx(RADIUS, abs=0.0018)


def test_pictures_of_different_surfaces_do_not_correlate():
    centre, axis = np.array([0.6, 0.0, 0.2]), axis_of(0.0)
    left, right = (view_of(eye_at(y), centre, axis) for y in (0.05, -0.05))
    noise = np.random.default_rng(0).normal(120, 40, right.grey.shape)
    other = View(right.eye, right.silhouette, noise.astype(np.float32))
    assert locate(left, other, StereoSettings()).correlation < 0.5
