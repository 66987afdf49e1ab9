from dataclasses import replace

import numpy as np
import pytest
from ideal_env import counts_per_orientation

from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.experiment.studies.histogram_banks import HistogramBanks
from prospect_mj.experiment.studies.learning_study import StudySettings, learning_study


def banks(**vectors):
    bank = {side: vector[None] for side, vector in vectors.items()}
    return HistogramBanks(bank, bank)


def test_two_vectors_learn_as_fast_as_published():
    # Reference for |h|^2 = 2.4, |dh|^2 = .95: 620 trials; 250 of pretraining; peak 6-7.
    study = learning_study(
        banks(**counts_per_orientation(2.4, 0.95)), StudySettings(runs=60)
    )
    assert study.near_optimal == pytest.approx(620, abs=50)
    assert study.pretraining_near_optimal == pytest.approx(250, abs=30)
    assert 5.8 < study.peak_after_switch < 7
    assert study.baseline_curve[0] == pytest.approx(8.3, abs=0.3)
    assert study.baseline_curve[-10:].mean() == pytest.approx(2.2, abs=0.05)
    assert study.held_out_actions == 2
    assert study.held_out_optimal == 1


def test_equal_pictures_cannot_tell_the_hands_apart():
    same = np.arange(100.0)
    study = learning_study(banks(left=same, right=same), StudySettings(runs=10))
    assert study.near_optimal is None
    assert study.pretraining_near_optimal is not None
    assert study.held_out_optimal <= 0.5
    assert study.held_out_actions > 2.4


def test_held_out_pictures_of_the_other_side_mislead():
    vectors = counts_per_orientation()
    train = {side: vector[None] for side, vector in vectors.items()}
    test = {"left": train["right"], "right": train["left"]}
    study = learning_study(HistogramBanks(train, test), StudySettings(runs=5))
    assert study.held_out_optimal == 0


def test_study_repeats_and_seeds_differ():
    small = StudySettings(runs=2, trials=100, pretrain=40)
    vectors = banks(**counts_per_orientation())
    first, again, other = (
        learning_study(vectors, settings).baseline_curve
        for settings in (small, small, replace(small, seed=1))
    )
    np.testing.assert_array_equal(first, again)
    assert (first != other).any()


def test_banks_survive_the_disk(tmp_path):
    rng = np.random.default_rng(0)
    bank = {side: rng.random((3, 100)) for side in ("left", "right")}
    test = {side: rng.random((2, 100)) for side in ("left", "right")}
    HistogramBanks(bank, test).save(tmp_path / "banks.npz")
    loaded = HistogramBanks.load(tmp_path / "banks.npz")
    for side in ("left", "right"):
        np.testing.assert_array_equal(loaded.train[side], bank[side])
        np.testing.assert_array_equal(loaded.test[side], test[side])


def test_bad_banks_and_settings_are_named(tmp_path):
    good = {side: np.ones((2, 100)) for side in ("left", "right")}
    with pytest.raises(InvalidValue, match=r"right bank.*\(2, 99\)"):
        HistogramBanks(good, {**good, "right": np.ones((2, 99))})
    with pytest.raises(InvalidValue, match="left bank"):
        HistogramBanks({"right": good["right"]}, good)
    np.savez(tmp_path / "other.npz", something=np.ones(3))
    (tmp_path / "text.npz").write_text("something else")
    for name in ("other.npz", "text.npz", "missing.npz"):
        with pytest.raises(InvalidValue, match=name):
            HistogramBanks.load(tmp_path / name)
    with pytest.raises(InvalidValue, match="runs"):
        StudySettings(runs=0)
    with pytest.raises(InvalidValue, match="pretraining"):
        StudySettings(trials=100, pretrain=80)
    with pytest.raises(InvalidChoice, match="left, right"):
        StudySettings(dominant="both")
