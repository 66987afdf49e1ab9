import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from prospect_mj.agent import FeatureSettings, Observation, StateFeatureGenerator
from prospect_mj.errors import ProspectError

HOLDINGS = ("none", "left", "right")
READINGS = ("product", "one_hot")
NORMALISATIONS = ("energy", "max_bin", "unit_sum")

counts_arrays = arrays(
    np.float64, 100, elements=st.floats(0, 1e300, allow_subnormal=False)
)


def counts(**bins):
    histogram = np.zeros(100)
    for name, value in bins.items():
        histogram[int(name[1:])] = value
    return histogram


# |(3, 4)| = 5, so the scale for |v|^2 = 2.4 is sqrt(2.4)/5.
V = np.sqrt(2.4) / 5 * counts(b7=3, b99=4)
ZERO = np.zeros(100)


@pytest.mark.parametrize(
    ("reading", "holding", "expected"),
    [
        ("product", "none", [V, ZERO, ZERO, [0, 0, 1]]),
        ("product", "left", [V, V, ZERO, [1, 0, 1]]),
        ("product", "right", [V, ZERO, V, [0, 1, 1]]),
        ("one_hot", "none", [V, ZERO, ZERO, [0, 0, 1]]),
        ("one_hot", "left", [ZERO, V, ZERO, [1, 0, 1]]),
        ("one_hot", "right", [ZERO, ZERO, V, [0, 1, 1]]),
    ],
)
def test_feature_vector_by_hand(reading, holding, expected):
    generator = StateFeatureGenerator(FeatureSettings(reading=reading))
    features = generator.generate(counts(b7=3, b99=4), holding)
    assert features.dtype == np.float64
    np.testing.assert_allclose(features, np.concatenate(expected), rtol=1e-15)


@pytest.mark.parametrize(
    ("reading", "state", "expected"),
    [
        ("product", ("none", 1), [V, ZERO, ZERO, ZERO, ZERO, [0, 0, 0, 0, 1]]),
        ("product", ("left", 1), [V, V, ZERO, ZERO, V, [1, 0, 0, 1, 1]]),
        ("product", ("right", 0), [V, ZERO, V, V, ZERO, [0, 1, 1, 0, 1]]),
        ("one_hot", ("none", 0), [V, ZERO, ZERO, ZERO, ZERO, [0, 0, 0, 0, 1]]),
        ("one_hot", ("left", 0), [ZERO, V, ZERO, V, ZERO, [1, 0, 1, 0, 1]]),
        ("one_hot", ("right", 1), [ZERO, ZERO, V, ZERO, V, [0, 1, 0, 1, 1]]),
    ],
)
def test_two_categories_by_hand(reading, state, expected):
    generator = StateFeatureGenerator(FeatureSettings(reading=reading), 2)
    features = generator.generate(counts(b7=3, b99=4), *state)
    np.testing.assert_allclose(features, np.concatenate(expected), rtol=1e-15)
    low, high = generator.bounds
    assert low.shape == high.shape == features.shape
    assert ((low <= features) & (features <= high)).all()
    assert (high[-5:] == 1).all()


def test_states_are_in_the_order_of_their_numbers():
    assert [*StateFeatureGenerator().states] == [(h, 0) for h in HOLDINGS]
    generator = StateFeatureGenerator(categories=3)
    seen = (Observation.of(generator.generate(V, *s)) for s in generator.states)
    assert [one.haptic for one in seen] == list(range(7))


@pytest.mark.parametrize("category", [-1, 3, 1.0, True, None])
def test_a_category_that_is_none_is_refused_where_a_hand_holds(category):
    generator = StateFeatureGenerator(categories=3)
    with pytest.raises(ProspectError, match="haptic category is"):
        generator.generate(V, "left", category)
    assert not generator.generate(V, "none", category)[100:-1].any()
    StateFeatureGenerator().generate(V, "left", category)


