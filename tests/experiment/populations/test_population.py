"""Many runs: their chance, their protocol, and what they learn."""

from dataclasses import fields, replace

import numpy as np
import pytest
from ideal_recording import ideal, recording

from prospect_mj.agent import LinearSettings
from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.errors import InvalidChoice, InvalidValue, RecordingError
from prospect_mj.experiment.populations.optimum import optimum
from prospect_mj.experiment.populations.plain import learn_plainly
from prospect_mj.experiment.populations.population import (
    Population,
    run_population,
)
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.experiment.populations.speed import measured_speed
from prospect_mj.experiment.populations.strategies import Strategy, easy
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.grower import presentation_rng
from prospect_mj.recording.recording import Recording
from prospect_mj.task.presentation import ORIENTATIONS

SMALL = PopulationSettings(runs=5, seed=3)


@pytest.fixture(scope="module")
def good():
    return recording(left=(ideal,) * 4, right=(ideal,) * 3)


def assert_equal_populations(one, other, runs=slice(None), trials=slice(None)):
    """The first has the same in the runs and trials that the other has."""
    for field in fields(one)[1:]:
        first, second = getattr(one, field.name), getattr(other, field.name)
        np.testing.assert_array_equal(first[runs, trials], second, field.name)


def test_a_population_is_that_of_the_plain_learner(good):
    scenario = Scenario(80, pretrain=30)
    compiled = run_population(good, scenario, SMALL)
    programme = Programme(good, scenario, SMALL)
    rows = [learn_plainly(programme, number).row for number in range(SMALL.runs)]
    assert_equal_populations(compiled, Population.of(scenario, rows))
    assert compiled.scenario == scenario


def test_threads_do_not_change_a_population(good):
    alone, together = (
        run_population(good, Scenario(50), SMALL, jobs=jobs) for jobs in (1, 3)
    )
    assert_equal_populations(alone, together)


def test_a_run_is_the_same_in_a_larger_study_and_a_longer_one(good):
    larger = run_population(good, Scenario(90), replace(SMALL, runs=8))
    small = run_population(good, Scenario(60), SMALL)
    assert_equal_populations(larger, small, slice(5), slice(60))


def test_seeds_and_runs_differ(good):
    first, other = (
        run_population(good, Scenario(60), replace(SMALL, seed=seed)) for seed in (0, 1)
    )
    assert (first.n_actions != other.n_actions).any()
    assert len(np.unique(first.n_actions, axis=0)) == SMALL.runs


def drawn_by(shown, scenario, seed):
    """Of ten runs, what comes of each source of chance, as bytes."""
    settings = replace(SMALL, seed=seed, image_noise=0.05)
    programme = Programme(shown, scenario, settings)
    runs = [programme.run(number) for number in range(10)]
    free = slice(scenario.pretrain, None)
    return {
        "learner": {run.trials.draws.tobytes() for run in runs},
        "single draws": {float(run.trials.draws[0, 0, 0]) for run in runs},
        "presentations": {run.trials.root[free].tobytes() for run in runs},
        "weights": {run.learner.weights.tobytes() for run in runs},
        "noise": {run.histograms.tobytes() for run in runs},
        "learning": {float(run.rng.random()) for run in runs},
    }


def test_no_draw_is_common_to_two_scenarios_runs_or_seeds(good):
    scenarios = (
        Scenario(80),
        Scenario(80, 10),
        Scenario(80, 10, "left"),
        Scenario(80, 1),
    )
    drawn = [drawn_by(good, s, seed) for s in scenarios for seed in range(3)]
    for source in drawn[0]:
        different = set.union(*(study[source] for study in drawn))
        assert len(different) == 10 * len(drawn), source


def test_sources_of_chance_do_not_depend_on_each_other(good):
    plain = Programme(good, Scenario(60), SMALL).run(0)
    other = replace(
        SMALL,
        image_noise=0.1,
        pictures="one_per_side",
        learner=LinearSettings(initial_sd=2.0),
    )
    changed = Programme(good, Scenario(60), other).run(0)
    np.testing.assert_array_equal(changed.trials.root, plain.trials.root)
    np.testing.assert_array_equal(changed.trials.draws, plain.trials.draws)
    np.testing.assert_allclose(changed.learner.weights, 100 * plain.learner.weights)


