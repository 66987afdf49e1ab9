"""Clustering finds the kinds that grasps were made of."""

from pathlib import Path

import numpy as np
import pytest
from made_grasps import felt
from scipy.stats import multivariate_normal

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import (
    ClusterSettings,
    TrajectoryModels,
    categories,
    fit,
    phase_samples,
)

KINDS = ((0.0056, 1e-4, 30), (0.0090, 5e-4, 30), (0.0130, 5e-4, 60))


def made(rng: np.random.Generator) -> list[np.ndarray]:
    return [phase_samples(one) for kind in KINDS for one in felt(*kind, rng)]


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(3)


def test_kinds_that_are_apart_are_found(rng):
    found = fit(made(rng), ClusterSettings(models=3), rng).models
    means = [path[0][0] for path in found.mean]
    np.testing.assert_allclose(means, [kind[0] for kind in KINDS], rtol=0.03)
    np.testing.assert_allclose(found.weight, [0.25, 0.25, 0.5], atol=1e-6)
    expected = np.repeat([0, 1, 2], [30, 30, 60])
    np.testing.assert_array_equal(categories(made(rng), found), expected)


def test_each_step_of_the_climb_is_upwards(rng):
    trajectories = made(rng)
    likelihoods = [
        fit(
            trajectories,
            ClusterSettings(models=3, starts=1, steps=steps, tolerance=1e-12),
            np.random.default_rng(0),
        ).log_likelihood
        for steps in range(1, 12)
    ]
    assert np.all(np.diff(likelihoods) > -1e-6)
    assert likelihoods[-1] > likelihoods[0] + 1


def test_one_model_is_the_mean_and_deviation_of_all_samples(rng):
    trajectories = made(rng)
    samples = np.concatenate(trajectories)[:, :2]
    models = fit(trajectories, ClusterSettings(models=1), rng).models
    np.testing.assert_allclose(models.mean[0][0], samples.mean(0), atol=1e-12)
    np.testing.assert_allclose(models.deviation[0][0], samples.std(0), rtol=1e-9)


def test_criterion_of_one_model_is_that_of_a_normal_density(rng):
    trajectories = made(rng)
    samples = np.concatenate(trajectories)[:, :2]
    found = fit(trajectories, ClusterSettings(models=1), rng)
    density = multivariate_normal(samples.mean(0), np.diag(samples.var(0)))
    likelihood = density.logpdf(samples).sum()
    assert found.log_likelihood == pytest.approx(likelihood)
    assert found.bic == pytest.approx(4 * np.log(120) - 2 * likelihood)


def test_a_path_has_a_density_for_each_of_its_stages(rng):
    """Corrected grasps fall from a level to a lower one; others stay where they are."""
    seconds = np.array([0.30, 0.32, 0.80, 0.82])
    corrected = [
        phase_samples(np.column_stack([seconds, level + [0, 0, -0.02, -0.02]]))
        for level in rng.normal(0.025, 3e-4, 20)
    ]
    others = [phase_samples(one) for one in felt(0.006, 3e-4, 20, rng)]
    models = fit(corrected + others, ClusterSettings(models=2), rng).models
    levels = np.array(models.mean)[:, :, 0]
    np.testing.assert_allclose(levels[:, 0], [0.006, 0.025], atol=3e-4)
    # No grasp of the first model was corrected: there it expects what any may feel.
    np.testing.assert_allclose(levels[:, 1], [0.005, 0.005], atol=3e-4)
    found = categories(corrected + others, models)
    np.testing.assert_array_equal(found, np.repeat([1, 0], 20))


def test_criterion_prefers_the_true_number_of_kinds_to_fewer(rng):
    trajectories = made(rng)
    bics = [fit(trajectories, ClusterSettings(models=k), rng).bic for k in (1, 2, 3)]
    assert bics[2] < bics[1] < bics[0]


def test_no_deviation_falls_below_the_floor():
    level = np.column_stack([0.3 + 0.02 * np.arange(3), np.full(3, 0.0056)])
    alike = [phase_samples(level)] * 20
    others = [
        phase_samples(one) for one in felt(0.012, 1e-3, 20, np.random.default_rng(1))
    ]
    scale = np.concatenate(alike + others)[:, :2].std(axis=0)
    settings = ClusterSettings(models=2, floor=0.1)
    models = fit(alike + others, settings, np.random.default_rng(0)).models
    np.testing.assert_allclose(models.deviation[0][0], 0.1 * scale, rtol=1e-6)


def test_equal_grasps_are_no_trouble():
    alike = [np.tile([0.01, 0.0, 0.0], (3, 1))] * 5
    models = fit(alike, ClusterSettings(models=2), np.random.default_rng(0)).models
    np.testing.assert_allclose(models.mean, np.tile([0.01, 0.0], (2, 2, 1)), atol=1e-12)


def test_whole_trajectories_belong_to_a_model_not_single_samples():
    """A sample in between goes with the rest of its grasp."""
    means = (((0.0, 0.0),) * 2, ((1.0, 0.0),) * 2)
    pair = TrajectoryModels((0.5, 0.5), means, (((0.3, 1.0),) * 2,) * 2)
    grasp = np.array([[0.0, 0.0, 0], [0.6, 0.0, 0], [0.1, 0.0, 0]])
    np.testing.assert_array_equal(categories([grasp], pair), [0])
    np.testing.assert_array_equal(categories(list(grasp[:, None]), pair), [0, 1, 0])


def test_too_few_grasps_are_refused(rng):
    with pytest.raises(
        InvalidValue, match="number of trajectories is 2; expected >= 3"
    ):
        fit(made(rng)[:2], ClusterSettings(models=3), rng)


def test_models_come_back_from_their_file(rng, tmp_path: Path):
    models = fit(made(rng), ClusterSettings(models=2), rng).models
    models.write(tmp_path / "models.json")
    assert TrajectoryModels.read(tmp_path / "models.json") == models


STILL = "[[[0, 0], [0, 0]]]"
WIDE = "[[[1, 1], [1, 1]]]"


@pytest.mark.parametrize(
    ("content", "why"),
    [
        ("", "it is not JSON"),
        ("[]", "its fields are no numbers"),
        ('{"weight": [1]}', "it has no 'mean'"),
        ('{"weight": [1], "mean": [[0, 0]], "deviation": [[1, 1]]}', "its fields are"),
        (f'{{"weight": [1], "mean": {STILL}, "deviation": {STILL}}}', "above 0"),
        (f'{{"weight": [NaN], "mean": {STILL}, "deviation": {WIDE}}}', "finite"),
        (f'{{"weight": [1, 2], "mean": {STILL}, "deviation": {WIDE}}}', "shapes"),
        (f'{{"weight": [5], "mean": {STILL}, "deviation": {WIDE}}}', "a sum of 1"),
        (f'{{"weight": ["a"], "mean": {STILL}, "deviation": {WIDE}}}', "its fields"),
    ],
)
def test_a_file_without_models_is_told_in_one_line(
    tmp_path: Path, content: str, why: str
):
    path = tmp_path / "models.json"
    path.write_text(content)
    with pytest.raises(InvalidValue) as told:
        TrajectoryModels.read(path)
    assert str(path) in str(told.value)
    assert why in str(told.value)
    assert "\n" not in str(told.value)


def test_a_file_that_is_not_there_is_told_in_one_line(tmp_path: Path):
    with pytest.raises(InvalidValue, match="No such file or directory"):
        TrajectoryModels.read(tmp_path / "nowhere.json")
