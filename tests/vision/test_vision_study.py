import numpy as np
import pytest

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.studies.learning_study import learning_study
from prospect_mj.experiment.studies.vision_study import (
    Observatory,
    VisionStudySettings,
    histogram_banks,
    record,
)

pytestmark = pytest.mark.gl


def observed(train, test, seed=11):
    """Samples to learn from and samples held out."""
    settings = VisionStudySettings(train=train, test=test, seed=seed)
    rng = np.random.default_rng(seed)
    with Observatory(settings) as observatory:
        return record(observatory, train, rng), record(observatory, test, rng)


def test_equal_seeds_give_equal_banks():
    banks = [histogram_banks(*observed(2, 1)) for _ in range(2)]
    for side in ("left", "right"):
        assert np.array_equal(banks[0].train[side], banks[1].train[side])
        assert banks[0].train[side].shape == (2, 100)
        assert banks[0].test[side].shape == (1, 100)


def test_a_study_of_nothing_is_refused():
    with pytest.raises(InvalidValue, match="train"):
        VisionStudySettings(train=0)


@pytest.mark.slow
def test_the_papers_learner_learns_from_these_pictures_as_fast_as_published():
    """Paper, section 4: about 650 trials; 250 of pretraining; over six actions."""
    study = learning_study(histogram_banks(*observed(200, 100)))
    assert 550 <= study.near_optimal <= 750
    assert 200 <= study.pretraining_near_optimal <= 300
    assert study.peak_after_switch > 5.5
    assert study.held_out_actions <= 2.05


def test_image_pair_to_features_and_pose_is_fast():
    """The fastest of many: the machine may be busy with other things."""
    train, _ = observed(30, 1)
    seconds = [sample.seconds for taken in train.values() for sample in taken]
    assert np.min(seconds) <= 0.050
