import numpy as np
import pytest
from two_kinds import BRIGHT, DARK, Drawn, NoDraws, alternate, seen, tried, visual

from prospect_mj.agent import DiscoverySettings, Transition
from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.discovery.detector import detector, required_distance
from prospect_mj.agent.discovery.feature import Feature
from prospect_mj.agent.observation import NOT_TOLD
from prospect_mj.errors import InvalidChoice, InvalidValue

HERE, THERE = (0, 0), (0, 1)
ALL = np.ones(6, bool)


def learner_of(**settings):
    return DiscoveryQ(DiscoverySettings(**settings))


def learned(n=60, **settings):
    """A learner that has met both kinds of pictures in turn."""
    learner = learner_of(**settings)
    alternate(learner, n, np.random.default_rng(1))
    return learner


@pytest.mark.parametrize("probability", [0.05, 1e-5, 1e-7])
def test_a_context_splits_as_soon_as_the_guard_allows_it(probability):
    learner = learned(guard_probability=probability)
    # After n trials half of them were dark, or one more.
    n = next(
        n
        for n in range(4, 60)
        if required_distance(n - n // 2, n // 2, probability) < 1
    )
    assert learner.contexts.first_split[HERE] == n - 1
    assert np.count_nonzero(learner.contexts.first_split >= 0) == 1


def test_leaves_are_valued_by_their_examples_at_once():
    learner = learned(25)
    assert learner.contexts.first_split[HERE] == 24
    assert learner.q_values(seen(BRIGHT))[0] == -1
    assert learner.q_values(seen(DARK))[0] == -3
    assert learner.contexts.leaf_count[HERE].tolist() == [13, 12]


def test_leaves_that_inherit_learn_slowly():
    learner = learned(25, revalue="inherit")
    mean = learner.contexts.mean[HERE]
    assert mean == pytest.approx(-(13 * 3 + 12) / 25)
    for kind in (BRIGHT, DARK):
        assert learner.q_values(seen(kind))[0] == mean
    # As the whole was, the leaves are of 25 targets; this is the 26th of one of them.
    learner.update(tried(BRIGHT), np.random.default_rng(2))
    assert learner.q_values(seen(BRIGHT))[0] == pytest.approx(mean + (-1 - mean) / 26)
    assert learner.q_values(seen(DARK))[0] == mean


def test_what_was_found_elsewhere_is_tried_before_anything_is_drawn():
    learner = learned(26)
    alternate(learner, 26, NoDraws(), action=1)
    ranges = learner.contexts.ranges
    np.testing.assert_array_equal(ranges[*THERE, 0], ranges[*HERE, 0])
    assert learner.q_values(seen(BRIGHT))[:2].tolist() == [-1, -1]


def test_without_reuse_every_context_draws_its_own():
    learner = learned(26, reuse=False)
    with pytest.raises(AssertionError, match="something was drawn"):
        alternate(learner, 26, NoDraws(), action=1)


def test_only_examples_far_from_the_mean_are_remembered():
    learner, rng = learner_of(), NoDraws()
    learner.contexts.mean[HERE], learner.contexts.count[HERE] = -2.8, 10_000
    # Half of the surprise is .25: -3 is near, -1 is not.
    learner.update(tried(DARK), rng)
    learner.update(tried(BRIGHT), rng)
    assert learner.examples.added[HERE].tolist() == [0, 1]
    everything = learner_of(cache="all")
    everything.contexts.mean[HERE], everything.contexts.count[HERE] = -2.8, 10_000
    everything.update(tried(DARK), rng)
    assert everything.examples.added[HERE].tolist() == [1, 0]


def two_steps(learner, rewards, action=0):
    """A trial that stays in one haptic state."""
    state = seen(DARK)
    for step, reward in enumerate(rewards):
        ends = step + 1 == len(rewards)
        told = Transition(state, action, reward, state, ends, False, ALL)
        learner.update(told, NoDraws())


def test_only_the_first_visit_of_a_trial_is_remembered():
    learner = learner_of()
    two_steps(learner, [-1.0, -5.0])
    assert learner.examples.added[HERE].tolist() == [1, 0]
    # What follows was worth nothing yet.
    assert learner.examples.target[*HERE, 0, 0] == -1
    assert learner.contexts.count[HERE] == 2
    assert learner.n_trials == 1


def test_outcomes_may_be_judged_by_all_that_came():
    for labels, added in (("td", [0, 1]), ("return", [1, 0])):
        learner = learner_of(labels=labels)
        learner.contexts.mean[HERE], learner.contexts.count[HERE] = -2.0, 1
        # The target is -1 + .99 x 0 of the best action; the return -1 + .99 x -5.
        two_steps(learner, [-1.0, -5.0])
        assert learner.examples.added[HERE].tolist() == added
        assert learner.examples.target[*HERE, added.index(1), 0] == -1


def contradicted(**settings):
    """A learner whose one context has split, told of a bad bright picture."""
    learner = learned(26, reuse=False, **settings)
    bright = seen(BRIGHT)
    told = Transition(bright, 0, -3.0, bright, True, False, ALL)
    return learner, told


def test_a_split_context_searches_on_unless_it_may_not():
    learner, told = contradicted(search_after_first=False)
    learner.update(told, NoDraws())
    learner, told = contradicted()
    with pytest.raises(AssertionError, match="something was drawn"):
        learner.update(told, NoDraws())


def test_detectors_that_no_longer_tell_are_dropped():
    learner = learned(26, memory=13, features_per_context=1, candidates=0)
    rng = np.random.default_rng(0)
    assert learner.contexts.n_detectors[HERE] == 0
    learner.contexts.put(HERE, [upper_half_detector(learner)])
    assert learner.contexts.is_split(HERE)
    # From now on the picture says nothing of what comes.
    for bright, well in rng.integers(2, size=(80, 2)):
        state, outcome = seen((DARK, BRIGHT)[bright]), (-3.0, -1.0)[well]
        learner.update(Transition(state, 0, outcome, state, True, False, ALL), rng)
    assert not learner.contexts.is_split(HERE)
    assert learner.q_values(seen(BRIGHT))[0] == learner.q_values(seen(DARK))[0]


def upper_half_detector(learner):
    pictures = (learner.examples.pictures(HERE, kind) for kind in range(2))
    return detector(Feature(50, 60, 0, 0), *pictures)


def expert(distance_of_drawn):
    """A context with a detector of distance .8, and a quiet trial to come."""
    learner = learner_of(expert_phase=True, features_per_context=1)
    examples = learner.examples
    for kind in (DARK, BRIGHT):
        for place in range(20):
            bins = np.zeros(100)
            bins[5] = kind if place < 20 * distance_of_drawn else 1.0
            bins[9] = kind if place < 16 else 1.0
            examples.picture[*HERE, kind, place, 1:] = np.cumsum(bins)
    examples.terminated[HERE], examples.reward[HERE] = True, -1.5
    examples.added[HERE] = 20
    pictures = (examples.pictures(HERE, kind) for kind in range(2))
    learner.contexts.put(HERE, [detector(Feature(9, 10, 0, 0), *pictures)])
    learner.contexts.mean[HERE], learner.contexts.count[HERE] = -1.0, 100
    learner.contexts.leaf_value[HERE] = -1.0
    # A single bin, the sixth.
    learner.update(tried(BRIGHT), Drawn(0, 5))
    return learner.contexts.ranges[*HERE, 0].tolist()


def test_the_expert_replaces_a_feature_by_one_much_better_without_an_error():
    assert expert(1.0) == [5, 6, 0, 0]
    # Better than .8, but not by half of what is missing.
    assert expert(0.85) == [9, 10, 0, 0]


def test_forced_splits_come_after_their_trials_and_know_the_orientation():
    splits = (("insert", 3), ("others", 6))
    learner = learned(5, forced_splits=splits)
    first = learner.contexts.first_split
    assert (first[:, 4:] == 3).all()
    assert (first[:, :4] == -1).all()
    assert learner.q_values(seen(DARK))[0] == learner.q_values(seen(BRIGHT))[0]
    alternate(learner, 2, NoDraws())
    assert (first[:, :4] == 6).all()
    # By what is remembered: the orientation is that of the picture.
    assert learner.q_values(seen(BRIGHT))[0] == -1
    assert learner.q_values(seen(DARK))[0] == -3
    told_otherwise = seen(BRIGHT)._replace(orientation=DARK)
    assert learner.q_values(told_otherwise)[0] == -3


def test_otherwise_the_orientation_is_neither_asked_for_nor_kept():
    told, untold = learned(), learner_of()
    rng = np.random.default_rng(1)
    for number in range(60):
        one = tried((DARK, BRIGHT)[number % 2])
        state = one.observation._replace(orientation=NOT_TOLD)
        untold.update(one._replace(observation=state, next_observation=state), rng)
    for name, array in told.state().items():
        np.testing.assert_array_equal(untold.state()[name], array, name)
    assert not told.examples.orientation.any()
    for kind in (DARK, BRIGHT):
        values = untold.q_values(seen(kind)._replace(orientation=NOT_TOLD))
        np.testing.assert_array_equal(values, told.q_values(seen(kind)))


def test_forced_splits_must_be_told():
    learner = learner_of(forced_splits=(("insert", 3),))
    with pytest.raises(InvalidValue, match="orientation is -1"):
        learner.q_values(seen(DARK)._replace(orientation=NOT_TOLD))


def test_the_first_feature_may_be_given_to_all_contexts():
    learner = learner_of(share_first=True)
    rng = np.random.default_rng(1)
    for action in (0, 3):
        learner.update(tried(DARK, action), rng)
    alternate(learner, 26, rng)
    known = learner.contexts
    trial = known.first_split[HERE]
    assert trial > 0
    assert (known.first_split == trial).all()
    assert known.lent.sum() == known.lent.size - 1
    # Values are as they were, until a leaf learns for itself.
    assert learner.q_values(seen(BRIGHT))[3] == learner.q_values(seen(DARK))[3] == -3
    learner.update(tried(BRIGHT, 3), rng)
    assert learner.q_values(seen(BRIGHT))[3] == -2
    assert learner.q_values(seen(DARK))[3] == -3


@pytest.mark.parametrize(("revalue", "is_lent"), [("examples", 0), ("inherit", 1)])
def test_a_lent_feature_gives_way_to_one_that_values_can_be_estimated_by(
    revalue, is_lent
):
    learner = learned(26, share_first=True, revalue=revalue)
    assert learner.contexts.lent[0, 3]
    # An old value, which the leaves leave slowly: all that comes is a surprise.
    learner.contexts.leaf_count[0, 3] = 1000
    alternate(learner, 30, np.random.default_rng(2), action=3)
    assert learner.contexts.lent[0, 3] == is_lent
    if not is_lent:
        assert learner.q_values(seen(BRIGHT))[3] == pytest.approx(-1)


def test_learning_goes_on_from_a_state_bit_for_bit():
    never_stopped, resumed = learned(30, surprise=0.2), learner_of(surprise=0.2)
    resumed.restore(never_stopped.state())
    for learner in (never_stopped, resumed):
        alternate(learner, 50, np.random.default_rng(5), action=2)
    for name, array in never_stopped.state().items():
        np.testing.assert_array_equal(resumed.state()[name], array, name)
    assert resumed.contexts.first_split[0, 2] > 30


def test_a_state_shares_nothing_with_the_learner():
    learner = learned()
    state = learner.state()
    learner.contexts.mean[HERE] = 7.0
    assert state["mean"][HERE] != 7.0


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("n_detectors", 4),
        ("ranges", 101),
        ("example_next_haptic", 3),
        ("example_orientation", -1),
        ("example_added", -1),
        ("n_trials", -1),
        ("mean", np.nan),
    ],
)
def test_a_state_with_numbers_of_what_there_is_not_is_refused(name, value):
    state = learned().state()
    state[name][...] = value
    with pytest.raises(InvalidValue, match=name.removeprefix("n_").split("_")[-1]):
        learner_of().restore(state)


