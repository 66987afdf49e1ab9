"""The figures of an evaluation, and what is said of them."""

import shlex
from dataclasses import replace

import numpy as np
import pytest
import tyro
from ideal_env import IdealEnv
from left_handed import left_handed

from prospect_mj.cli import command_line
from prospect_mj.cli.replay import ReplayOptions
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.evaluation.report import Report
from prospect_mj.experiment.evaluation.text import text
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings


@pytest.fixture(scope="module")
def view(tmp_path_factory):
    run = left_handed(tmp_path_factory.mktemp("made") / "a run")
    settings = EvaluationSettings(trials=4)
    return evaluate(run, settings, make_env=IdealEnv, say=lambda words: None)


@pytest.fixture(scope="module")
def report(view):
    return Report.of(view)


def test_figures_are_of_each_orientation_and_of_all(report):
    left, right, both = (report.outcomes[name] for name in ("left", "right", "all"))
    assert (left.trials, left.solved, left.actions.estimate) == (4, 4, 2.0)
    assert (right.trials, right.solved, right.actions.estimate) == (4, 0, 10.0)
    assert (both.trials, both.solved, both.actions.estimate) == (8, 4, 6.0)
    assert both.success.estimate == 0.5
    assert left.strategies == {"optimal": 4, "early": 0, "late": 0, "other": 0}
    assert right.strategies == {"optimal": 0, "early": 0, "late": 0, "other": 4}


def test_that_one_orientation_takes_longer_is_no_uncertainty_of_the_mean(report):
    actions = report.outcomes["all"].actions
    assert (actions.low, actions.high) == (6.0, 6.0)


def test_the_text_says_that_an_interval_without_width_is_no_certainty(report, view):
    assert "no trials differed, which of few says little" in text(report)
    changed = with_lengths(view, [2, 10, 3, 9, 2, 10, 4, 10])
    assert "no trials differed" not in text(Report.of(changed))


def test_the_interval_of_a_mean_holds_no_length_that_can_not_be(view):
    changed = with_lengths(view, [2, 10, 2, 10, 2, 10, 3, 9])
    outcomes = Report.of(changed).outcomes
    left, right = outcomes["left"].actions, outcomes["right"].actions
    # Student's of 2, 2, 2, 3 is 2.25 give or take 0.8.
    assert (left.low, left.high) == (2, pytest.approx(2.25 + 3.182446 / 4))
    assert (right.low, right.high) == (pytest.approx(9.75 - 3.182446 / 4), 10)


def with_lengths(view, n_actions):
    """The same trials with other numbers of actions."""
    index = view.trials.schema.get_field_index("n_actions")
    taken = np.array(n_actions, np.int16)
    changed = view.trials.set_column(index, "n_actions", [taken])
    return replace(view, trials=changed)


def test_failures_are_listed_with_the_command_that_replays_each(report, view):
    assert [one.trial for one in report.failures] == [1, 3, 5, 7]
    for one in report.failures:
        prospect, command, *options = shlex.split(one.replay)
        assert (prospect, command) == ("prospect", "replay")
        unset = ReplayOptions(tyro.MISSING)
        told = command_line.parse(ReplayOptions, options, unset, "replay")
        assert (told.run, told.trial) == (view.path, one.trial)
        assert one.orientation == "right"
        assert one.actions == ("grasp-left (done)", *["insert-left (refused)"] * 9)
    assert report.longer == ()


def test_the_text_has_the_figures_and_the_commands(report, view):
    words = text(report)
    (row,) = (line for line in words.splitlines() if line.startswith("lid left"))
    assert row.split()[:3] == ["lid", "left", "4"]
    assert "100.0 (51.0 to 100.0)" in row
    assert "9 x insert-left (refused)" in words
    assert all(one.replay in words for one in report.failures)
    assert "more than 2" not in words
    assert "more than 2 actions: none" in text(report, longer=True)


def test_longer_ones_are_the_solved_that_took_more_than_the_optimum(view, report):
    changed = with_lengths(view, [2, 10, 3, 10, 2, 10, 4, 10])
    longer = Report.of(changed).longer
    assert [one.trial for one in longer] == [2, 6]


def test_a_run_has_no_report(tmp_path):
    with pytest.raises(InvalidValue, match="an evaluation"):
        Report.of(left_handed(tmp_path / "run"))
