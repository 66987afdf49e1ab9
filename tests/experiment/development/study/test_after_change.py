"""After a change all counts begin anew: on a population made by hand."""

from dataclasses import replace

import numpy as np
import pytest
from hand_made_runs import B, E, L, X, population
from small_study import SETTINGS

from prospect_mj.experiment.development.measures.development import Development
from prospect_mj.experiment.development.measures.measures import late_gone
from prospect_mj.experiment.development.study import after, world_rows
from prospect_mj.experiment.development.study.measured import Measured, MeasuredCurves

BEFORE = [[L] * 5] * 6 + [[B] * 5] * 6
EASY = [[B] * 5] * 12
TRIALS = 10 + 10 * len(BEFORE)


def developed(difficult, easy=None, pretrain=10):
    """What four runs come to that go on in another world."""
    easy = [[B] * 5] * len(difficult) if easy is None else easy
    made = population(
        [BEFORE + difficult] * 4, easy=[EASY + easy] * 4, pretrain=pretrain
    )
    then = 10 * len(difficult)
    scenario = replace(made.scenario, trials=TRIALS, then_trials=then)
    n_actions = np.where(made.strategy == X, 10, made.n_actions)
    found = replace(
        made, scenario=scenario, n_actions=n_actions.astype(made.n_actions.dtype)
    )
    return Development.of(after.from_the_change(found), np.random.default_rng(0), 20)


def changed(difficult, easy=None, pretrain=10):
    """Their mean curves."""
    return developed(difficult, easy, pretrain).mean


def test_what_was_before_the_change_counts_nowhere():
    assert np.isnan(late_gone(changed([[B] * 5] * 10))[0])
    assert late_gone(changed([[L] * 5] * 3 + [[B] * 5] * 10))[0] == 30
    assert after.easy_errors(changed([[B] * 5] * 10))[0] == 0.0
    assert after.again(changed([[B] * 5] * 10))[0] == 0


def test_errors_are_those_of_the_first_fifty_trials():
    easy = [[E, B, B, B, B]] * 5 + [[L] * 5] * 5
    difficult = [[X, X, B, B, B]] * 5 + [[B] * 5] * 5
    curves = changed(difficult, easy)
    assert after.easy_errors(curves)[0] == pytest.approx(0.2)
    assert after.difficult_errors(curves)[0] == pytest.approx(0.4)
    assert after.easy_last(curves)[0] == pytest.approx(0.4)


def test_near_optimal_again_after_the_last_bad_mean_of_five_sets():
    # Ten actions in all difficult trials: six in the mean of a set.
    curves = changed([[X] * 5] * 3 + [[B] * 5] * 12)
    means = [np.mean(([6.0] * 3 + [2.0] * 12)[k : k + 5]) for k in range(11)]
    expected = 10 * (max(k for k, mean in enumerate(means) if mean > 2.4) + 1)
    assert after.again(curves)[0] == expected


def test_never_near_optimal_again_is_never():
    assert after.again(changed([[X] * 5] * 12))[0] == np.inf


def test_formerly_easy_trials_are_measured_as_the_difficult_ones():
    easy = [[L] * 5] * 3 + [[E] * 5] * 4 + [[B] * 5] * 5
    row = world_rows.changes(SETTINGS, ("post",))[-1]
    numbers = Measured(row, 4, {}, 0.0)
    found = after.of_formerly_easy(
        MeasuredCurves(numbers, developed([[X] * 5] * 12, easy))
    )
    assert found.row.name == f"{row.name}, formerly easy trials"
    assert (found.row.then, found.runs, found.order) == ("post", 4, 1.0)
    measured = {name: one.estimate for name, one in found.measured.items()}
    assert measured.pop("other_first") == 0.0
    assert measured == {
        "late_gone": 30,
        "early_gone": 70,
        "dominance": 70,
        "early_lead": 40,
        "late_most": 1.0,
        "early_most": 1.0,
        "optimal_last": 0.5,
    }
