"""The rows of the study: which learners are compared, and what is unlike in them."""

from dataclasses import asdict, replace
from itertools import chain, product

import numpy as np
import pytest
import small_study

from prospect_mj.agent import DiscoverySettings
from prospect_mj.agent.haptics import n_haptic
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.development.haptics.touch import BITS, CATEGORY, END
from prospect_mj.experiment.development.study import (
    causal,
    haptic_rows,
    learners,
    population,
    world_rows,
)
from prospect_mj.experiment.development.study.settings import (
    CHANGES,
    FELT_WORLDS,
    IMAGE_WORLDS,
    StudySettings,
)
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.recorded_world import RecordedWorld

STUDY = StudySettings(runs=50, seed=9)
PARTS = {
    "learners": learners.rows(STUDY),
    "causal": causal.rows(STUDY),
    "population": population.rows(STUDY),
    "worlds": world_rows.worlds(STUDY, IMAGE_WORLDS),
    "change": world_rows.changes(STUDY, CHANGES),
    "haptics": haptic_rows.rows(
        STUDY, {world: {BITS: 0, CATEGORY: 3, END: 2} for world in FELT_WORLDS}
    ),
}
BY_NUMBER = haptic_rows.of_numbers(STUDY, dict.fromkeys(FELT_WORLDS, (2, 5)))
CAUSAL = {row.name: row for row in PARTS["causal"]}


@pytest.mark.parametrize("part", PARTS)
def test_rows_of_a_part_have_names_of_their_own(part):
    rows = PARTS[part]
    assert {row.part for row in rows} == {part}
    assert len({row.title for row in rows}) == len(rows)


def test_run_k_sees_the_same_in_all_rows_of_a_pretraining():
    recordings = small_study.recordings().by_world
    shown = {pretrain: set() for pretrain in (0, 100, 400, 800)}
    for row in chain(*PARTS.values()):
        roots = presented(row, recordings)
        shown[row.scenario.pretrain].add(roots[-600:].tobytes())
    assert [len(of_pretraining) for of_pretraining in shown.values()] == [1] * 4
    assert len(set.union(*shown.values())) == 4


def presented(row, recordings):
    """Where the trials (n,) before any change begin in run 3 of a row."""
    begins = recordings[row.world]
    if known := row.settings.categories:
        begins = RecordedWorld(
            begins, known, np.zeros(len(begins.nodes.child), np.int64)
        )
    given = row.scenario, row.settings, recordings.get(row.then)
    return Programme(begins, *given).run(3).trials.root[: row.scenario.trials]


def test_every_learner_and_every_control_is_there_under_both_rules():
    found = {(row.name, row.rule) for row in PARTS["learners"]}
    names = {**DEFAULTS, **learners.CONTROLS}
    assert found == set(product(names, ("allowed", "suppressed")))
    assert {row.settings.runs for row in PARTS["learners"]} == {50}


def test_every_control_differs_from_the_learner_whose_name_it_bears():
    for name, settings in learners.CONTROLS.items():
        usual = DEFAULTS[name.partition(",")[0]]
        assert type(settings) is type(usual)
        assert settings != usual


def test_the_first_causal_row_is_that_of_the_other_parts():
    assert CAUSAL[causal.BASE].settings.learner == DEFAULTS["discovery"]
    assert {row.rule for row in CAUSAL.values()} == {"suppressed"}


def test_in_each_single_row_one_thing_is_changed():
    usual = asdict(DiscoverySettings())
    base = CAUSAL[causal.BASE]
    for row in causal.single(STUDY):
        if row.name == causal.BASE:
            continue
        its = asdict(row.settings.learner)
        changed = [name for name in usual if its[name] != usual[name]]
        changed += ["scenario"] if row.scenario != base.scenario else []
        assert len(changed) == (2 if ", " in row.name and row.name[:2] != "TD" else 1)


def test_other_pretrainings_leave_the_trials_after_them_alone():
    scenarios = {row.scenario for row in causal.single(STUDY)}
    lengths = {scenario.pretrain for scenario in scenarios}
    assert lengths == {*causal.PRETRAININGS, 400}
    assert {one.trials - one.pretrain for one in scenarios} == {600}


def test_forced_splits_are_crossed_with_values_and_rates():
    crossed = product(causal.ORDERS, causal.VALUES, causal.RATES)
    for order, values, rate in crossed:
        learner = CAUSAL[causal.forced_name(order, values, rate)].settings.learner
        assert (learner.revalue, learner.least_rate) == (values, rate)
        split = dict(learner.forced_splits)
        ahead = split["others"] - split["insert"]
        assert (ahead > 0) == (order == "insertion first")
        assert (ahead < 0) == (order == "grasp first")
        assert min(split.values()) == 450


def test_labels_are_crossed_with_what_is_remembered_values_and_rates():
    crossed = product(causal.LABELS, causal.CACHES, causal.VALUES, causal.RATES)
    for labels, cache, values, rate in crossed:
        row = CAUSAL[causal.labelled_name(labels, cache, values, rate)]
        expected = replace(
            DiscoverySettings(),
            labels=labels,
            cache=cache,
            revalue=values,
            least_rate=rate,
        )
        assert row.settings.learner == expected


def test_a_spread_population_draws_what_its_learner_has():
    for row in PARTS["population"]:
        learner = row.settings.learner
        for spread in row.settings.spread:
            assert spread.low < getattr(learner, spread.parameter) < spread.high


def test_in_other_worlds_only_learners_learn_that_see_the_picture():
    assert {row.name for row in PARTS["worlds"]} == {"discovery", "linear", "replay"}
    assert {row.world for row in PARTS["worlds"]} == set(IMAGE_WORLDS)
    assert {row.then for row in PARTS["worlds"]} == {None}


def test_the_world_changes_after_all_trials():
    changing = PARTS["change"]
    assert {row.then for row in changing} == set(CHANGES)
    for rule in ("allowed", "suppressed"):
        assert {row.name for row in changing if row.rule == rule} == set(DEFAULTS)
    assert len(changing) == 2 * len(CHANGES) * len(DEFAULTS)
    for row in changing:
        assert (row.scenario.trials, row.scenario.then_trials) == (1000, 1000)
        assert row.world == "standard"


def test_who_is_told_nothing_more_of_a_grasp_is_the_learner_of_the_other_parts():
    worlds = [row for row in PARTS["worlds"] if row.world == "standard"]
    others = {row.name: row.settings for row in worlds}
    for row in PARTS["haptics"]:
        same = row.settings == others[row.name]
        assert same == (row.touch == BITS)
        assert row.settings.categories == {BITS: 0, CATEGORY: 3, END: 2}[row.touch]


def test_numbers_of_models_change_nothing_else():
    (six,) = (
        row
        for row in PARTS["haptics"]
        if (row.world, row.name, row.touch) == ("standard", "discovery", CATEGORY)
    )
    for row in BY_NUMBER:
        number = row.settings.categories
        learner = replace(six.settings.learner, n_haptic=n_haptic(number))
        settings = replace(six.settings, learner=learner, categories=number)
        assert row == replace(six, settings=settings, world=row.world)
    titles = {row.title for row in (*PARTS["haptics"], *BY_NUMBER)}
    assert len(titles) == len(PARTS["haptics"]) + len(BY_NUMBER)
