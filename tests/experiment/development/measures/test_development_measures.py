"""Measures of development on curves and runs that are made by hand."""

import numpy as np
import pytest
from hand_made_runs import B, E, L, X, population
from hypothesis import given
from hypothesis import strategies as st

from prospect_mj.experiment.development.measures import (
    ages,
    changes,
    sequences,
    stretches,
)
from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.measures import (
    MEASURES,
    dominance,
    early_gone,
    early_lead,
    easy_worst,
    late_alone,
    late_gone,
    optimal_last,
    order,
    other_first,
)


def developed(difficult, easy=None):
    rng = np.random.default_rng(3)
    return Development.of(population(difficult, easy), rng, 200)


LIKE_INFANTS = [[[L] * 5] * 3 + [[L, L, E, E, E]] + [[E] * 5] * 4 + [[B] * 5] * 12]
"""Late for three blocks, then a block of both, early for four, then optimal."""


def test_a_run_like_infants_by_hand():
    development = developed(LIKE_INFANTS)
    found = {measure.name: measure.estimate(development) for measure in MEASURES}
    assert found["late_gone"].estimate == 40
    assert found["early_gone"].estimate == 80
    assert found["dominance"].estimate == 80
    assert found["early_lead"].estimate == 50
    assert found["late_most"].estimate == found["early_most"].estimate == 1.0
    assert found["other_first"].estimate == 0.0
    assert found["optimal_last"].estimate == 1.0
    assert found["easy_worst"].estimate == 1.0
    assert order(development) == 1.0


def test_the_order_of_the_paper_is_none_of_infants():
    """Early ones gone first."""
    development = developed([[[E] * 5] * 2 + [[L] * 5] * 4 + [[B] * 5] * 6])
    assert early_gone(development.mean)[0] < late_gone(development.mean)[0]
    assert order(development) == 0.0


def test_what_was_never_there_is_not_gone():
    development = developed([[[L] * 5] * 2 + [[B] * 5] * 4])
    assert np.isnan(early_gone(development.mean)[0])
    assert early_gone.estimate(development).lacking == 1.0
    assert order(development) == 0.0


def test_what_is_there_in_the_last_block_is_not_gone():
    development = developed([[[L] * 5] * 2 + [[E] * 5] * 4])
    assert early_gone(development.mean)[0] == np.inf
    # Late ones are gone, and early ones outlast them: that is an order.
    assert order(development) == 1.0


def test_late_corrections_to_the_end_make_no_order():
    development = developed([[[E] * 5] * 2 + [[L] * 5] * 4])
    assert late_gone(development.mean)[0] == np.inf
    assert order(development) == 0.0


def test_an_equal_share_is_no_dominance():
    half = [[[L, L, B, B, X]] * 6]
    assert dominance(developed(half).mean)[0] == 0
    more = [[[L, L, L, B, B]] * 6]
    assert dominance(developed(more).mean)[0] == 60


def test_early_lead_asks_for_dominance_as_well():
    no_dominance = [[[E, E, B, B, B]] * 6]
    assert early_lead(developed(no_dominance).mean)[0] == 0


def test_other_is_of_the_first_fifty_trials():
    blocks = [[[X] * 5] * 2 + [[X, B, B, B, B]] * 3 + [[X] * 5] * 5]
    assert other_first(developed(blocks).mean)[0] == pytest.approx((2 + 0.6) / 5)


def test_the_worst_block_of_easy_trials():
    easy = [[[B] * 5] * 2 + [[B, B, E, L, X]] + [[B] * 5] * 3]
    assert easy_worst(developed([[[B] * 5] * 6], easy).mean)[0] == pytest.approx(0.4)


def test_the_end_is_the_last_hundred_trials():
    blocks = [[[L] * 5] * 3 + [[B] * 5] * 9 + [[L] * 5]]
    assert optimal_last(developed(blocks).mean)[0] == pytest.approx(0.9)


