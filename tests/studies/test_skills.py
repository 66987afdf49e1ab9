"""The figures that the six skills must show; minutes long, run by `make study`."""

from functools import partial

import numpy as np
import pytest

from prospect_mj.control.arm_control import GROSS_MOTIONS
from prospect_mj.experiment.studies.shares import in_parallel
from prospect_mj.experiment.studies.skill_study import (
    run_random_policy,
    run_skills,
    summarise,
)
from prospect_mj.task.pick_place import TaskSettings

pytestmark = [pytest.mark.slow, pytest.mark.gl]
PRESENTATIONS = 50
"""Seeds; each is presented both ways and gives every action two chances or more."""
LEAST_SHARE = 0.99
LONGEST_MEAN = 5.5
"""Simulated time of an executed action [s]."""
EPISODES = 200


@pytest.fixture(scope="module", params=GROSS_MOTIONS)
def task(request):
    return TaskSettings(gross_motion=request.param)


@pytest.fixture(scope="module")
def runs(task):
    return in_parallel(partial(run_skills, task), range(PRESENTATIONS), jobs=2)


@pytest.fixture(scope="module")
def episodes(task):
    return in_parallel(partial(run_random_policy, task), range(EPISODES), jobs=2)


def table(lines):
    return "\n".join(
        f"{line.label:30} {line.passed}/{line.runs} {line.mean_seconds:.2f} s"
        for line in lines
    )


def test_every_skill_succeeds_and_a_wrong_insertion_jams(runs):
    lines = summarise(runs)
    assert {line.label for line in lines} == {
        "grasp-left",
        "grasp-right",
        "swap-left-to-right",
        "swap-right-to-left",
        "insert-left",
        "insert-right",
        "insert-left (wrong way)",
        "insert-right (wrong way)",
    }
    for line in lines:
        assert line.runs >= 0.97 * PRESENTATIONS, table(lines)
        assert line.passed >= LEAST_SHARE * line.runs, table(lines)
    insertions = [run for run in runs if run.action.label.startswith("insert")]
    assert len(insertions) >= 0.97 * 6 * PRESENTATIONS


def test_an_executed_action_takes_no_longer_than_it_should(runs):
    assert np.mean([run.sim_seconds for run in runs]) <= LONGEST_MEAN


def test_both_orientations_do_equally_well(runs):
    failed = {"left": 0, "right": 0}
    for run in runs:
        failed[run.orientation] += not run.passed
    assert abs(failed["left"] - failed["right"]) <= 4


def test_a_random_policy_loses_no_jar(episodes):
    assert len(episodes) == EPISODES
    lost = [episode.seed for episode in episodes if episode.jar_lost]
    assert not lost


def test_a_random_policy_touches_nothing_that_it_should_not(episodes):
    touched = {
        episode.seed: dict(episode.findings.contacts)
        for episode in episodes
        if episode.findings.contacts
    }
    assert not touched


def test_a_random_policy_saturates_no_motor_and_watches_every_step(episodes):
    saturated = {
        episode.seed: dict(episode.findings.saturated)
        for episode in episodes
        if episode.findings.saturated
    }
    assert not saturated
    assert max(episode.findings.load for episode in episodes) < 1.0
    assert sum(episode.findings.steps for episode in episodes) > 1_000 * EPISODES


def test_a_random_policy_does_all_kinds_of_things(episodes):
    """Otherwise the tests above would say little."""
    results = [result for episode in episodes for result in episode.results]
    assert len(results) > 2 * EPISODES
    assert {"success", "jammed"} <= set(results)
