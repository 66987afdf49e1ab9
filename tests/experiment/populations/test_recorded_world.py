"""Populations whose world changes, whose learners differ, or feel what they grasp."""

import math
from dataclasses import replace

import numpy as np
import pytest
from ideal_recording import clumsy, ideal, one_handed, recording

from prospect_mj.agent import (
    DiscoverySettings,
    LinearSettings,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.errors import InvalidChoice, InvalidValue, RunFolderError
from prospect_mj.experiment.populations.population import learn, run_population
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.recorded_world import RecordedWorld
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.spread import Spread
from prospect_mj.experiment.populations.store import Store
from prospect_mj.experiment.populations.strategies import Strategy

KINDS = (LinearSettings, ReplaySettings, TableSettings, DiscoverySettings)
FEW = ("lid", "n_actions", "solved", "strategy", "first_hand")


@pytest.fixture(scope="module")
def good():
    return recording(left=(ideal,) * 4, right=(ideal,) * 3)


def other_end(state, action, lid):
    """Where the lid doesn't fit but the other end does."""
    return ideal(state, action, {"left": "right", "right": "left"}[lid])


@pytest.fixture(scope="module")
def reversed_world():
    return recording(left=(other_end,) * 2, right=(other_end,) * 5)


@pytest.mark.parametrize("kind", KINDS)
def test_until_its_world_changes_a_population_is_that_of_one_world(
    good, reversed_world, kind
):
    settings = PopulationSettings(runs=3, learner=kind(), image_noise=0.02)
    alone = run_population(good, Scenario(60, 20), settings)
    scenario = Scenario(60, 20, then_trials=40)
    changed = run_population(good, scenario, settings, then=reversed_world)
    for name in FEW:
        assert getattr(changed, name).shape == (3, 100)
        np.testing.assert_array_equal(
            getattr(changed, name)[:, :60], getattr(alone, name), name
        )


def test_a_changed_world_presents_its_own_trials(good, reversed_world):
    scenario, settings = Scenario(50, 20, then_trials=2000), PopulationSettings()
    run = Programme(good, scenario, settings, reversed_world).run(0)
    n_nodes, shown = len(good.nodes.child), reversed_world.presentations
    assert (run.trials.root[:50] < n_nodes).all()
    roots, times = np.unique(run.trials.root[50:] - n_nodes, return_counts=True)
    np.testing.assert_array_equal(roots, np.sort(shown.root))
    # Either side is as likely, and each of its presentations.
    is_left = shown.lid[np.argsort(shown.root)] == LEFT
    assert times[is_left] == pytest.approx(500, rel=0.15)
    assert times[~is_left] == pytest.approx(200, rel=0.25)
    images = run.trials.image[50:] - len(good.presentations.lid)
    np.testing.assert_array_equal(run.trials.root[50:] - n_nodes, shown.root[images])
    np.testing.assert_array_equal(
        run.histograms[run.trials.image[50:]], shown.histogram[images]
    )
    np.testing.assert_array_equal(run.lid[50:], shown.lid[images])


def test_a_table_learns_the_reversed_rule(good, reversed_world):
    settings = PopulationSettings(runs=20, learner=TableSettings())
    scenario = Scenario(300, then_trials=300)
    changed = run_population(good, scenario, settings, then=reversed_world)
    optimal = changed.strategy == Strategy.OPTIMAL
    assert optimal[:, 250:300].mean() > 0.9
    # The same first hand is the wrong one now, and is given up.
    own = changed.first_hand == changed.lid
    assert own[:, 300:310].mean() > 0.8
    assert own[:, -50:].mean() < 0.1
    assert changed.n_actions[:, -50:].mean() < 2.4
    # The strategies are told by the hand that is right in the world of the trial.
    assert (changed.strategy[:, -50:] == Strategy.OPTIMAL).mean() > 0.8
    first = changed.strategy[:, 300:310]
    assert (first != Strategy.OPTIMAL).mean() > 0.8


def test_which_end_goes_down_is_told_by_outcomes(good, reversed_world):
    assert not RecordedWorld(good).lid_first
    assert RecordedWorld(reversed_world).lid_first
    unable = recording(left=(clumsy, one_handed), right=(one_handed, clumsy))
    assert not RecordedWorld(unable).lid_first


def test_worlds_are_as_many_as_the_scenario_has(good):
    with pytest.raises(InvalidValue, match="number of worlds is 1; expected 2"):
        run_population(good, Scenario(10, then_trials=5))
    with pytest.raises(InvalidValue, match="number of worlds is 2; expected 1"):
        run_population(good, Scenario(10), then=good)
    with pytest.raises(InvalidValue, match="second world is -1"):
        Scenario(10, then_trials=-1)


def test_every_learner_draws_its_own_parameters(good):
    spread = (
        Spread("least_rate", 0.002, 0.02, logarithmic=True),
        Spread("surprise", 0.25, 0.75),
        Spread("memory", 10, 12),
    )
    learner = DiscoverySettings(candidates=7)
    settings = PopulationSettings(learner=learner, spread=spread)
    programme = Programme(good, Scenario(10), settings)
    drawn = [programme.run(number).learner.settings for number in range(600)]
    rates = np.log([one.least_rate for one in drawn])
    low, high = math.log(0.002), math.log(0.02)
    assert low <= rates.min() < rates.max() <= high
    # Of a uniform distribution: 600 draws, four standard errors.
    assert rates.mean() == pytest.approx((low + high) / 2, abs=0.11)
    surprises = [one.surprise for one in drawn]
    assert np.mean(surprises) == pytest.approx(0.5, abs=0.025)
    assert 0.25 <= min(surprises) < 0.27 < 0.73 < max(surprises) < 0.75
    memories, times = np.unique([one.memory for one in drawn], return_counts=True)
    assert memories.tolist() == [10, 11, 12]
    assert times == pytest.approx(200, rel=0.25)
    assert {one.candidates for one in drawn} == {7}


def test_what_is_drawn_for_parameters_leaves_all_else_as_it_is(good):
    settings = PopulationSettings(learner=LinearSettings())
    spread = replace(settings, spread=(Spread("step_size", 0.001, 0.01),))
    plain, own = (
        Programme(good, Scenario(20), each).run(3) for each in (settings, spread)
    )
    np.testing.assert_array_equal(plain.trials.draws, own.trials.draws)
    np.testing.assert_array_equal(plain.learner.weights, own.learner.weights)
    assert plain.rng.random() == own.rng.random()


@pytest.mark.parametrize(
    ("spread", "named"),
    [
        (Spread("leest_rate", 0, 1), "leest_rate"),
        (Spread("n_features", 1, 3), "n_features"),
        (Spread("name", 1, 3), "name"),
        (Spread("step_size", -1, 1), "step_size is -1"),
        (Spread("discount", 0.5, 2), "discount is 2"),
    ],
)
def test_spreads_that_make_no_learner_are_named(spread, named):
    with pytest.raises((InvalidValue, InvalidChoice), match=named):
        PopulationSettings(spread=(spread,))


def test_ranges_that_are_none_are_named():
    with pytest.raises(InvalidValue, match="highest step_size is 1; expected"):
        Spread("step_size", 2, 1)
    with pytest.raises(InvalidValue, match="lowest step_size is 0; expected above 0"):
        Spread("step_size", 0, 1, logarithmic=True)
    whole = (Spread("replays", 1, 9, logarithmic=True),)
    with pytest.raises(InvalidChoice, match="logarithmic replays"):
        PopulationSettings(learner=ReplaySettings(), spread=whole)


def felt(recorded):
    """The hand that grasps, as two categories: nothing that the bits don't tell."""
    holding = np.asarray(recorded.nodes.holding)
    return RecordedWorld(recorded, 2, (holding == RIGHT).astype(np.int64))


def test_a_table_that_feels_no_more_than_the_hands_learns_alike(good):
    settings = PopulationSettings(runs=5, learner=TableSettings(initial_sd=0.0))
    learner = TableSettings(initial_sd=0.0, n_haptic=5)
    told = replace(settings, learner=learner, categories=2)
    plain = run_population(good, Scenario(100), settings)
    feels = run_population(felt(good), Scenario(100), told)
    for name in FEW:
        np.testing.assert_array_equal(getattr(plain, name), getattr(feels, name), name)
    assert feels.splits.shape == (5, 5, 6)


def test_categories_are_those_of_the_world_and_of_the_learner(good):
    with pytest.raises(InvalidValue, match="number of features is 303; expected 505"):
        PopulationSettings(categories=2)
    with pytest.raises(InvalidValue, match="haptic states is 3; expected 5"):
        PopulationSettings(learner=TableSettings(), categories=2)
    told = PopulationSettings(learner=TableSettings(n_haptic=5), categories=2)
    with pytest.raises(InvalidValue, match="haptic categories is 0; expected 2"):
        run_population(good, Scenario(10), told)
    with pytest.raises(InvalidValue, match="haptic category is 2; expected 0 to 1"):
        RecordedWorld(good, 2, np.full(len(good.nodes.child), 2))
    with pytest.raises(InvalidValue, match="shape of haptic categories"):
        RecordedWorld(good, 2, np.zeros(3, np.int64))
    with pytest.raises(InvalidValue, match="haptic categories is 2"):
        RecordedWorld(good, 2)


def test_only_discovery_splits_contexts(good):
    quick = DiscoverySettings(least_rate=0.05, surprise=0.3, guard_probability=0.1)
    settings = PopulationSettings(runs=4, learner=quick)
    found = run_population(good, Scenario(150), settings)
    assert found.splits.dtype == np.int32
    assert -1 == found.splits.min() < found.splits.max() < 150
    for kind in KINDS[:-1]:
        plain = run_population(good, Scenario(20), replace(settings, learner=kind()))
        assert (plain.splits == -1).all()
    programme = Programme(good, Scenario(150), settings)
    np.testing.assert_array_equal(learn(programme, 2).splits, found.splits[2])


def test_a_late_split_has_the_number_of_its_trial(tmp_path, good):
    trial = np.iinfo(np.int16).max + 1
    late = DiscoverySettings(forced_splits=(("insert", trial),), memory=2)
    scenario, settings = Scenario(trial + 1), PopulationSettings(runs=1, learner=late)
    for _ in ("learned", "read"):
        found = Store(tmp_path, good, 1).get(scenario, settings).population
        assert found.splits[0, 0].tolist() == [-1, -1, -1, -1, trial, trial]


def test_worlds_splits_and_spreads_are_kept(tmp_path, good, reversed_world):
    clumsy_world = recording(left=(clumsy,), right=(clumsy, ideal))
    quick = DiscoverySettings(least_rate=0.05, surprise=0.3, guard_probability=0.1)
    settings = PopulationSettings(
        runs=3, learner=quick, spread=(Spread("surprise", 0.2, 0.4),)
    )
    scenario, ticks = Scenario(90, then_trials=60), []
    kept = Store(tmp_path, good, 2)
    first = kept.get(scenario, settings, reversed_world, lambda: ticks.append(1))
    assert len(ticks) == settings.runs
    again = Store(tmp_path, good, 1).get(scenario, settings, reversed_world)
    assert again.earlier
    for name in (*FEW, "splits"):
        one, other = (getattr(p.population, name) for p in (first, again))
        assert one.dtype == other.dtype
        np.testing.assert_array_equal(one, other, name)
    assert (first.population.splits >= 0).any()
    kept.get(scenario, settings, clumsy_world)
    kept.get(Scenario(90), settings)
    kept.get(scenario, replace(settings, spread=()), reversed_world)
    kept.get(scenario, replace(settings, failed_actions="suppressed"), reversed_world)
    told = PopulationSettings(runs=2, learner=TableSettings(n_haptic=5), categories=2)
    Store(tmp_path, felt(good), 1).get(Scenario(10), told)
    assert len(list(tmp_path.iterdir())) == 6
    (tmp_path / "file").touch()
    with pytest.raises(RunFolderError):
        Store(tmp_path / "file", good, 1)