@pytest.mark.parametrize("categories", [-1, 101, 2.0])
def test_numbers_of_categories_are_checked(categories):
    with pytest.raises(ProspectError, match="haptic categories is"):
        StateFeatureGenerator(categories=categories)


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        (FeatureSettings(energy=1.0), (0.6, 0.8)),
        (FeatureSettings(normalisation="max_bin"), (0.75, 1.0)),
        (FeatureSettings(normalisation="unit_sum"), (3 / 7, 4 / 7)),
    ],
)
def test_normalisations_by_hand(settings, expected):
    visual = StateFeatureGenerator(settings).scaled_histogram(counts(b0=3, b1=4))
    np.testing.assert_allclose(visual[:2], expected, rtol=1e-15)
    assert not visual[2:].any()


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("normalisation", NORMALISATIONS)
@given(histogram=counts_arrays, holding=st.sampled_from(HOLDINGS))
def test_features_are_finite_and_within_bounds(
    reading, normalisation, histogram, holding
):
    settings = FeatureSettings(reading=reading, normalisation=normalisation)
    generator = StateFeatureGenerator(settings)
    features = generator.generate(histogram, holding)
    low, high = generator.bounds
    assert np.isfinite(low).all()
    assert np.isfinite(high).all()
    assert (low <= features).all()
    assert (features <= high).all()


@given(histogram=counts_arrays, energy=st.floats(0.01, 100))
def test_energy_is_the_squared_norm(histogram, energy):
    generator = StateFeatureGenerator(FeatureSettings(energy=energy))
    squared_norm = np.sum(generator.scaled_histogram(histogram) ** 2)
    assert squared_norm == pytest.approx(energy if histogram.any() else 0.0, rel=1e-12)


@given(histogram=counts_arrays.filter(np.any), factor=st.floats(1e-3, 1e3))
def test_exposure_time_of_a_pixel_count_does_not_matter(histogram, factor):
    scaled = StateFeatureGenerator().scaled_histogram
    small = histogram / histogram.max()
    np.testing.assert_allclose(
        scaled(factor * small), scaled(small), rtol=1e-12, atol=1e-300
    )


@pytest.mark.parametrize("energy", [0.3, 2.4, 7.0])
def test_bounds_hold_a_histogram_of_one_bin(energy):
    generator = StateFeatureGenerator(FeatureSettings(energy=energy))
    for value in (1, 3, 17, 4711):
        features = generator.generate(counts(b42=value), "left")
        assert (features <= generator.bounds.high).all()


def test_unseen_object_has_no_visual_features():
    features = StateFeatureGenerator().generate(ZERO, "right")
    assert np.flatnonzero(features).tolist() == [301, 302]


def test_both_readings_span_the_same_functions():
    rng = np.random.default_rng(4)
    histograms = rng.random((30, 4)) @ rng.random((4, 100))
    states = [
        [
            StateFeatureGenerator(FeatureSettings(reading=reading)).generate(
                histogram, holding
            )
            for histogram in histograms
            for holding in HOLDINGS
        ]
        for reading in READINGS
    ]
    # Pictures of 4 dimensions in 3 haptic states; of the 3 haptic features, the 90
    # states with pictures scaled to one energy leave all independent.
    for features in (*states, np.hstack(states)):
        assert np.linalg.matrix_rank(features, tol=1e-9) == 3 * 4 + 3


def test_result_does_not_share_memory_with_the_input():
    histogram = ZERO.copy()
    scaled = StateFeatureGenerator().scaled_histogram(histogram)
    scaled[0] = 1.0
    assert histogram[0] == 0.0


@pytest.mark.parametrize(
    ("histogram", "holding", "named"),
    [
        (np.ones(99), "none", "(99,)"),
        (np.ones((1, 100)), "none", "(1, 100)"),
        (np.full(100, np.nan), "none", "nan"),
        (np.full(100, np.inf), "none", "inf"),
        (np.full(100, -2.0), "none", "-2.0"),
        (np.ones(100), "both", "valid: none, left, right"),
    ],
)
def test_bad_input_is_named(histogram, holding, named):
    with pytest.raises(ProspectError) as refused:
        StateFeatureGenerator().generate(histogram, holding)
    assert named in str(refused.value)


@pytest.mark.parametrize(
    "bad",
    [
        {"reading": "sum"},
        {"normalisation": "l3"},
        {"energy": 0.0},
        {"energy": -1.0},
        {"energy": float("nan")},
        {"energy": float("inf")},
        {"energy": "much"},
    ],
)
def test_bad_settings_are_refused(bad):
    with pytest.raises(ProspectError):
        FeatureSettings(**bad)
