"""Orders of strategies, planted and found."""

import numpy as np
from synthetic import of_strategies, pair, sampled

from prospect_mj.agent.haptics import LEFT, RIGHT
from prospect_mj.experiment.paper.measures import infants
from prospect_mj.experiment.paper.measures.stages import stages
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.experiment.paper.report import report_infants
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.experiment.populations.strategies import Strategy

GRIPS, PREFERENCE, EASY, DOMINANCE, LATE_FIRST = range(5)
BEGINNING, HEIGHT, END = (400, 500), (650, 750), (900, 1000)


def planted(*spans, runs=200, easy_optimal=0.95):
    """Populations whose difficult trials are optimal, but for some spans of trials.

    Args:
        *spans: first trial, the one after the last, chances of an early and of a late
            correction, the rest being optimal.
        runs: how many.
        easy_optimal: chance of the optimal strategy in easy trials.
    """
    rng = np.random.default_rng(3)
    chances = np.zeros((1000, 2))
    for first, end, early, late in spans:
        chances[first:end] = early, late
    lid = rng.choice([LEFT, RIGHT], (runs, 1000))
    lid[:, :400] = RIGHT
    drawn = rng.random((runs, 1000))
    early, either = chances[:, 0], chances.sum(axis=1)
    strategy = np.where(drawn < either, Strategy.LATE, Strategy.OPTIMAL)
    strategy[drawn < early] = Strategy.EARLY
    easy = np.where(drawn < easy_optimal, Strategy.OPTIMAL, Strategy.EARLY)
    strategy = np.where(lid == RIGHT, easy, strategy)
    dominant = of_strategies(strategy, lid, Scenario(1000, 400))
    return sampled(pair(runs=runs)[0], dominant)


def verdicts(sample):
    return [order.verdict for order in infants.orders(sample, stages(sample))]


LIKE_INFANTS = (
    (*BEGINNING, 0.46, 0.34),
    (500, 700, 0.7, 0.05),
    (700, 750, 0.7, 0.0),
)


def test_an_agent_that_does_as_infants_is_found_to():
    assert verdicts(planted(*LIKE_INFANTS)) == [Verdict.HOLDS] * 5


def test_another_order_is_found_too():
    other = planted((*BEGINNING, 0.1, 0.3), (*HEIGHT, 0.1, 0.8), easy_optimal=0.3)
    found = verdicts(other)
    # More nonradial grasps at the height of corrections.
    assert found[GRIPS] == Verdict.FAILS
    assert found[PREFERENCE] == Verdict.FAILS
    assert found[EASY] == Verdict.FAILS


def test_nonradial_grasps_that_stay_are_not_rare_at_the_end():
    stay = planted((*BEGINNING, 0.4, 0.4), (500, 900, 0.7, 0.1), (*END, 0.5, 0.0))
    assert verdicts(stay)[GRIPS] == Verdict.FAILS


def test_corrections_that_are_still_there_at_the_end_are_not_unnecessary():
    still = planted(*LIKE_INFANTS, (*END, 0.08, 0.0))
    assert verdicts(still)[PREFERENCE] == Verdict.FAILS
    few = planted(*LIKE_INFANTS, (*END, 0.02, 0.01))
    assert verdicts(few)[PREFERENCE] == Verdict.HOLDS


def test_corrections_dominate_if_they_are_more_than_optimal_ones_at_their_height():
    few = planted((*BEGINNING, 0.4, 0.4), (500, 600, 0.2, 0.2))
    assert verdicts(few)[DOMINANCE] == Verdict.FAILS
    many = planted((*BEGINNING, 0.1, 0.1), (*HEIGHT, 0.4, 0.2))
    assert verdicts(many)[DOMINANCE] == Verdict.HOLDS


def test_early_corrections_that_go_first_are_the_other_order():
    early_first = planted((*BEGINNING, 0.4, 0.4), (500, 700, 0.0, 0.5))
    assert verdicts(early_first)[LATE_FIRST] == Verdict.FAILS


def test_an_order_may_depend_on_the_measure():
    # Early ones are rare and stay at two thirds of their largest share, late ones fall
    # to a small part of it: early ones fall below 2 % first, late ones below a half.
    differs = planted(
        (400, 600, 0.024, 0.7), (600, 850, 0.016, 0.04), (850, 1000, 0.0, 0.0)
    )
    assert verdicts(differs)[LATE_FIRST] == Verdict.DEPENDS


def test_a_small_study_leaves_open_what_a_large_one_shows():
    assert Verdict.OPEN in verdicts(planted(*LIKE_INFANTS, runs=8))


def test_the_report_tells_every_order_and_other_as_its_own_row():
    sample = planted((*BEGINNING, 0.4, 0.4), (500, 700, 0.0, 0.5))
    text = "\n".join(report_infants.section(sample))
    for order in infants.orders(sample, stages(sample)):
        assert f"| {order.infants} | {order.rule} | **{order.verdict}** |" in text
    assert "| other or truncated in difficult trials | 0.0 % (0.0 % to 0.0 %)" in text
