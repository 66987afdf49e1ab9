import numpy as np
import pytest
from synthetic import pair, sampled

from prospect_mj.experiment.learning_curve import smoothed_near_optimal_trial
from prospect_mj.experiment.paper import corrections, measures, statements
from prospect_mj.experiment.paper.curves import Curves
from prospect_mj.experiment.paper.sample import (
    Pair,
    definition,
    estimate,
    title,
)

SWITCH = 4
INF, NAN = np.inf, np.nan


def curves(actions, easy=None, difficult=None, unsolved=None, switch=SWITCH):
    """Curves of one resample; `easy`, `difficult`: (4, s) shares."""
    n = len(actions)
    none, grips = np.zeros((4, n)), np.zeros((1, 2, n))
    return Curves(
        np.array([actions], float),
        np.array([np.zeros(n) if unsolved is None else unsolved], float),
        np.array([none if easy is None else easy], float),
        np.array([none if difficult is None else difficult], float),
        grips,
        grips,
        switch,
    )


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
    assert measures.near_optimal(on_actions(actions)) == [trial]


def test_the_smoothed_measure_of_small_studies_is_the_same_on_smooth_curves():
    falling = np.linspace(3.5, 2.0, 40)
    (plain,) = measures.near_optimal(on_actions(falling))
    assert plain == 290
    assert smoothed_near_optimal_trial(falling) == plain - 10
    # One unlucky set decides the one, and is smoothed away in the other.
    falling[36] = 2.45
    assert measures.near_optimal(on_actions(falling)) == [370]
    assert smoothed_near_optimal_trial(falling) == plain - 10


def test_pretraining_is_looked_at_alone():
    pair = on_actions([9] * 6, [9, 2.5, 2.4, 2.2, 9, 9])
    assert measures.pretraining_near_optimal(pair) == [20]
    late = on_actions([9] * 6, [9, 9, 9, 9, 2, 2])
    assert measures.pretraining_near_optimal(late) == [INF]


def test_right_after_the_pretraining_is_the_first_set_after_it():
    pair = on_actions([9] * 9, [9.5, 9, 9, 2, 5, 6.1, 6, 8, 8])
    assert measures.actions_after_switch(pair) == [5]


def test_first_unsolved_is_that_of_the_first_ten_trials_of_the_baseline():
    pair = Pair(curves([9] * 5, unsolved=[0.7, 0.1, 0, 0, 0]), curves([9] * 5))
    assert measures.first_unsolved(pair) == [0.7]


def test_a_fall_at_half_the_speed_takes_twice_as_long():
    fast = [8, 6, 4, 2, 2, 2]
    slow = [9, 9, 9, 9, 8, 7, 6, 5, 4, 3, 2, 2]
    # Both cross 5 and 3 halfway between two sets, one set or two after it.
    assert measures.fall_ratio(on_actions(fast, slow)) == [2.0]
    assert measures.fall_ratio(on_actions(fast, [9] * SWITCH + fast)) == [1.0]
    assert measures.fall_ratio(on_actions(fast, [9] * 12)) == [INF]


@pytest.mark.parametrize(
    ("slower", "ratio"), [([8, 5.5, 4.5, 3.2, 2.7, 2], 1.9 / 1.0), ([5, 3, 2], 1.0)]
)
def test_a_fall_is_measured_between_sets_too(slower, ratio):
    # Without a dominant hand 5 is crossed at set 1.5, and 3 at set 2.5; see above.
    fast = [8, 6, 4, 2, 2, 2]
    found = measures.fall_ratio(on_actions(fast, [9] * SWITCH + slower))
    np.testing.assert_allclose(found, [ratio])


def test_a_fall_that_began_below_five_counts_from_the_first_set():
    found = measures.fall_ratio(on_actions([8, 6, 4, 2], [9] * SWITCH + [4, 2, 2]))
    np.testing.assert_allclose(found, [0.5])


def test_relearning_is_counted_from_the_first_random_orientation():
    pair = on_actions([9, 9, 9, 9, 2], [9, 2, 2, 2, 6, 2])
    assert measures.relearning_ratio(pair) == [0.25]
    assert measures.relearning_ratio(on_actions([9, 2], [9] * 6)) == [INF]
    # Nothing to compare with: it never came, or was there from the start.
    for without in ([9, 9], [2, 2]):
        ratio = measures.relearning_ratio(on_actions(without, [2] * 6))
        assert np.isnan(ratio).all()


def easy(optimal):
    return [optimal, *np.zeros((3, len(optimal)))]


def test_the_drop_is_from_before_the_switch_to_the_lowest_five_sets_after_it():
    before, after = [0.1, 0.9, 0.9, 0.9], [0.8, 0.5, 0.7, 0.5, 0.6, 0.7, 0.9]
    pair = on_shares(easy(before + after))
    np.testing.assert_allclose(measures.easy_drop(pair), [0.7 - 0.6])
    # The second of three means of five sets: from set 5 up to the end of set 9.
    assert measures.easy_low_trial(pair) == [75]
    # Of the last hundred trials there are seventy here.
    regained = (np.mean(after) - 0.6) / 0.1
    np.testing.assert_allclose(measures.easy_regained(pair), [regained])


