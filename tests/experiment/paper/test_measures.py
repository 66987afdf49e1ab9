import numpy as np
import pytest
from synthetic import pair, sampled

from prospect_mj.experiment.paper.measures import (
    corrections,
    easy_trials,
    learning,
    statements,
)
from prospect_mj.experiment.paper.measures.curves import Curves, OfKind
from prospect_mj.experiment.paper.measures.sample import Pair
from prospect_mj.experiment.run.learning_curve import smoothed_near_optimal_trial

SWITCH = 4
INF, NAN = np.inf, np.nan
FALL = learning.fall_ratio(5.0, 3.0)


def curves(
    actions,
    easy=None,
    difficult=None,
    unsolved=None,
    switch=SWITCH,
    easy_actions=None,
    difficult_actions=None,
):
    """Curves of one resample; `easy`, `difficult`: (4, s) shares."""
    n = len(actions)
    return Curves(
        np.array([actions], float),
        np.array([np.zeros(n) if unsolved is None else unsolved], float),
        of_kind(actions if easy_actions is None else easy_actions, easy),
        of_kind(actions if difficult_actions is None else difficult_actions, difficult),
        switch,
    )


def of_kind(actions, shares):
    """Those of the easy or of the difficult trials; without shares none has any."""
    n = len(actions)
    given = np.zeros((4, n)) if shares is None else shares
    strategies, taken = np.array([given], float), np.array([actions], float)
    return OfKind(taken, strategies, np.zeros((1, 2, n)))


def on_actions(baseline, dominant=(9, 9, 2, 2, 6, 2)):
    return Pair(curves(baseline, switch=0), curves(dominant))


def on_shares(easy=None, difficult=None):
    n = len(easy[0] if easy is not None else difficult[0])
    return Pair(curves([2] * n, switch=0), curves([2] * n, easy, difficult))


@pytest.mark.parametrize(
    ("actions", "trial"),
    [
        ([9, 3, 2.4, 2.2], 20),
        ([9, 2.3, 2.41, 2.2], 30),
        ([2.0, 2.0], 0),
        ([9, 2.0, 2.5], INF),
    ],
)
def test_near_optimal_is_reached_where_it_stays(actions, trial):
    assert learning.near_optimal(on_actions(actions)) == [trial]


def test_the_smoothed_measure_of_small_studies_is_the_same_on_smooth_curves():
    falling = np.linspace(3.5, 2.0, 40)
    (plain,) = learning.near_optimal(on_actions(falling))
    assert plain == 290
    assert smoothed_near_optimal_trial(falling) == plain - 10
    # One unlucky set decides the one, and is smoothed away in the other.
    falling[36] = 2.45
    assert learning.near_optimal(on_actions(falling)) == [370]
    assert smoothed_near_optimal_trial(falling) == plain - 10


def test_pretraining_is_looked_at_alone():
    pair = on_actions([9] * 6, [9, 2.5, 2.4, 2.2, 9, 9])
    assert learning.pretraining_near_optimal(pair) == [20]
    late = on_actions([9] * 6, [9, 9, 9, 9, 2, 2])
    assert learning.pretraining_near_optimal(late) == [INF]


def test_right_after_the_pretraining_is_the_first_set_after_it():
    pair = on_actions([9] * 9, [9.5, 9, 9, 2, 5, 6.1, 6, 8, 8])
    assert learning.actions_after_switch(pair) == [5]


def test_first_unsolved_is_that_of_the_first_ten_trials_of_the_baseline():
    pair = Pair(curves([9] * 5, unsolved=[0.7, 0.1, 0, 0, 0]), curves([9] * 5))
    assert learning.first_unsolved(pair) == [0.7]


def test_a_fall_at_half_the_speed_takes_twice_as_long():
    fast = [8, 6, 4, 2, 2, 2]
    slow = [9, 9, 9, 9, 8, 7, 6, 5, 4, 3, 2, 2]
    # Both cross 5 and 3 halfway between two sets, one set or two after it.
    assert FALL(on_actions(fast, slow)) == [2.0]
    assert FALL(on_actions(fast, [9] * SWITCH + fast)) == [1.0]