def test_the_interval_covers_what_runs_differ_in():
    """Of two kinds of runs, one in four is late: resamples have other shares."""
    late, optimal = [[L] * 5] * 6, [[B] * 5] * 6
    development = developed([late] * 10 + [optimal] * 30)
    largest = next(one for one in MEASURES if one.name == "late_most")
    found = largest.estimate(development)
    assert found.estimate == pytest.approx(0.25)
    assert 0.05 < found.low < 0.2 < 0.3 < found.high < 0.45


@given(st.lists(st.booleans(), min_size=1, max_size=40))
def test_the_longest_stretch_is_that_of_plain_counting(holds):
    words = "".join("x" if one else " " for one in holds).split()
    longest = max(map(len, words), default=0)
    assert stretches.longest(np.array([holds]))[0] == 10 * longest


@given(st.lists(st.floats(0, 1), min_size=1, max_size=30), st.floats(0, 0.9))
def test_nothing_is_above_the_level_after_the_end(shares, level):
    end = stretches.over(np.array([shares]), level)[0]
    above = [n for n, share in enumerate(shares) if share > level]
    if not above:
        assert np.isnan(end)
    elif above[-1] == len(shares) - 1:
        assert end == np.inf
    else:
        assert end == 10 * (above[-1] + 1)


def test_what_more_than_a_half_follow_prevails_and_all_else_is_passed_over():
    trials = [L] * 10 + [L] * 5 + [E] * 5 + [E] * 10 + [B] * 10 + [B] * 9
    assert sequences.prevailing(np.array(trials, np.int8)) == (L, E, B)
    # Five of ten are no majority, whatever the others are.
    mixed = [L] * 6 + [B] * 4 + [X] * 5 + [E] * 3 + [B] * 2 + [L] * 7 + [E] * 3
    assert sequences.prevailing(np.array(mixed, np.int8)) == (L,)
    assert sequences.windows(np.array(mixed, np.int8))[1] == sequences.NO_MAJORITY
    assert sequences.prevailing(np.array([X] * 6 + [L] * 4, np.int8)) == (X,)
    assert sequences.prevailing(np.array([L] * 9, np.int8)) == ()


def test_sequences_of_runs_are_counted():
    like, unlike = LIKE_INFANTS[0], [[B] * 5] * 20
    found = sequences.sequences(population([like] * 3 + [unlike]))
    assert [one.sequence for one in found] == [(L, E, B), (B,)]
    assert [one.share.estimate for one in found] == [0.75, 0.25]
    assert found[0].share.low < 0.75 < found[0].share.high


def test_median_corrections_tell_the_order_of_a_run():
    like, reversed_ = LIKE_INFANTS[0], LIKE_INFANTS[0][::-1]
    neither = [[B] * 5] * 20
    found = sequences.late_before_early(population([like, like, reversed_, neither]))
    assert found.estimate == 0.5


def test_sequences_that_have_a_name_are_numbers_of_a_row():
    trials = [X] * 10 + [E] * 10 + [B] * 80
    timed_out, at_once = np.reshape([trials, [B] * 100], (2, 20, 5))
    runs = population([timed_out] * 3 + [at_once])
    found = sequences.named(sequences.sequences(runs), 4)
    assert found["other_early_optimal"].estimate == 0.75
    assert sum(one.estimate for one in found.values()) == 0.75
    assert found["late_early_optimal"].high < 0.5, "none of four may be by chance"


@pytest.mark.parametrize(
    ("trials", "alone"),
    [
        ([L] * 6 + [X] * 4 + [E] * 10, True),
        ([L] * 5 + [X] * 5 + [E] * 10, False),  # not more than a half
        ([E] + [L] * 9 + [E] * 10, True),  # one alone may come of exploration
        ([E] * 2 + [L] * 8 + [L] * 10, False),  # late, but not before
        ([X] * 10 + [L] * 10 + [E] * 10, True),
        ([L] * 5, False),
        ([B] * 20, False),
    ],
)
def test_a_run_has_a_phase_of_late_ones_alone_or_not(trials, alone):
    run = np.reshape(trials + [B] * (100 - len(trials)), (20, 5))
    assert sequences.late_alone(population([run])).estimate == alone


