"""What each grey level contributes to the choice of the hand."""

import numpy as np
import pytest
from ideal_env import counts_per_orientation

from prospect_mj.actions.action import Action
from prospect_mj.agent import (
    FeatureSettings,
    LinearQ,
    LinearSettings,
    Observation,
    StateFeatureGenerator,
)
from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.haptics import n_features, n_haptic
from prospect_mj.experiment.portraits.decisive_bins import MadeUpMind
from prospect_mj.experiment.run.config import TrainConfig

UNSCALED = FeatureSettings(normalisation="unit_sum")


def pictures(rng, n=7):
    return {side: rng.integers(0, 50, (n, N_BINS)) for side in ("left", "right")}


def learner(rng, categories=0):
    learned = LinearQ(LinearSettings(n_features=n_features(categories)))
    learned.weights[:] = rng.normal(size=learned.weights.shape)
    return learned


@pytest.mark.parametrize("reading", ["product", "one_hot"])
@pytest.mark.parametrize("normalisation", ["energy", "max_bin", "unit_sum"])
def test_contributions_add_up_to_what_turning_the_jar_changes(reading, normalisation):
    rng = np.random.default_rng(4)
    generator = StateFeatureGenerator(FeatureSettings(reading, normalisation))
    mind = MadeUpMind.of(learner(rng), generator, pictures(rng))
    turned = mind.preferences["left"] - mind.preferences["right"]
    assert mind.contributions.sum() == pytest.approx(turned, abs=1e-12)
    assert abs(turned) > 1e-3


def test_contributions_by_hand():
    counts = {side: np.zeros((1, N_BINS), int) for side in ("left", "right")}
    counts["left"][0, :2] = 3, 1
    counts["right"][0, :2] = 1, 3
    learned = LinearQ()
    learned.weights[Action.GRASP_LEFT, 0] = 5.0
    learned.weights[Action.GRASP_RIGHT, 1] = -2.0
    learned.weights[Action.GRASP_LEFT, -1] = 100.0
    mind = MadeUpMind.of(learned, StateFeatureGenerator(UNSCALED), counts)
    # (5 - 0) (3/4 - 1/4) and (0 + 2) (1/4 - 3/4); the constant 100 cancels.
    np.testing.assert_allclose(mind.contributions[:2], [2.5, -1.0])
    assert not mind.contributions[2:].any()
    assert mind.preferences["left"] == pytest.approx(100 + 0.75 * 5 + 0.25 * 2)


def test_nothing_is_decided_by_what_looks_alike_or_is_worth_the_same():
    rng = np.random.default_rng(5)
    learned, shown = learner(rng), pictures(rng)
    generator = StateFeatureGenerator(UNSCALED)
    alike = {"left": shown["left"], "right": shown["left"][::-1]}
    contributions = MadeUpMind.of(learned, generator, alike).contributions
    np.testing.assert_allclose(contributions, 0, atol=1e-15)
    learned.weights[Action.GRASP_RIGHT] = learned.weights[Action.GRASP_LEFT]
    assert not MadeUpMind.of(learned, generator, shown).contributions.any()


def test_exchanging_hands_and_sides_leaves_contributions_as_they_are():
    rng = np.random.default_rng(6)
    learned, shown = learner(rng), pictures(rng)
    generator = StateFeatureGenerator()
    before = MadeUpMind.of(learned, generator, shown).contributions
    learned.weights[[0, 1]] = learned.weights[[1, 0]]
    exchanged = {"left": shown["right"], "right": shown["left"]}
    after = MadeUpMind.of(learned, generator, exchanged).contributions
    np.testing.assert_allclose(after, before, atol=1e-15)


@pytest.mark.parametrize("categories", [0, 2])
def test_q_values_are_means_over_the_pictures(categories):
    rng = np.random.default_rng(7)
    learned, shown = learner(rng, categories), pictures(rng)
    generator = StateFeatureGenerator(categories=categories)
    mind = MadeUpMind.of(learned, generator, shown)
    assert mind.q_values["right"].shape == (6, len(mind.states))
    assert len(mind.states) == n_haptic(categories)
    for column, state in enumerate(mind.states):
        one_by_one = [
            learned.q_values(Observation.of(generator.generate(counts, *state)))
            for counts in shown["right"]
        ]
        mean = np.mean(one_by_one, axis=0)
        np.testing.assert_allclose(mind.q_values["right"][:, column], mean)


def test_weights_are_in_the_features_order():
    learned = LinearQ()
    learned.weights[:] = np.arange(6 * 303).reshape(6, 303)
    rng = np.random.default_rng(8)
    mind = MadeUpMind.of(learned, StateFeatureGenerator(), pictures(rng))
    assert mind.weights[2, 1, 7] == learned.weights[2, 107]
    assert mind.weights[5, 2, 99] == learned.weights[5, 299]


def test_a_trained_learner_prefers_the_hand_on_the_lids_side(view):
    run = view(TrainConfig(trials=700, seed=1))
    counts = {s: one[None] for s, one in counts_per_orientation().items()}
    mind = MadeUpMind.of(run.learner, StateFeatureGenerator(), counts)
    assert mind.preferences["left"] > 0 > mind.preferences["right"]
    # Only bins 60 to 99 differ: nothing else may decide.
    assert not mind.contributions[:60].round(12).any()
    assert mind.contributions[60:].sum() > 0