def test_a_fall_that_is_not_over_tells_nothing():
    falls, does_not = [8, 6, 4, 2, 2, 2], [9] * 12
    assert np.isnan(FALL(on_actions(falls, does_not))).all()
    assert np.isnan(FALL(on_actions(does_not, [9] * SWITCH + falls))).all()


@pytest.mark.parametrize(
    ("slower", "ratio"), [([8, 5.5, 4.5, 3.2, 2.7, 2], 1.9 / 1.0), ([5, 3, 2], 1.0)]
)
def test_a_fall_is_measured_between_sets_too(slower, ratio):
    # Without a dominant hand 5 is crossed at set 1.5, and 3 at set 2.5; see above.
    fast = [8, 6, 4, 2, 2, 2]
    found = FALL(on_actions(fast, [9] * SWITCH + slower))
    np.testing.assert_allclose(found, [ratio])


def test_a_fall_that_began_below_five_counts_from_the_first_set():
    found = FALL(on_actions([8, 6, 4, 2], [9] * SWITCH + [4, 2, 2]))
    np.testing.assert_allclose(found, [0.5])


def test_relearning_is_counted_from_the_first_random_orientation():
    pair = on_actions([9, 9, 9, 9, 2], [9, 2, 2, 2, 6, 2])
    assert learning.relearning_ratio(pair) == [0.25]
    # Not there yet, or nothing to compare with: it never came, or was there at once.
    for without, after in (([9, 2], 9), ([9, 9], 2), ([2, 2], 2)):
        ratio = learning.relearning_ratio(on_actions(without, [after] * 6))
        assert np.isnan(ratio).all()


def test_pretraining_is_compared_with_learning_both_sides():
    pair = on_actions([9, 9, 9, 2, 2], [9, 9, 2, 2, 6, 2])
    np.testing.assert_allclose(learning.pretraining_ratio(pair), [2 / 3])
    never = on_actions([9, 9, 9, 9, 9], [9, 9, 2, 2, 6, 2])
    assert np.isnan(learning.pretraining_ratio(never)).all()


def test_the_largest_mean_after_the_pretraining_is_one_of_five_sets():
    pair = on_actions([9] * 12, [9, 9, 9, 9, 6, 9, 6, 6, 8, 8, 7, 6, 6])
    np.testing.assert_allclose(learning.most_actions(pair), [7.4])
    assert learning.most_actions_trial(pair) == [10 * (SWITCH + 1 + 2.5)]


def easy(optimal):
    return [optimal, *np.zeros((3, len(optimal)))]


def test_the_drop_is_from_before_the_switch_to_the_lowest_five_sets_after_it():
    before, after = [0.1, 0.9, 0.9, 0.9], [0.8, 0.5, 0.7, 0.5, 0.6, 0.7, 0.9]
    pair = on_shares(easy(before + after + [0.9] * 9))
    np.testing.assert_allclose(easy_trials.easy_drop(pair), [0.7 - 0.6])
    # The second mean of five sets: from set 5 up to the end of set 9.
    assert easy_trials.easy_low_trial(pair) == [75]
    np.testing.assert_allclose(easy_trials.easy_regained(pair), [(0.9 - 0.6) / 0.1])


def test_a_drop_in_the_last_hundred_trials_can_not_be_regained_yet():
    before, after = [0.9] * SWITCH, [0.8, 0.5, 0.5, 0.5, 0.5, 0.5, 0.9]
    late = on_shares(easy(before + after + [0.9] * 8))
    np.testing.assert_allclose(easy_trials.easy_drop(late), [0.4])
    assert np.isnan(easy_trials.easy_regained(late)).all()


def on_both_kinds(easy_actions, difficult_actions, share_of_easy=0.5):
    easy_ones, others = np.array(easy_actions, float), np.array(difficult_actions)
    mean = share_of_easy * easy_ones + (1 - share_of_easy) * others
    mean[:SWITCH], others[:SWITCH] = easy_ones[:SWITCH], NAN
    dominant = curves(mean, easy_actions=easy_ones, difficult_actions=others)
    return Pair(curves([9] * len(mean), switch=0), dominant)


