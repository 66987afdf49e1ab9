"""How alike pictures are: geometry of vectors made by hand."""

import numpy as np
import pytest
import small_study

from prospect_mj.experiment.development.study.looks import histograms, looks, table

X, Y, Z = np.eye(3)


def test_equal_pictures_have_a_cosine_of_one_and_no_noise():
    found = looks({"left": np.stack([X, X]), "right": np.stack([X, X])})
    assert found == pytest.approx((1.0, 1.0, 0.0))


def test_pictures_without_a_grey_level_in_common_have_a_cosine_of_nought():
    found = looks({"left": np.stack([X, X]), "right": np.stack([Y, Z])})
    assert found.between == 0.0
    assert found.within == pytest.approx((1.0 + 0.0) / 2)


def test_the_angle_between_two_pictures_is_their_cosine():
    turned = np.cos(0.3) * X + np.sin(0.3) * Y
    found = looks({"left": X[None], "right": turned[None]})
    assert found.between == pytest.approx(np.cos(0.3))
    assert found.within == 1.0


@pytest.mark.parametrize("deviation", [0.05, 0.3])
def test_noise_is_the_deviation_of_a_bin_relative_to_it(deviation):
    rng = np.random.default_rng(0)
    mean = rng.uniform(0.5, 1.5, 100)
    rows = mean * (1 + deviation * rng.standard_normal((1000, 100)))
    found = looks({"left": rows, "right": rows})
    assert found.noise == pytest.approx(deviation, rel=0.02)
    # Independent noise in all bins turns a picture as far as it lengthens it.
    assert found.within == pytest.approx(1 / (1 + deviation**2), rel=0.01)


def test_each_world_of_the_table_is_looked_at_itself():
    recordings = small_study.recordings()
    worlds = ("noisy", "standard", "ring-label")
    rows = table(recordings, worlds).to_pylist()
    assert [row["world"] for row in rows] == list(worlds)
    assert {row["pictures"] for row in rows} == {4}
    for row in rows:
        by_side = histograms(recordings.by_world[row["world"]])
        assert looks(by_side) == (row["between"], row["within"], row["noise"])
        for rows_of_side in by_side.values():
            np.testing.assert_allclose((rows_of_side**2).sum(axis=1), 2.4)
    noises = {row["world"]: row["noise"] for row in rows}
    assert noises["standard"] < min(noises["noisy"], noises["ring-label"])
