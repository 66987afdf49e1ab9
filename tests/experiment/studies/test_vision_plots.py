from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from prospect_mj.experiment.studies import vision_plots
from prospect_mj.experiment.studies.vision_study import Sample
from prospect_mj.sim.camera import StereoPair
from prospect_mj.vision.look import Look

BINS = {"left": 20, "right": 80}
"""The only grey level that is seen in each orientation."""
EYE = SimpleNamespace(project=lambda points: 160 + 400 * np.asarray(points)[:, :2])


def sample(side):
    image = np.full((240, 320, 3), 10, np.uint8)
    image[100:140, 120:200] = 60
    mask = (image[..., 0] == 60).astype(np.uint8)
    histogram = np.bincount([BINS[side]], minlength=100)
    look = Look("found", "", histogram, (mask, mask), np.zeros(3), np.eye(3)[0])
    return Sample(StereoPair(image, image), look, np.zeros(3), np.eye(3)[0], 0.0)


@pytest.fixture(scope="module")
def samples():
    return {side: [sample(side) for _ in range(3)] for side in BINS}


def picture(png):
    return cv2.imdecode(np.frombuffer(png, np.uint8), cv2.IMREAD_COLOR_RGB)


def where(image, colour):
    return np.abs(image.astype(int) - colour).max(axis=-1) <= 3


def share(image, colour):
    return np.mean(where(image, colour))


def test_lifting_keeps_black_white_and_order_and_leaves_the_image_alone():
    image = np.arange(256, dtype=np.uint8).repeat(3).reshape(16, 16, 3)
    before = image.copy()
    lifted = vision_plots.lifted(image).reshape(256, 3)[:, 0].astype(int)
    assert (lifted[0], lifted[255]) == (0, 255)
    assert lifted[56] == round(255 * (56 / 255) ** (1 / 2.2)) == 128
    assert (np.diff(lifted) >= 0).all()
    np.testing.assert_array_equal(image, before)


def test_looks_shows_lifted_images(samples):
    image = picture(vision_plots.looks(samples))
    dark, bright = (vision_plots.lifted(np.uint8([grey]))[0] for grey in (10, 60))
    assert share(image, dark) > 0.3
    assert share(image, bright) > 0.02
    assert share(image, 10) < 0.001


def test_segmentation_draws_outline_and_axis(samples):
    image = picture(vision_plots.segmentation(samples, (EYE, EYE)))
    assert share(image, vision_plots._OUTLINE) > 0.0005
    assert share(image, vision_plots._POSE) > 0.0005


def test_histograms_draws_both_orientations(samples):
    image = picture(vision_plots.histograms(samples))
    for side, colour in vision_plots._COLOURS.items():
        rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
        # The edges of its single bar, higher than anything in the legend.
        edges = np.flatnonzero(where(image, rgb).sum(axis=0) > image.shape[0] / 3)
        assert edges.mean() / image.shape[1] == pytest.approx(BINS[side] / 100, abs=0.1)