def changed(runs):
    return changes.Changes.of(population(runs), np.random.default_rng(2), 200)


def mixed_for(n, before, after):
    """Late, then late and early in turn for n trials, then early, then optimal."""
    trials = [L] * before + [L, E] * (n // 2) + [E] * after
    return np.reshape(trials + [B] * (300 - len(trials)), (60, 5))


def test_abrupt_runs_make_a_gradual_mean():
    """Each run changes at once, but not all at the same time."""
    runs = [[[L] * 5] * n + [[E] * 5] * (12 - n) for n in range(2, 11)]
    found = changed(runs)
    assert found.own == (0.0, 0.0, 0.0, 0.0)
    assert found.abrupt.estimate == 1.0
    # At the median change, after six blocks, the runs are 0 to 4 blocks away from it.
    assert found.common.estimate == pytest.approx(5 * (2 * (1 + 2 + 3 + 4)) / 9)
    assert found.common.low > changes.ABRUPT


@pytest.mark.parametrize(("width", "left"), [(10, 1.3), (20, 3.4)])
def test_a_chance_that_rises_evenly_leaves_what_the_bound_stands_for(width, left):
    rng = np.random.default_rng(8)
    chance = np.clip((np.arange(100) - 50) / width + 0.5, 0, 1)
    strategies = np.where(rng.random((4000, 100)) < chance, E, L).astype(np.int8)
    found = changes.misplaced(strategies).min(axis=1).mean()
    assert found == pytest.approx(left, abs=0.1)
    assert (found < changes.ABRUPT) == (width == 10)


@pytest.mark.parametrize(("before", "after"), [(20, 20), (40, 60), (60, 200)])
def test_how_long_a_stage_lasts_makes_no_change_abrupt(before, after):
    """Of n trials in turn half are on the wrong side, but for one."""
    found = [changed([mixed_for(n, before, after)] * 3).own for n in (10, 20, 40)]
    assert [one.estimate for one in found] == [4, 9, 19]


def test_the_other_order_is_no_abrupt_change_from_late_to_early():
    found = changed([[[E] * 5] * 6 + [[L] * 5] * 4 + [[B] * 5] * 6])
    assert found.own.estimate == 20
    assert found.abrupt.estimate == 0.0


def test_a_few_strays_make_no_change():
    found = changed([[[L] * 5] * 6 + [[E, B, B, B, B]] * 9])
    assert found.n_runs == 0
    assert np.isnan(found.own.estimate)


@given(st.lists(st.sampled_from([B, E, L, X]), min_size=1, max_size=30))
def test_misplaced_corrections_are_those_of_plain_counting(trials):
    (found,) = changes.misplaced(np.array([trials], np.int8))
    for n in range(len(trials) + 1):
        assert found[n] == trials[:n].count(E) + trials[n:].count(L)


def test_late_ones_alone_are_counted_until_early_ones_come():
    blocks = [[X] * 5, [L] * 5, [L, L, L, B, B], [E] * 5, [L] * 5] + [[B] * 5] * 5
    assert late_alone(developed([blocks]).mean)[0] == 20
    assert late_alone(developed([[[L, L, E, B, B]] * 6]).mean)[0] == 0


def test_ages_are_found_where_they_are():
    mixed = [[L, L, E, E, B]] * 3
    blocks = [[L] * 5] * 3 + mixed + [[E] * 5] * 4 + [[B] * 5] * 5
    development = developed([blocks])
    nine, fourteen, nineteen = ages.ages(development)
    assert (nine.first, nine.last) == (30, 59)
    assert (fourteen.first, fourteen.last) == (50, 99)
    assert nineteen.first == 100
    assert {found.resamples for found in (nine, fourteen, nineteen)} == {1.0}
    assert ages.in_order(development) == 1.0


def test_ages_that_are_not_there_are_not_found():
    development = developed([[[B] * 5] * 6])
    nine, fourteen, nineteen = ages.ages(development)
    assert np.isnan(nine.first)
    assert nine.resamples == fourteen.resamples == 0.0
    assert nineteen.first == 0
    assert ages.in_order(development) == 0.0
