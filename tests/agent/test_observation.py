import numpy as np
import pytest
from told import HOLDINGS, seen, step

from prospect_mj.agent import FeatureSettings, Observation, StateFeatureGenerator
from prospect_mj.agent.haptics import (
    categories_of,
    haptic_state,
    holding_of,
    n_features,
    n_haptic,
)
from prospect_mj.errors import InvalidValue


@pytest.mark.parametrize("reading", ["product", "one_hot"])
@pytest.mark.parametrize("haptic", range(3))
def test_picture_and_hand_are_read_off_the_features(reading, haptic):
    generator = StateFeatureGenerator(FeatureSettings(reading=reading))
    counts = np.random.default_rng(1).integers(0, 50, 100)
    phi = generator.generate(counts, HOLDINGS[haptic])
    observed = Observation.of(phi, 1)
    assert (observed.haptic, observed.orientation) == (haptic, 1)
    np.testing.assert_array_equal(observed.visual, generator.scaled_histogram(counts))
    assert observed.features is phi


@pytest.mark.parametrize("categories", [1, 2, 4])
def test_categories_are_read_off_longer_features(categories):
    v = np.random.default_rng(2).random(100)
    found = set()
    for hand in range(2):
        for category in range(categories):
            bits = np.zeros(2 + categories)
            bits[[hand, 2 + category]] = 1
            phi = np.concatenate([v, np.outer(bits, v).ravel(), bits, [1]])
            assert len(phi) == n_features(categories)
            observed = Observation.of(phi)
            assert observed.haptic == 1 + hand * categories + category
            np.testing.assert_array_equal(observed.visual, v)
            found.add(observed.haptic)
    assert found == set(range(1, n_haptic(categories)))
    free = np.concatenate([v, np.zeros((2 + categories) * 101), [1]])
    assert Observation.of(free).haptic == 0


@pytest.mark.parametrize("length", [0, 100, 302, 304, 405])
def test_features_of_no_haptic_states_are_refused(length):
    with pytest.raises(InvalidValue, match=f"number of features is {length}"):
        Observation.of(np.zeros(length))


def test_haptic_states_are_numbered_each_once():
    assert (n_haptic(0), n_features(0)) == (3, 303)
    assert [haptic_state(holding, 7, 0) for holding in range(3)] == [0, 1, 2]
    for categories in range(2, 6):
        states = [
            haptic_state(h, c, categories) for h in (1, 2) for c in range(categories)
        ]
        assert states == list(range(1, n_haptic(categories)))
        assert categories_of(n_haptic(categories)) == categories
        holdings = [holding_of(state, categories) for state in states]
        assert holdings == [1] * categories + [2] * categories


def test_a_transition_is_the_last_where_the_trial_ends():
    ended = step(seen(), 0, seen(), terminated=True)
    going_on = step(seen(), 0, seen())
    assert ended.is_last
    assert not going_on.is_last
    assert going_on._replace(truncated=True).is_last
