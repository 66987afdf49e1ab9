"""What was discovered: features and weights of learners made by hand, and pixels."""

import numpy as np
import pytest
import small_study
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from prospect_mj.actions.action import Action
from prospect_mj.agent import DiscoverySettings, LearnerSettings, LinearQ
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.discovery.detector import Detector
from prospect_mj.agent.discovery.feature import Feature
from prospect_mj.agent.features import N_BINS
from prospect_mj.experiment.development.study import found, learners, pictures
from prospect_mj.experiment.development.study.found import CHOICE, CONTEXTS, LEVELS
from prospect_mj.recording.hands import NONE, NUMBERS, RIGHT
from prospect_mj.recording.recording import Recording
from prospect_mj.vision.histogram import intensity_histogram

GRASP = NONE, Action.GRASP_RIGHT
V = {"left": np.repeat([0.2, 0.0], 50), "right": np.repeat([0.0, 0.2], 50)}
"""The lid on the left is dark, on the right bright."""


def discoverer(**features):
    """A learner with such features, by context."""
    learner = DiscoveryQ(DiscoverySettings())
    for name, ranges in features.items():
        two = np.full(2, 5)
        made = [Detector(Feature(*one), 0.1, 1.0, two, two) for one in ranges]
        learner.contexts.put(CONTEXTS[name], made)
    return learner


def test_contexts_are_those_of_the_dominant_hand():
    assert CONTEXTS["grasp"] == GRASP
    assert CONTEXTS["insertion"] == (RIGHT, Action.INSERT_RIGHT)
    assert CONTEXTS["swap"] == (RIGHT, Action.SWAP_RIGHT_TO_LEFT)


def test_a_dark_range_speaks_for_the_dark_side_whatever_its_sign():
    dark = found.signs(discoverer(grasp=[(10, 20, 0, 0)]), "grasp", V)
    assert set(dark[10:20]) == {1.0}
    assert np.count_nonzero(dark) == 10
    bright = found.signs(discoverer(grasp=[(70, 71, 0, 0)]), "grasp", V)
    assert np.flatnonzero(bright) == 70
    assert bright[70] == -1.0


def test_a_difference_speaks_for_both_sides():
    says = found.signs(discoverer(grasp=[(10, 20, 80, 90)]), "grasp", V)
    other_way_round = found.signs(discoverer(grasp=[(80, 90, 10, 20)]), "grasp", V)
    assert (says[10:20] == 1).all()
    assert (says[80:90] == -1).all()
    np.testing.assert_array_equal(says, other_way_round)


def test_features_of_a_context_are_averaged_and_others_left_out():
    learner = discoverer(grasp=[(10, 12, 0, 0), (11, 13, 0, 0)], swap=[(3, 4, 0, 0)])
    says = found.signs(learner, "grasp", V)
    assert says[9:14].tolist() == [0.0, 0.5, 1.0, 0.5, 0.0]
    assert says[3] == 0.0
    assert found.signs(learner, "insertion", V) is None
    assert [one.context for one in found.ranges(learner)] == ["grasp", "grasp", "swap"]


def linear(left, right):
    """A learner with such weights (100,) of the histogram for grasps by each hand."""
    learner = LinearQ(LearnerSettings(), rng=np.random.default_rng(0))
    learner.weights[Action.GRASP_LEFT, :N_BINS] = left
    learner.weights[Action.GRASP_RIGHT, :N_BINS] = right
    return learner


@pytest.fixture
def known(monkeypatch):
    """What is found in learners made by hand, two of each kind."""
    bins = np.arange(N_BINS)
    known = {
        "discovery": [discoverer(insertion=[(5, 6, 0, 0)]), discoverer()],
        "linear": [linear(3.0 * bins, 0.0), linear(0.0, bins)],
        "replay": [linear(bins, 2.0 * bins), linear(0.0, 0.0)],
    }
    monkeypatch.setattr(
        found, "_learned", lambda recording, study, name, runs: known[name]
    )
    return found.find(small_study.recordings().standard, small_study.SETTINGS)


def test_runs_without_a_feature_are_not_averaged(known):
    insertion, grasp, swap = known.says[:3]
    assert [one.context for one in (insertion, grasp, swap)] == list(CONTEXTS)
    assert (insertion.runs, grasp.runs, swap.runs) == (1, 0, 0)
    assert np.abs(insertion.levels).sum() == 1.0
    assert not grasp.levels.any()
    assert known.example == found.ranges(discoverer(insertion=[(5, 6, 0, 0)]))


def test_weights_are_differences_of_both_hands_relative_to_the_largest(known):
    linear_, replay = known.says[3:]
    assert {linear_.context, replay.context} == {CHOICE}
    np.testing.assert_allclose(linear_.levels, np.arange(N_BINS) / 99)
    np.testing.assert_allclose(replay.levels, -np.arange(N_BINS) / 99)


def test_the_table_has_every_level_of_every_learner(known):
    assert known.table.schema == LEVELS
    rows = known.table.to_pylist()
    assert len(rows) == N_BINS * len(known.says)
    assert [row["level"] for row in rows[:N_BINS]] == list(range(N_BINS))
    assert rows[5]["says"] == known.says[0].levels[5]
    assert rows[5]["left"] == known.v["left"][5]


def test_learners_are_those_of_the_study():
    recording = small_study.recordings().standard
    learned = found._learned(recording, small_study.SETTINGS, "linear", 2)
    assert [one.settings for one in learned] == [learners.LEARNERS["linear"]] * 2
    assert (learned[0].weights != learned[1].weights).any()


@given(
    arrays.arrays(np.uint8, st.tuples(st.integers(1, 40), st.just(3))),
    st.sampled_from(["automatic", "fixed"]),
)
def test_every_pixel_is_in_the_bin_that_counted_it(pixels, gain):
    histogram = intensity_histogram(pixels, gain)
    level = pictures.bins(pixels, histogram)
    np.testing.assert_array_equal(np.bincount(level, minlength=100), histogram)
    grey = pixels.astype(int) @ np.array([299, 587, 114])
    for a, b in zip(level, grey, strict=True):
        assert (level[grey == b] == a).all()
        assert (level[grey < b] <= a).all()


@pytest.mark.gl
def test_a_presentation_presented_again_has_the_recorded_histogram():
    recording = Recording.load()
    shown = recording.presentations
    for picture in pictures.jar_pictures(recording):
        first = int(np.argmax(shown.lid == NUMBERS[picture.orientation]))
        on_jar = picture.level[picture.level != pictures.NO_JAR]
        counted = np.bincount(on_jar, minlength=N_BINS)
        np.testing.assert_array_equal(counted, shown.histogram[first])
        assert picture.image.shape == (*picture.level.shape, 3)
        assert picture.level[0].max() == pictures.NO_JAR