def test_draws_are_not_those_of_a_recordings_presentations(good):
    config, size = RecordingConfig(seed=SMALL.seed), 64
    recorded = [
        presentation_rng(config, side, number).random(size)
        for side in ORIENTATIONS
        for number in range(5)
    ]
    programme = Programme(good, Scenario(30), SMALL)
    own = [programme.run(number).trials.draws.ravel() for number in range(5)]
    assert not set(np.concatenate(recorded)) & set(np.concatenate(own))


@pytest.mark.parametrize("dominant", ["left", "right"])
def test_pretraining_shows_the_dominant_side_only(good, dominant):
    scenario = Scenario(300, pretrain=100, dominant=dominant)
    shown = run_population(good, scenario, SMALL)
    is_easy = easy(shown.lid, dominant)
    assert is_easy[:, :100].all()
    # 1000 throws of a fair coin; 5 standard deviations.
    assert np.mean(is_easy[:, 100:]) == pytest.approx(0.5, abs=0.08)
    assert set(np.unique(shown.lid)) == {LEFT, RIGHT}


def test_presentations_of_a_side_are_equally_likely(good):
    run = Programme(good, Scenario(7000), SMALL).run(0)
    for lid, number in ((LEFT, 4), (RIGHT, 3)):
        roots, times = np.unique(run.trials.root[run.lid == lid], return_counts=True)
        assert (
            roots.tolist()
            == good.presentations.root[good.presentations.lid == lid].tolist()
        )
        assert times == pytest.approx(3500 / number, rel=0.15)


def test_pictures_are_those_of_the_presentations(good):
    run = Programme(good, Scenario(30), SMALL).run(0)
    shown = np.searchsorted(good.presentations.root, run.trials.root)
    np.testing.assert_array_equal(
        run.histograms[run.trials.image], good.presentations.histogram[shown]
    )
    energy = np.sum(run.trials.visual**2, axis=1)
    np.testing.assert_allclose(energy, 2.4)


def test_one_picture_per_side_leaves_outcomes_as_they_are(good):
    scenario, once = Scenario(200), replace(SMALL, pictures="one_per_side")
    shown = [Programme(good, scenario, settings) for settings in (SMALL, once)]
    pictures = {LEFT: set(), RIGHT: set()}
    for number in range(20):
        recorded, alike = (programme.run(number) for programme in shown)
        np.testing.assert_array_equal(recorded.trials.root, alike.trials.root)
        np.testing.assert_array_equal(recorded.trials.draws, alike.trials.draws)
        assert len(np.unique(recorded.trials.image)) > 2
        for side, seen in pictures.items():
            (image,) = np.unique(alike.trials.image[alike.lid == side])
            assert good.presentations.lid[image] == side
            seen.add(int(image))
    # Another one for every run: all of the few that there are.
    assert [len(seen) for seen in pictures.values()] == [4, 3]


def test_noise_is_as_large_as_asked_and_new_in_every_trial(good):
    quiet = Programme(good, Scenario(400), SMALL)
    noisy = Programme(good, Scenario(400), replace(SMALL, image_noise=0.01))
    clean, run = quiet.run(0).trials, noisy.run(0)
    np.testing.assert_array_equal(clean.root, run.trials.root)
    np.testing.assert_array_equal(clean.draws, run.trials.draws)
    added = run.histograms - clean.visual[clean.image]
    # Bins that noise would take below zero aren't asked.
    free = clean.visual[clean.image] > 0.05
    assert np.std(added[free]) == pytest.approx(0.01, rel=0.03)
    assert np.mean(added[free]) == pytest.approx(0, abs=0.001)
    assert run.histograms.min() >= 0
    assert len(np.unique(run.trials.visual, axis=0)) == 400
    np.testing.assert_allclose(np.sum(run.trials.visual**2, axis=1), 2.4)


def test_initial_weights_are_drawn_as_asked(good):
    runs = {
        sd: Programme(
            good, Scenario(), replace(SMALL, learner=LinearSettings(initial_sd=sd))
        ).run(1)
        for sd in (0.0, 3.0)
    }
    assert runs[3.0].learner.weights.std() == pytest.approx(3, rel=0.1)
    assert not runs[0.0].learner.weights.any()
    np.testing.assert_array_equal(runs[0.0].trials.draws, runs[3.0].trials.draws)