def test_one_noisy_set_does_not_make_the_drop():
    noisy = [0.9] * (SWITCH + 12)
    noisy[9] = 0.4
    np.testing.assert_allclose(measures.easy_drop(on_shares(easy(noisy))), [0.1])


@pytest.mark.parametrize("after", [0.5, 0.6])
def test_without_a_drop_nothing_can_be_regained(after):
    optimal = [0.5] * SWITCH + [after] * SWITCH
    assert np.isnan(measures.easy_regained(on_shares(easy(optimal)))).all()


def difficult(optimal, early, late):
    rest = 1 - np.sum([optimal, early, late], axis=0)
    shares = np.array([optimal, early, late, rest], float)
    shares[:, :SWITCH] = np.nan
    return shares


def test_the_margin_is_the_smallest_lead_after_the_switch():
    nothing = [0] * SWITCH
    shares = difficult(
        [*nothing, 0.1, 0.4, 0.9], [*nothing, 0, 0.1, 0.05], [*nothing, 0.02, 0.2, 0]
    )
    margin = corrections.correction_margin(on_shares(difficult=shares))
    np.testing.assert_allclose(margin, [0.1 - 0.02])
    dominated = difficult([*nothing, 0.1], [*nothing, 0.1], [*nothing, 0.2])
    margin = corrections.correction_margin(on_shares(difficult=dominated))
    np.testing.assert_allclose(margin, [-0.2])


def on_corrections(early, late):
    """Shares after the pretraining, in which there are no difficult trials."""
    early, late = ([0] * SWITCH + shares for shares in (early, late))
    return on_shares(difficult=difficult([0] * len(early), early, late))


@pytest.mark.parametrize(
    ("early", "late", "gone"),
    [
        ([0.1, 0.02, 0.0], [0.2, 0.1, 0.01], (50, 60, 10)),
        ([0.1, 0.01, 0.1], [0.2, 0.0, 0.0], (INF, 50, -INF)),
        ([0.1, 0.1, 0.0], [0.1, 0.1, 0.1], (60, INF, INF)),
        ([0.1, 0.1, 0.1], [0.1, 0.1, 0.1], (INF, INF, NAN)),
        # What was never there is not gone at the start, let alone before the switch.
        ([0.02, 0.0, 0.0], [0.1, 0.1, 0.0], (NAN, 60, NAN)),
        ([0.0, 0.03, 0.0], [0.1, 0.0, 0.0], (60, 50, -10)),
    ],
)
def test_a_correction_is_gone_where_it_stays_away(early, late, gone):
    pair = on_corrections(early, late)
    found = [
        corrections.early_gone(pair)[0],
        corrections.late_gone(pair)[0],
        corrections.late_outlasts_early(pair)[0],
    ]
    np.testing.assert_array_equal(found, gone)


def test_a_correction_is_faded_at_a_half_of_its_own_largest_share():
    # In means of five sets each is at a half of its largest where 0.5 is of 1.
    falls = np.array([0.2] * 5 + [1.0] * 6 + [0.5] * 9)
    sooner = np.array([0.2] * 5 + [1.0] * 5 + [0.5] * 10)
    pair = on_corrections((0.04 * sooner).tolist(), (0.3 * falls).tolist())
    assert corrections.early_largest(pair) == pytest.approx([0.04])
    assert corrections.late_largest(pair) == pytest.approx([0.3])
    assert corrections.early_faded(pair) == [10 * (SWITCH + 10)]
    assert corrections.late_outlasts_early_relatively(pair) == [10]
    # Ten times as much of one of them changes nothing; a fixed share is another matter.
    more = on_corrections((0.4 * sooner).tolist(), (0.3 * falls).tolist())
    assert corrections.late_outlasts_early_relatively(more) == [10]
    assert corrections.late_outlasts_early(pair) == [INF]


def test_one_noisy_set_does_not_make_the_largest_share():
    early = [0.1] * 10 + [0.04] + [0.0] * 9
    noisy = list(early)
    noisy[3] = 0.3
    late = [0.1] * 20
    largest = corrections.early_largest(on_corrections(noisy, late))
    assert largest == pytest.approx([(4 * 0.1 + 0.3) / 5])
    assert corrections.late_faded(on_corrections(early, late)) == [INF]


def test_a_correction_that_is_never_there_never_fades():
    pair = on_corrections([0.0] * 8, [0.1, 0.1, *[0.0] * 6])
    assert np.isnan(corrections.early_faded(pair)).all()
    assert np.isnan(corrections.late_outlasts_early_relatively(pair)).all()
    assert np.isfinite(corrections.late_faded(pair)).all()


ALL = [s.measure for s in statements.STATEMENTS] + [m for m, _ in statements.FURTHER]


@pytest.fixture(scope="module")
def sample():
    return sampled(*pair())


@pytest.mark.parametrize("measure", dict.fromkeys(ALL), ids=lambda m: m.__name__)
def test_a_measure_has_a_name_and_one_sentence_and_an_interval(measure, sample):
    assert title(measure)
    assert "\n" not in definition(measure)
    assert definition(measure).endswith(".")
    assert ". " not in definition(measure)
    found = estimate(measure, sample)
    assert measure(sample.resampled).shape == (2000,)
    assert found.low <= found.estimate <= found.high
    assert found.lacking < 0.05