@pytest.mark.parametrize("share_of_easy", [0.5, 0.4])
def test_who_makes_the_rise_after_the_pretraining(share_of_easy):
    # Easy trials at once 1 more, difficult ones 6 more.
    pair = on_both_kinds([2] * 4 + [3] * 9, [0.0] * 4 + [8.0] * 9, share_of_easy)
    np.testing.assert_allclose(easy_trials.easy_rise_at_once(pair), [1])
    rise = share_of_easy + 6 * (1 - share_of_easy)
    part = easy_trials.difficult_part_of_rise(pair)
    np.testing.assert_allclose(part, [1 - share_of_easy / rise])


def test_easy_trials_may_rise_later():
    rising = [2] * 5 + [4, 5, 5, 5, 5, 5, 3, 2]
    pair = on_both_kinds(rising, [0.0] * 4 + [8.0] * 9)
    np.testing.assert_allclose(easy_trials.easy_rise_at_once(pair), [0])
    np.testing.assert_allclose(easy_trials.easy_rise_at_most(pair), [3])


def test_one_noisy_set_does_not_make_the_drop():
    noisy = [0.9] * (SWITCH + 12)
    noisy[9] = 0.4
    np.testing.assert_allclose(easy_trials.easy_drop(on_shares(easy(noisy))), [0.1])


@pytest.mark.parametrize("after", [0.5, 0.6])
def test_without_a_drop_nothing_can_be_regained(after):
    optimal = [0.5] * SWITCH + [after] * 16
    assert np.isnan(easy_trials.easy_regained(on_shares(easy(optimal)))).all()


def difficult(optimal, early, late):
    rest = 1 - np.sum([optimal, early, late], axis=0)
    shares = np.array([optimal, early, late, rest], float)
    shares[:, :SWITCH] = np.nan
    return shares


def test_the_smallest_lead_is_found_after_the_switch():
    nothing = [0] * SWITCH
    shares = difficult(
        [*nothing, 0.1, 0.4, 0.9], [*nothing, 0, 0.1, 0.05], [*nothing, 0.02, 0.2, 0]
    )
    lead = corrections.smallest_lead(on_shares(difficult=shares))
    np.testing.assert_allclose(lead, [0.1 - 0.02])
    dominated = difficult([*nothing, 0.1], [*nothing, 0.1], [*nothing, 0.2])
    lead = corrections.smallest_lead(on_shares(difficult=dominated))
    np.testing.assert_allclose(lead, [-0.2])


def test_the_smallest_lead_in_means_passes_over_a_single_set():
    optimal = [0] * SWITCH + [0.1, 0.5, 0.6, 0.7, 0.8, 0.9]
    late = [0] * SWITCH + [0.2, 0.1, 0.1, 0.1, 0.1, 0.1]
    pair = on_shares(difficult=difficult(optimal, [0] * len(late), late))
    np.testing.assert_allclose(corrections.smallest_lead(pair), [-0.1])
    np.testing.assert_allclose(corrections.smallest_mean_lead(pair), [2.1 / 5])


def on_corrections(early, late):
    """Shares after the pretraining, in which there are no difficult trials."""
    early, late = ([0] * SWITCH + shares for shares in (early, late))
    return on_shares(difficult=difficult([0] * len(early), early, late))


@pytest.mark.parametrize(
    ("early", "late", "lag"),
    [
        ([0.1, 0.02, 0.0], [0.2, 0.1, 0.01], 10),
        ([0.1, 0.01, 0.1], [0.2, 0.0, 0.0], -INF),
        ([0.1, 0.1, 0.0], [0.1, 0.1, 0.1], INF),
        ([0.1, 0.1, 0.1], [0.1, 0.1, 0.1], NAN),
        # What was never there is not gone at the start, let alone before the switch.
        ([0.02, 0.0, 0.0], [0.1, 0.1, 0.0], NAN),
        ([0.0, 0.03, 0.0], [0.1, 0.0, 0.0], -10),
    ],
)
def test_a_correction_is_gone_where_it_stays_away(early, late, lag):
    found = corrections.gone_lag(0.02)(on_corrections(early, late))
    np.testing.assert_array_equal(found, [lag])