def test_what_a_population_knows_fits_together(good):
    known = run_population(good, Scenario(200), replace(SMALL, runs=20))
    assert known.n_actions.dtype == known.strategy.dtype == known.lid.dtype == np.int8
    assert (known.n_actions[~known.solved] == 10).all()
    assert (known.strategy[~known.solved] == Strategy.OTHER).all()
    optimal = known.strategy == Strategy.OPTIMAL
    assert (known.first_hand[optimal] == known.lid[optimal]).all()
    corrected = np.isin(known.strategy, [Strategy.EARLY, Strategy.LATE])
    assert (known.first_hand[corrected] == LEFT + RIGHT - known.lid[corrected]).all()
    least = {Strategy.OPTIMAL: 2, Strategy.EARLY: 3, Strategy.LATE: 4}
    for strategy, actions in least.items():
        used = known.strategy == strategy
        assert known.n_actions[used].min() == actions


def test_learners_become_prospective(good):
    known = run_population(good, Scenario(1000), PopulationSettings(runs=20))
    assert known.n_actions[:, :10].mean() > 7.5
    # Exploring costs the best policy a tenth of an action, and the learner more.
    floor = optimum(good).exploring.mean
    last = known.n_actions[:, -100:].mean()
    assert floor == pytest.approx(2.1, abs=0.02)
    # Standard error 0.01.
    assert floor - 0.03 < last < floor + 0.2
    assert np.mean(known.strategy[:, -100:] == Strategy.OPTIMAL) > 0.9


def test_the_compiled_learner_is_the_faster_one(good):
    speed = measured_speed(good, Scenario(100), SMALL, runs=20)
    # It is sixty times as fast; what one run has against another is chance.
    assert speed.kernel > 20 * speed.plain > 0


def test_a_dominant_hand_misleads_at_first_in_recorded_physics():
    scenario = Scenario(pretrain=400)
    known = run_population(Recording.load(), scenario, PopulationSettings(runs=20))
    is_easy = easy(known.lid, "right")[:, 400:450]
    first = known.n_actions[:, 400:450]
    assert known.n_actions[:, 350:400].mean() < 2.4
    assert first[~is_easy].mean() > first[is_easy].mean() + 3
    assert known.n_actions[:, -50:].mean() < 2.6


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        ({"runs": 0}, "runs"),
        ({"runs": 10**9}, "runs"),
        ({"seed": -1}, "seed"),
        ({"max_actions": 0}, "actions per trial"),
        ({"max_actions": 101}, "actions per trial"),
        ({"bootstrap_at_truncation": 1}, "bootstrap"),
        ({"image_noise": float("nan")}, "image noise"),
        ({"pictures": "none"}, "recorded, one_per_side"),
        ({"learner": LinearSettings(n_features=7)}, "features"),
        ({"learner": LinearSettings(n_actions=5)}, "actions"),
        ({"shaping": ("dance:3",)}, "dance"),
        ({"supervisor": "strict"}, "strict"),
    ],
)
def test_settings_that_make_no_population_are_named(settings, named):
    with pytest.raises((InvalidValue, InvalidChoice), match=named):
        PopulationSettings(**settings)


def test_scenarios_that_make_no_run_are_named(good):
    with pytest.raises(InvalidValue, match="trials"):
        Scenario(0)
    with pytest.raises(InvalidValue, match="pretraining trials is 11"):
        Scenario(10, 11)
    with pytest.raises(InvalidChoice, match="left, right"):
        Scenario(dominant="both")
    with pytest.raises(InvalidValue, match="jobs"):
        run_population(good, Scenario(10), SMALL, jobs=0)


def test_a_recording_that_is_too_shallow_is_refused():
    shallow = recording(4, left=(ideal,), right=(ideal,))
    with pytest.raises(RecordingError, match="complete to 10 executed actions"):
        run_population(shallow, Scenario(10), SMALL)
    enough = replace(SMALL, max_actions=4)
    assert run_population(shallow, Scenario(10), enough).n_actions.max() == 4
