"""What was discovered: features and weights of learners made by hand, and pixels."""

from dataclasses import replace

import numpy as np
import pytest
import small_study
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from prospect_mj.actions.action import Action
from prospect_mj.agent import DiscoverySettings, LinearQ, LinearSettings
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.discovery.detector import BETTER, Detector, likelier_class
from prospect_mj.agent.discovery.feature import Feature, cumulative
from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.haptics import NONE, RIGHT
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.study import found, pictures
from prospect_mj.experiment.development.study.found import (
    CHOICE,
    CONTEXTS,
    LEVELS,
    Range,
)
from prospect_mj.experiment.development.study.learning import Laboratory
from prospect_mj.experiment.development.study.rows import population
from prospect_mj.experiment.development.study.settings import DOMINANT
from prospect_mj.experiment.populations import store
from prospect_mj.experiment.populations.population import learn, look_into
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.recording.hands import NUMBERS
from prospect_mj.recording.recording import Recording
from prospect_mj.vision.histogram import intensity_histogram

GRASP = NONE, Action.GRASP_RIGHT


def discoverer(**features):
    """A learner with such features, by context."""
    learner = DiscoveryQ(DiscoverySettings())
    for name, ranges in features.items():
        learner.contexts.put(CONTEXTS[name], [better_with(*one) for one in ranges])
    return learner


def better_with(*ranges, present=(1, 4)):
    """A detector; it counted such a feature in so many of five worse, better ones."""
    of_class = np.array(present), np.full(2, 5)
    return Detector(Feature(*ranges), 0.1, 1.0, *of_class)


def says(learner, context):
    """What each level says in each feature of a context."""
    return [one["says"] for one in found.features(learner) if one["context"] == context]


def test_contexts_are_those_of_the_dominant_hand():
    assert CONTEXTS["grasp"] == GRASP
    assert CONTEXTS["insertion"] == (RIGHT, Action.INSERT_RIGHT)
    assert CONTEXTS["swap"] == (RIGHT, Action.SWAP_RIGHT_TO_LEFT)


@pytest.mark.parametrize(
    ("context", "left"), [("insertion", -1), ("grasp", -1), ("swap", 1)]
)
def test_what_is_better_for_the_right_hand_has_the_lid_on_the_right(context, left):
    """But not where it hands over."""
    (levels,) = says(discoverer(**{context: [(10, 20, 80, 90)]}), context)
    assert set(levels[10:20]) == {left}
    assert set(levels[80:90]) == {-left}
    assert np.count_nonzero(levels) == 20


@pytest.mark.parametrize("present", [(1, 4), (4, 1), (0, 1), (5, 4)])
@pytest.mark.parametrize("ranges", [(10, 20, 80, 90), (80, 90, 10, 20)])
def test_a_feature_is_drawn_as_the_learner_reads_it(ranges, present):
    """Rightly or wrongly: it is there where level 12 is, or level 85."""
    learner, one = discoverer(), better_with(*ranges, present=present)
    learner.contexts.put(GRASP, [one])
    (levels,) = says(learner, "grasp")
    for level in (12, 85):
        picture = cumulative(np.eye(N_BINS)[level])
        is_better = likelier_class([one], picture) == BETTER
        assert (levels[level] < 0) == is_better


def test_a_feature_that_is_as_frequent_in_both_classes_says_nothing():
    learner = discoverer()
    learner.contexts.put(GRASP, [better_with(1, 2, 0, 0, present=(2, 2))])
    assert not says(learner, "grasp")[0].any()


def linear(left, right):
    """A learner with such weights (100,) of the histogram for grasps by each hand."""
    learner = LinearQ(LinearSettings(), rng=np.random.default_rng(0))
    learner.weights[Action.GRASP_LEFT, :N_BINS] = left
    learner.weights[Action.GRASP_RIGHT, :N_BINS] = right
    return learner


BINS = np.arange(N_BINS)
LEARNERS = {
    "discovery": [
        discoverer(swap=[(10, 12, 0, 0), (11, 13, 0, 0)], insertion=[(5, 6, 7, 8)]),
        discoverer(swap=[(12, 13, 0, 0)]),
        discoverer(),
    ],
    "linear": [linear(3.0 * BINS, 0.0), linear(0.0, BINS), linear(BINS, 0.0)],
    "replay": [linear(BINS, 2.0 * BINS), linear(0.0, 0.0), linear(0.0, 0.0)],
}
"""Made by hand, one of each kind for each run."""


@pytest.fixture
def laboratory(tmp_path, monkeypatch):
    """Whose learners end as they were made by hand."""

    def look_into(world, scenario, settings, see, jobs):
        return [see(one) for one in LEARNERS[settings.learner.name]]

    monkeypatch.setattr(store, "look_into", look_into)
    return Laboratory(tmp_path, small_study.recordings(), 2, lambda line: None)


@pytest.fixture
def known(laboratory):
    return found.find(laboratory, small_study.SETTINGS)


def test_features_of_a_run_are_averaged_then_runs_that_have_any(known):
    insertion, grasp, swap = known.says[:3]
    assert [one.context for one in (insertion, grasp, swap)] == list(CONTEXTS)
    assert (insertion.runs, grasp.runs, swap.runs) == (1, 0, 2)
    assert np.flatnonzero(insertion.levels).tolist() == [5, 7]
    assert not grasp.levels.any()
    assert swap.levels[9:14].tolist() == [0.0, 0.25, 0.5, 0.75, 0.0]


def test_features_of_the_first_run_are_told_as_ranges(known):
    assert known.example == [
        Range("insertion", 5, 6, 7, 8, 0.1),
        Range("swap", 10, 12, 0, 0, 0.1),
        Range("swap", 11, 13, 0, 0, 0.1),
    ]


def test_weights_are_differences_of_both_hands_relative_to_the_largest(known):
    linear_, replay = known.says[3:]
    assert {linear_.context, replay.context} == {CHOICE}
    np.testing.assert_allclose(linear_.levels, BINS / 99)
    np.testing.assert_allclose(replay.levels, -BINS / 99)


def test_the_table_has_every_level_of_every_learner(known):
    assert known.table.schema == LEVELS
    rows = known.table.to_pylist()
    assert len(rows) == N_BINS * len(known.says)
    assert [row["level"] for row in rows[:N_BINS]] == list(range(N_BINS))
    assert rows[5]["says"] == known.says[0].levels[5]
    assert rows[5]["left"] == known.v["left"][5]


def test_learners_learn_once_and_are_read_the_same(laboratory, known, monkeypatch):
    monkeypatch.setattr(store, "look_into", None)
    again = found.find(laboratory, small_study.SETTINGS)
    assert again.table.equals(known.table)
    assert again.example == known.example
    assert laboratory.unused() == []


def test_learners_are_those_of_the_study():
    settings = replace(population(small_study.SETTINGS, LinearSettings()), runs=2)
    given = small_study.recordings().standard, DOMINANT, settings
    seen = look_into(*given, lambda one: (one.settings, one.weights.copy()), jobs=2)
    programme = Programme(*given)
    for number, (learner, weights) in enumerate(seen):
        assert learner == DEFAULTS["linear"]
        expected = learn(programme, number).learner.weights
        np.testing.assert_array_equal(weights, expected)
    assert (seen[0][1] != seen[1][1]).any()


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