def test_a_state_of_other_sizes_is_refused():
    with pytest.raises(InvalidValue, match="example_picture"):
        learner_of(memory=10).restore(learned().state())


@pytest.mark.parametrize(
    "change",
    [
        {"observation": seen(DARK)._replace(haptic=3)},
        {"observation": seen(DARK)._replace(visual=np.zeros(99))},
        {"observation": seen(DARK)._replace(visual=np.full(100, np.nan))},
        {"next_observation": seen(DARK)._replace(haptic=-1)},
        {"action": 6},
        {"terminated": False, "allowed": np.zeros(6, bool)},
    ],
)
def test_nonsense_is_refused_before_anything_is_learned(change):
    learner = learner_of()
    with pytest.raises(InvalidValue):
        learner.update(tried(DARK)._replace(**change), NoDraws())
    assert learner.n_updates == 0
    assert not learner.contexts.count.any()


@pytest.mark.parametrize(
    "splits",
    [
        (("swap", 3),),
        (("insert", -1),),
        (("insert", 1), ("insert", 2)),
    ],
)
def test_settings_say_what_is_wrong_with_forced_splits(splits):
    with pytest.raises((InvalidValue, InvalidChoice), match="forced split"):
        DiscoverySettings(forced_splits=splits)


def test_pictures_of_the_two_kinds_have_nothing_in_common():
    assert visual(DARK) @ visual(BRIGHT) == 0


@pytest.mark.parametrize("name", ["share_first", "expert_phase"])
def test_what_finds_features_is_refused_where_splits_are_forced(name):
    with pytest.raises(InvalidValue, match=f"{name} is True; expected false with for"):
        DiscoverySettings(forced_splits=(("insert", 3),), **{name: True})
