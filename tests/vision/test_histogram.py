import numpy as np
import pytest

from prospect_mj.errors import InvalidChoice
from prospect_mj.vision.histogram import N_BINS, intensity_histogram


def grey(levels):
    return np.repeat(np.asarray(levels, np.uint8)[:, None], 3, axis=1)


def test_fixed_gain_bins_are_grey_levels():
    counts = intensity_histogram(grey([0, 2, 3, 128, 255, 255]), "fixed")
    assert counts.nonzero()[0].tolist() == [0, 1, 50, 99]
    assert counts[[0, 1, 50, 99]].tolist() == [2, 1, 1, 2]


@pytest.mark.parametrize("gain", ["automatic", "fixed"])
def test_counts_every_pixel(gain):
    pixels = np.random.default_rng(0).integers(0, 256, (3000, 3), dtype=np.uint8)
    counts = intensity_histogram(pixels, gain)
    assert counts.shape == (N_BINS,)
    assert counts.sum() == 3000


def test_automatic_gain_forgets_brightness_and_fixed_gain_does_not():
    levels = np.random.default_rng(1).integers(40, 121, 5000)
    for gain, alike in (("automatic", True), ("fixed", False)):
        dim = intensity_histogram(grey(levels), gain)
        bright = intensity_histogram(grey(2 * levels), gain)
        cosine = dim @ bright / np.linalg.norm(dim) / np.linalg.norm(bright)
        assert (cosine > 0.9) == alike


def test_intensity_weighs_the_channels_as_the_eye_does():
    pure = 255 * np.eye(3, dtype=np.uint8)
    bins = [intensity_histogram(pure[i : i + 1], "fixed").argmax() for i in range(3)]
    assert bins == [29, 58, 11]


def test_nothing_seen_is_an_empty_histogram():
    assert intensity_histogram(np.empty((0, 3), np.uint8), "automatic").sum() == 0


def test_a_uniform_object_fills_one_bin():
    counts = intensity_histogram(grey([90] * 50), "automatic")
    assert counts.max() == 50


def test_an_unknown_gain_is_refused():
    with pytest.raises(InvalidChoice, match=r"'auto'.*automatic, fixed"):
        intensity_histogram(grey([1]), "auto")
