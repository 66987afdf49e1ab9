"""Models of halves agree where the number of kinds is right."""

import numpy as np
import pytest
from made_grasps import felt

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import ClusterSettings, agreement, phase_samples
from prospect_mj.haptics.agreement import adjusted_rand


def made(rng: np.random.Generator) -> tuple[list[np.ndarray], np.ndarray]:
    """Three kinds, a grasp of each in every group."""
    kinds = [felt(mean, 3e-4, 20, rng) for mean in (0.005, 0.010, 0.020)]
    trajectories = [phase_samples(one) for kind in kinds for one in kind]
    return trajectories, np.tile(np.arange(20), 3)


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(5)


@pytest.mark.parametrize(
    ("one", "other", "index"),
    [
        ([0, 0, 1, 1], [1, 1, 0, 0], 1.0),
        ([0, 0, 0, 0], [2, 2, 2, 2], 1.0),
        ([0, 0, 1, 1], [0, 0, 0, 0], 0.0),
        # Pairs together: 1 in both, 4 and 3 in each, of 15; by chance 4 x 3 / 15.
        ([0, 0, 0, 1, 1, 2], [0, 0, 1, 1, 2, 2], (1 - 0.8) / (3.5 - 0.8)),
        ([0, 0, 1, 1], [0, 1, 0, 1], (0 - 2 / 3) / (2 - 2 / 3)),
    ],
)
def test_agreement_of_two_sortings(one, other, index):
    assert adjusted_rand(np.array(one), np.array(other)) == pytest.approx(index)


def test_unrelated_sortings_agree_by_chance(rng):
    found = [adjusted_rand(*rng.integers(0, 4, (2, 200))) for _ in range(50)]
    assert abs(np.mean(found)) < 0.01


def test_halves_agree_best_at_the_number_of_kinds(rng):
    found = [
        agreement(*made(rng), ClusterSettings(models=k, starts=5), 4, rng).mean
        for k in (3, 5)
    ]
    assert found[0] == 1.0
    assert found[1] < 0.9


def test_a_group_is_never_split(rng):
    """Each half has one of both groups, however many grasps that is."""
    trajectories, _ = made(rng)
    groups = np.repeat([0, 1], 20)
    one = ClusterSettings(models=1, starts=1)
    assert agreement(trajectories[:40], groups, one, 2, rng) == (1.0, 0.0)
    few = np.repeat([0, 1], [39, 1])
    with pytest.raises(InvalidValue, match="number of trajectories is 1; expected >="):
        agreement(trajectories[:40], few, ClusterSettings(models=2), 2, rng)


def test_one_split_has_no_error_and_is_refused(rng):
    with pytest.raises(InvalidValue, match="splits"):
        agreement(*made(rng), ClusterSettings(models=2), 1, rng)
