"""The category of a grasp, sample by sample."""

import numpy as np
import pytest
from scipy.special import softmax

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import (
    CategoryRecogniser,
    TrajectoryModels,
    categories,
    phase_samples,
)

MODELS = TrajectoryModels(
    weight=(0.2, 0.8),
    mean=(((0.006, 0.0), (0.005, 0.0)), ((0.012, 0.0), (0.004, 0.0))),
    deviation=(((0.001, 0.01), (0.002, 0.01)), ((0.002, 0.01), (0.001, 0.01))),
)
FELT = np.array(
    [[0.30, 0.010], [0.32, 0.0101], [0.80, 0.0080], [0.82, 0.0061], [1.40, 0.0050]]
)


def test_before_anything_is_felt_the_chances_are_the_weights():
    np.testing.assert_allclose(CategoryRecogniser(MODELS).chances, [0.2, 0.8])


def test_first_chance_is_bayes_rule_by_hand():
    def normal(x: float, mean: float, deviation: float) -> float:
        return np.exp(-0.5 * ((x - mean) / deviation) ** 2) / deviation

    joint = 0.2 * normal(0.010, 0.006, 0.001), 0.8 * normal(0.010, 0.012, 0.002)
    chances = CategoryRecogniser(MODELS).feel(0.30, 0.010)
    np.testing.assert_allclose(chances, np.array(joint) / sum(joint), rtol=1e-9)


def test_sample_by_sample_is_the_same_as_all_at_once():
    recogniser = CategoryRecogniser(MODELS)
    online = [recogniser.feel(*sample) for sample in FELT]
    samples = phase_samples(FELT)
    evidence = np.cumsum(MODELS.log_likelihoods(samples), axis=0)
    chances = softmax(evidence + np.log(MODELS.weight), axis=1)
    np.testing.assert_allclose(online, chances, atol=1e-12)
    assert recogniser.category == categories([samples], MODELS)[0]


def test_impossible_samples_leave_chances_that_sum_to_one():
    recogniser = CategoryRecogniser(MODELS)
    for number in range(50):
        chances = recogniser.feel(0.02 * (number + 1), 5.0)
    assert chances.sum() == pytest.approx(1.0)
    assert recogniser.category == 1


@pytest.mark.parametrize("sample", [(0.30, 0.01), (0.5, np.nan), (np.inf, 0.01)])
def test_bad_samples_are_refused(sample: tuple[float, float]):
    recogniser = CategoryRecogniser(MODELS)
    recogniser.feel(0.30, 0.010)
    with pytest.raises(InvalidValue):
        recogniser.feel(*sample)