def test_a_correction_is_faded_at_a_part_of_its_own_largest_share():
    # In means of five sets each is at a half of its largest where 0.5 is of 1.
    falls = np.array([0.2] * 5 + [1.0] * 6 + [0.5] * 9)
    sooner = np.array([0.2] * 5 + [1.0] * 5 + [0.5] * 10)
    pair = on_corrections((0.04 * sooner).tolist(), (0.3 * falls).tolist())
    assert corrections.early_largest(pair) == pytest.approx([0.04])
    assert corrections.late_largest(pair) == pytest.approx([0.3])
    assert corrections.faded_lag(1 / 2)(pair) == [10]
    assert np.isnan(corrections.faded_lag(1 / 4)(pair)).all()
    # Ten times as much of one of them changes nothing; a fixed share is another matter.
    more = on_corrections((0.4 * sooner).tolist(), (0.3 * falls).tolist())
    assert corrections.faded_lag(1 / 2)(more) == [10]
    assert corrections.gone_lag(0.02)(pair) == [INF]


def test_an_order_may_be_another_at_a_smaller_part():
    # Early ones fall first, but not as far.
    early = [0.04] * 5 + [0.015] * 10 + [0.0] * 9
    late = [0.3] * 7 + [0.05] * 17
    pair = on_corrections(early, late)
    assert corrections.faded_lag(1 / 2)(pair) > 0
    assert corrections.faded_lag(1 / 4)(pair) < 0


def test_in_the_pretraining_the_order_is_that_in_which_late_ones_go_first():
    early = [0.2] * 6 + [0.0] * 10
    late = [0.2] * 5 + [0.0] * 11
    shares = np.array([[0] * 16, early, late, [0] * 16])
    dominant = curves([2] * 16, shares, switch=12)
    pair = Pair(curves([2] * 16, switch=0), dominant)
    assert corrections.pretraining_lag(1 / 2)(pair) == [10]


def test_one_noisy_set_does_not_make_the_largest_share():
    early = [0.1] * 10 + [0.04] + [0.0] * 9
    early[3] = 0.3
    largest = corrections.early_largest(on_corrections(early, [0.1] * 20))
    assert largest == pytest.approx([(4 * 0.1 + 0.3) / 5])


def test_a_correction_that_is_never_there_never_fades():
    pair = on_corrections([0.0] * 8, [0.1, 0.1, *[0.0] * 6])
    assert np.isnan(corrections.faded_lag(1 / 2)(pair)).all()


def test_corrections_increase_and_taper_off():
    early, late = (
        [0.0] * 3 + [0.1] * 6 + [0.0] * 12,
        [0.0] * 3 + [0.3] * 6 + [0.01] * 12,
    )
    pair = on_corrections(early, late)
    np.testing.assert_allclose(corrections.difficult_increase(pair), [0.4])
    np.testing.assert_allclose(corrections.difficult_left(pair), [0.01 / 0.4])
    shares = np.array([[0] * 25, early + [0] * 4, late + [0] * 4, [0] * 25], float)
    dominant = curves([2] * 25, shares, switch=21)
    pretraining = Pair(curves([2] * 25, switch=0), dominant)
    np.testing.assert_allclose(corrections.pretraining_increase(pretraining), [0.4])
    np.testing.assert_allclose(corrections.pretraining_left(pretraining), [0.01 / 0.4])


ALL = [*statements.MEASURES, *statements.FURTHER]


def test_measures_have_names_of_their_own():
    assert len({m.name for m in ALL}) == len({m.title for m in ALL}) == len(ALL)


@pytest.fixture(scope="module")
def sample():
    return sampled(*pair())


@pytest.mark.parametrize("measure", ALL, ids=lambda m: m.name)
def test_a_measure_has_one_sentence_and_an_interval(measure, sample):
    assert measure.title
    assert measure.definition.endswith(".")
    assert ". " not in measure.definition
    found = measure.estimate(sample)
    assert measure(sample.resampled).shape == (2000,)
    assert found.low <= found.estimate <= found.high
    assert found.lacking < 0.5
