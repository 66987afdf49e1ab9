"""Rows towards the abstract task, and the made-up pictures that they see."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
import small_study
from ideal_recording import clumsy, ideal
from ideal_recording import recording as made_by_hand

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.haptics import LEFT
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.study import (
    abstract_rows,
    causal,
    ideal_outcomes,
    learners,
    looks,
    population,
)
from prospect_mj.experiment.development.study.abstract_rows import MADE_UP
from prospect_mj.experiment.development.study.abstract_told import TOLD
from prospect_mj.experiment.development.study.made_up import MadeUp
from prospect_mj.experiment.development.study.settings import DOMINANT, StudySettings
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.recording.hands import NUMBERS

STUDY = StudySettings(runs=50, setting_runs=20, seed=9)
RECORDED = {"learners": learners.rows(STUDY), "causal": causal.rows(STUDY)}
ROWS = {part: abstract_rows.rows(STUDY, part) for part in RECORDED}
FAITHFUL = [MadeUp(*given) for given in product((0.08, 0.8, 0.95, 1), (0, 0.3))]


@pytest.fixture(scope="module")
def recording():
    """Many presentations of both orientations, of which only the lid matters."""
    standard = small_study.recordings().standard
    lid = np.tile(np.array([*NUMBERS.values()], np.int8), 20)
    return replace(standard, presentations=replace(standard.presentations, lid=lid))


def scaled(recording):
    """Scaled histograms, by orientation."""
    shown, scale = recording.presentations, looks.StateFeatureGenerator()
    made = np.stack([scale.scaled_histogram(one) for one in shown.histogram])
    return {side: made[shown.lid == lid] for side, lid in NUMBERS.items()}


@pytest.mark.parametrize("part", ROWS)
def test_changed_rows_are_as_recorded_but_for_the_change(part):
    usual = {(row.name, row.rule): row for row in RECORDED[part]}
    for row in ROWS[part]:
        thing = row.name.endswith(", one_hot"), row.name.endswith(", forgetting")
        name = row.name.removesuffix(", one_hot").removesuffix(", forgetting")
        same = usual[name, row.rule]
        settings = replace(same.settings, runs=20)
        if thing[0]:
            settings = replace(settings, features=FeatureSettings(reading="one_hot"))
        if thing[1]:
            learner = replace(settings.learner, replays_forget=True)
            settings = replace(settings, learner=learner)
        world = MADE_UP if row.world == MADE_UP else same.world
        assert row == replace(same, name=row.name, settings=settings, world=world)
        assert any(thing) or row.world == MADE_UP


@pytest.mark.parametrize("part", ROWS)
def test_rows_have_names_of_their_own(part):
    titles = [row.title for row in (*RECORDED[part], *ROWS[part])]
    assert len(set(titles)) == len(titles)


def test_every_learner_has_the_changes_that_it_knows_of():
    found = [(row.settings.learner.name, row.rule) for row in ROWS["learners"]]
    known = {"linear": 3, "replay": 3, "discovery": 1, "table": 0}
    # What is replayed can forget the rule only where there is one.
    forgetful = {"linear": 0, "replay": 1, "discovery": 0, "table": 2}
    for name, number in known.items():
        assert found.count((name, "allowed")) == number
        assert found.count((name, "suppressed")) == number + forgetful[name]


def test_causal_rows_with_abstract_numbers_see_made_up_pictures():
    told = {name for part, name, _ in TOLD if part == "causal"}
    assert {row.name for row in ROWS["causal"]} == told
    assert {row.world for row in ROWS["causal"]} == {MADE_UP}
    assert abstract_rows.rows(STUDY, "population") == []


def test_all_that_the_abstract_task_tells_is_of_rows_of_the_study():
    recorded = {
        (row.part, row.name, row.rule)
        for row in (*learners.rows(STUDY), *causal.rows(STUDY), *population.rows(STUDY))
    }
    assert set(TOLD) <= recorded


@pytest.mark.parametrize("made_up", FAITHFUL, ids=str)
def test_prototypes_have_the_cosine_that_was_asked_for(made_up):
    one, other = made_up.prototypes()
    assert min(one.min(), other.min()) >= 0
    assert one @ one == pytest.approx(1)
    assert one @ other == pytest.approx(made_up.cosine)
    np.testing.assert_allclose(one, other[::-1])


@pytest.mark.parametrize("made_up", abstract_rows.PICTURES.values(), ids=str)
def test_pictures_look_as_was_asked_for(recording, made_up):
    seen = scaled(made_up.presented(recording, np.random.default_rng(1)))
    found = looks.looks(seen)
    assert found.between == pytest.approx(made_up.cosine, abs=0.01)
    assert found.noise == pytest.approx(made_up.noise, rel=0.1)
    prototypes = dict(zip(NUMBERS, made_up.prototypes(), strict=True))
    for side, pictures in seen.items():
        mean = pictures.mean(axis=0)
        cosine = mean @ prototypes[side] / np.linalg.norm(mean)
        assert cosine == pytest.approx(1, abs=0.002)


def test_without_noise_all_pictures_of_an_orientation_are_alike(recording):
    made = MadeUp(0.8, 0.0).presented(recording, np.random.default_rng(0))
    left = made.presentations.histogram[made.presentations.lid == LEFT]
    assert (left == left[0]).all()
    assert left[0].argmax() < 50


def test_only_pictures_are_made_up():
    recording = small_study.recordings().standard
    made = abstract_rows.worlds(recording, STUDY)["replay"].recording
    assert made.nodes is recording.nodes
    usual, other = recording.presentations, made.presentations
    for name in ("root", "lid", "number", "look", "depth"):
        alike = getattr(other, name).reshape(len(usual.lid), -1)
        assert (alike == getattr(usual, name)[:, None]).all()
    assert other.histogram.dtype == usual.histogram.dtype


def test_a_trial_has_its_outcomes_and_a_picture_of_its_own():
    recording = small_study.recordings().standard
    made = abstract_rows.worlds(recording, STUDY)["linear"]
    row = replace(ROWS["learners"][0].settings, runs=1)
    runs = [Programme(one, DOMINANT, row).run(0) for one in (recording, made)]
    usual, other = (run.trials for run in runs)
    assert (usual.root == other.root).all()
    assert (runs[0].lid == runs[1].lid).all()
    assert len(set(usual.image)) == 4
    assert len(set(other.image)) > 60
    assert len(np.unique(other.visual, axis=0)) == len(other.visual)


@pytest.mark.parametrize(("kind", "unlike"), [(ideal, False), (clumsy, True)])
def test_outcomes_unlike_the_abstract_ones_are_counted(kind, unlike):
    made = made_by_hand(depth=4, left=(ideal, kind), right=(ideal,))
    known = (made.nodes.child >= 0) & ~made.nodes.inserted[:, None]
    found = ideal_outcomes.compare(made)
    assert found.recorded == known.sum()
    # A clumsy swap leaves the jar where it is: all of them, and nothing else.
    assert found.unlike == (made.nodes.result == "not_grasped").sum()
    assert (found.unlike > 0) == unlike


def test_an_insertion_that_should_fail_is_unlike():
    made = made_by_hand(depth=2, left=(small_study.lid_first,), right=(ideal,))
    nodes = made.nodes
    wrong = nodes.inserted.sum() // 2
    found = ideal_outcomes.compare(made)
    assert found.unlike == 2 * wrong


def test_equal_seeds_make_equal_pictures():
    recording = small_study.recordings().standard
    made = [
        abstract_rows.worlds(recording, study)["discovery"].recording
        for study in (STUDY, STUDY, replace(STUDY, seed=10))
    ]
    one, same, other = (each.presentations.histogram for each in made)
    assert (one == same).all()
    assert (one != other).any()


@pytest.mark.parametrize("wrong", [(0.05, 0.1), (1.1, 0.1), (0.8, -0.1)])
def test_what_cannot_be_made_up_is_refused(wrong):
    with pytest.raises(InvalidValue, match="made-up pictures"):
        MadeUp(*wrong)
