"""The study on grasps and learners made by hand."""

from pathlib import Path

import numpy as np
import pytest
from felt_by_hand import grasps, recording

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.haptics import (
    answer,
    effect,
    ends,
    figure,
    haptics,
)
from prospect_mj.experiment.development.haptics.section import section
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.experiment.development.measures.measures import late_gone
from prospect_mj.experiment.populations.population import Population
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.populations.world import World
from prospect_mj.haptics import ClusterSettings, TrajectoryModels
from prospect_mj.recording.hands import LEFT

LATE_FOR = {0: 200, 2: 100}
"""Trials of late corrections, by the number of categories told; else 300."""


def learn(world: World, scenario: Scenario, settings: PopulationSettings) -> Population:
    """Late corrections for so many trials, then optimal ones; the lid away."""
    assert world.categories == settings.categories
    shape = settings.runs, scenario.trials
    last = scenario.pretrain + LATE_FOR.get(settings.categories, 300)
    strategy = np.full(shape, Strategy.OPTIMAL, np.int8)
    strategy[:, scenario.pretrain : last] = Strategy.LATE
    lid = np.full(shape, LEFT, np.int8)
    lid[:, ::2] += 1
    solved, n_actions = np.ones(shape, bool), np.full(shape, 2, np.int8)
    splits = np.full((settings.runs, 3, 6), -1, np.int16)
    return Population(scenario, lid, n_actions, solved, strategy, lid, splits)


@pytest.fixture
def results(tmp_path: Path, monkeypatch) -> haptics.HapticResults:
    made = grasps(6, np.random.default_rng(0))
    monkeypatch.setattr(haptics, "grasps", lambda recorded: made)
    settings = HapticSettings(
        ClusterSettings(models=3, starts=2), most_models=2, grasped=0, runs=3
    )
    return haptics.run(
        tmp_path, recording(), settings, tell=lambda line: None, learn=learn
    )


def test_every_learner_is_told_each_of_the_three(results):
    rows = results.effect.measures.to_pylist()
    gone = {
        (row["learner"], row["told"]): row["estimate"]
        for row in rows
        if row["measure"] == late_gone.name
    }
    late = {effect.BITS: 200.0, effect.CATEGORY: 300.0, effect.END: 100.0}
    expected = {(name, told): late[told] for name in effect.LEARNERS for told in late}
    assert gone == expected


def test_models_are_kept_beside_the_grasps(results, tmp_path: Path):
    path = tmp_path / haptics.FOLDER / haptics.MODELS
    assert TrajectoryModels.read(path) == results.models[haptics.RECORDED]


def test_the_answer_follows_the_numbers(results):
    words = answer.answer(results.told, results.effect.measures)
    assert "told nearly always: standard, recorded, out of the cradle (100 %)" in words
    assert "late corrections go later with categories than without" in words
    assert "early corrections are never more than 10 %" in words


def test_the_verdict_needs_whole_intervals(results):
    table = results.effect.measures
    rows = table.to_pylist()
    for row in rows:
        if row["measure"] == late_gone.name:
            row["low"], row["high"] = 50.0, 350.0
    words = answer.answer(results.told, type(table).from_pylist(rows, table.schema))
    assert words.count("is undecided") == len(effect.LEARNERS)


def test_chance_is_said_to_be_chance(results):
    rows = results.told.to_pylist()
    for row in rows:
        if row["by"] == ends.CATEGORY:
            row["told"], row["low"], row["high"] = 0.6, 0.45, 0.75
    words = answer.answer(
        type(results.told).from_pylist(rows, ends.TOLD), results.effect.measures
    )
    assert words.startswith(
        "The end that is held, by the category of the grasp, is not told better than "
        "by chance"
    )


def test_the_section_has_every_row(results):
    text = section(results)
    assert text.startswith("## Haptic categories\n")
    for learner in effect.LEARNERS:
        for told in effect.TOLD:
            assert f"| {learner} | {told} |" in text
    assert "| standard, recorded | hand-over | 24 | 50 (31 to 69) | 100" in text


def test_pictures_are_drawn(results):
    pictures = (
        figure.portraits(results.grasps, results.models),
        figure.separation(results.told),
        figure.strategies(results.effect.shares),
    )
    for picture in pictures:
        assert picture.startswith(b"\x89PNG")
    assert len(set(pictures)) == len(pictures)


@pytest.mark.parametrize("grasped", [4, 10, -4, True])
def test_grasps_that_make_no_study_are_refused(grasped):
    with pytest.raises(InvalidValue, match="live grasps"):
        HapticSettings(grasped=grasped)
