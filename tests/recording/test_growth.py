"""Growth gives the same bytes however it is interrupted, split or spread."""

import shutil
from dataclasses import replace
from itertools import islice
from types import SimpleNamespace

import numpy as np
import pytest
from ideal_grower import (
    IdealGrower,
    content,
    grow_with,
    grown_tree,
    key,
    trial_state,
)

from prospect_mj.actions.action import Action
from prospect_mj.errors import (
    InvalidChoice,
    InvalidValue,
    RecordingError,
    SimulationDiverged,
    UnforeseenEvent,
)
from prospect_mj.recording import growth
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.growth import Growth, Unit, grown
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.tree import Edge
from prospect_mj.recording.workers import Workers
from prospect_mj.supervisor.predicates import PRESENTED

KEY = key()
ALONE = Workers(jobs=1)
EXTENT = Extent(presentations=3, depth=4)


def grow(path, extent, steps=None):
    """Grow, for a number of steps or to the end; how many actions were recorded."""
    with GrowingRecording.open(path, KEY) as recording:
        run = Growth(recording, extent)
        before = run.n_actions
        for _ in islice(run.run(ALONE), steps):
            pass
        return run.n_actions - before


@pytest.fixture
def whole(ideal, tmp_path):
    """Files of a recording that grew in one go."""
    n_recorded = grow(tmp_path / "whole", EXTENT)
    assert n_recorded == ideal.n_run == 6 * grown_tree(4).n_actions
    ideal.n_run = 0
    return content(tmp_path / "whole")


@pytest.mark.parametrize(("steps", "actions_per_unit"), [(1, 5), (4, 5), (7, 1)])
def test_growth_that_was_broken_off_goes_on_to_the_same_bytes(
    whole, ideal, steps, actions_per_unit, tmp_path, monkeypatch
):
    monkeypatch.setattr(growth, "_ACTIONS_PER_UNIT", actions_per_unit)
    path = tmp_path / "cut"
    n_recorded = 0
    while found := grow(path, EXTENT, steps):
        n_recorded += found
    assert content(path) == whole
    assert n_recorded == 6 * grown_tree(4).n_actions


def test_growing_deeper_and_wider_later_gives_the_same_bytes(whole, ideal, tmp_path):
    for extent in (Extent(1, 2), Extent(3, 1), Extent(2, 3), EXTENT):
        grow(tmp_path / "later", extent)
    assert content(tmp_path / "later") == whole
    assert ideal.n_run == 6 * grown_tree(4).n_actions


def test_what_is_recorded_is_not_run_again(whole, ideal, tmp_path):
    assert grow(tmp_path / "whole", EXTENT) == 0
    assert grow(tmp_path / "whole", Extent(1, 2)) == 0
    assert ideal.n_run == 0


def test_how_far_it_is(ideal, tmp_path):
    grow(tmp_path / "it", Extent(1, 4))
    with GrowingRecording.open(tmp_path / "it", KEY) as recording:
        run = Growth(recording, EXTENT)
        usual = grown_tree(4).n_actions
        assert (run.n_trees, run.n_complete) == (6, 2)
        assert (run.n_actions, run.n_expected) == (2 * usual, 6 * usual)
        counted = []
        for tree in run.run(ALONE):
            counted.append(run.n_actions)
            assert recording.tree(*tree.name).n_actions == tree.n_actions
        assert counted == sorted(counted)
        assert (run.n_complete, run.n_actions) == (6, run.n_expected)


def test_what_is_half_grown_is_loaded_as_far_as_it_goes(ideal, tmp_path, monkeypatch):
    monkeypatch.setattr(growth, "_ACTIONS_PER_UNIT", 9)
    grow(tmp_path / "half", Extent(1, 4), steps=2)
    shown = Recording.load(tmp_path / "half").presentations
    assert len(shown.root) == 2
    assert set(shown.depth.tolist()) == {2}


def test_a_damaged_tree_is_found_before_anything_grows(whole, ideal, tmp_path):
    path = tmp_path / "whole" / "right-0002.parquet"
    path.write_bytes(path.read_bytes()[:-9])
    (tmp_path / "whole" / "left-0000.parquet").unlink()
    with pytest.raises(RecordingError, match=r"right-0002.* is damaged"):
        grow(tmp_path / "whole", EXTENT)
    assert ideal.n_run == 0
    assert not (tmp_path / "whole" / "left-0000.parquet").exists()


def test_presentations_of_another_seed_are_others(tmp_path, ideal, whole):
    """Their files can't be passed for this recording's either."""
    other = tmp_path / "other"
    with GrowingRecording.open(other, key(seed=1)) as recording:
        list(Growth(recording, Extent(1, 1)).run(ALONE))
    shutil.copy(other / "left-0000.parquet", tmp_path / "whole")
    with pytest.raises(RecordingError, match="is from another recording"):
        grow(tmp_path / "whole", EXTENT)


def test_a_process_with_other_packages_grows_nothing():
    """As on a machine of a cluster that was set up otherwise."""
    here = RecordingKey.present(RecordingConfig())
    elsewhere = replace(
        here,
        versions={**here.versions, "mujoco": "3.16.0"},
        sha256={**here.sha256, "sources": "ab"},
    )
    with pytest.raises(RecordingError, match=r"can't grow on .*mujoco 3\.16\.0") as no:
        grown(Unit(elsewhere, "left", 0, None, 2))
    assert "sources changed" in str(no.value)


class Failing(IdealGrower):
    """One outcome is beyond the model; the physics stays broken after that."""

    broken = False
    at = ("left", 1, 2, Action.INSERT_RIGHT)

    def plant(self, orientation, number):
        if (orientation, number) == self.at:
            raise UnforeseenEvent("a jar in the air", "the look")
        return super().plant(orientation, number)

    def extend(self, tree, edge):
        if self.broken or (*tree.name, edge.node, edge.action) == self.at:
            self.broken = True
            raise SimulationDiverged("MuJoCo warned of mjWARN_BADQACC")
        super().extend(tree, edge)


def grow_failing(path, extent=EXTENT):
    with GrowingRecording.open(path, KEY) as recording:
        run = Growth(recording, extent)
        list(run.run(ALONE))
        return run, recording.tree(*Failing.at[:2])


@pytest.mark.parametrize("actions_per_unit", [2, 32])
def test_an_outcome_that_fails_stops_no_other_tree(
    whole, tmp_path, monkeypatch, actions_per_unit
):
    monkeypatch.setattr(growth, "_ACTIONS_PER_UNIT", actions_per_unit)
    grow_with(monkeypatch, Failing)
    run, tree = grow_failing(tmp_path / "it")
    words = "left 1, node 2, insert-right: MuJoCo warned of mjWARN_BADQACC"
    assert run.failures == [words]
    assert run.n_complete == run.n_trees - 1
    failed = "left-0001.parquet"
    found = content(tmp_path / "it")
    assert found.keys() == whole.keys()
    assert all(found[name] == whole[name] for name in whole.keys() - {failed})
    # What was recorded before it is kept: the grasps, and the left hand's two actions.
    edges = list(tree.children)
    assert edges == list(grown_tree(4).children)[: len(edges)]
    assert Edge(2, Action.INSERT_RIGHT) == next(tree.open_edges(4))
    assert run.n_actions == 5 * grown_tree(4).n_actions + len(edges)


def test_once_the_failure_is_mended_the_tree_grows_on(whole, tmp_path, monkeypatch):
    with monkeypatch.context() as failing:
        grow_with(failing, Failing)
        grow_failing(tmp_path / "it")
    assert grow(tmp_path / "it", EXTENT) > 0
    assert content(tmp_path / "it") == whole


def test_a_presentation_that_fails_stops_no_other_tree(tmp_path, monkeypatch):
    monkeypatch.setattr(Failing, "at", ("right", 0))
    grow_with(monkeypatch, Failing)
    run, tree = grow_failing(tmp_path / "it")
    assert tree is None
    assert run.failures == [
        "right 0: unforeseen event: a jar in the air; it can't happen in: the look"
    ]
    assert (run.n_complete, run.n_trees) == (5, 6)


def test_a_state_of_another_model_is_told_of_before_mujoco_sees_it(
    ideal, tmp_path, monkeypatch
):
    grow(tmp_path / "it", Extent(1, 1))
    other = SimpleNamespace(save=lambda: trial_state(np.zeros(9), PRESENTED))
    monkeypatch.setattr("ideal_grower.IdealTask", lambda: other)
    ideal_again = type("Other", (ideal,), {})
    grow_with(monkeypatch, ideal_again)
    before = content(tmp_path / "it")
    with pytest.raises(RecordingError, match=r"left 0, node 1 .* 8 numbers, and .* 9"):
        grow(tmp_path / "it", Extent(1, 2))
    assert content(tmp_path / "it") == before


def test_no_more_processes_are_opened_than_trees_are_unfinished(
    ideal, tmp_path, monkeypatch
):
    opened = []
    mapper = Workers.mapper
    monkeypatch.setattr(
        Workers, "mapper", lambda workers: opened.append(workers.jobs) or mapper(ALONE)
    )
    with GrowingRecording.open(tmp_path / "it", KEY) as recording:
        list(Growth(recording, Extent(1, 2)).run(Workers(jobs=8)))
    assert opened == [2]


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: Extent(presentations=0), "presentations is 0"),
        (lambda: Extent(presentations=-1), "presentations is -1"),
        (lambda: Extent(presentations=10**9), "from 1 to 100000"),
        (lambda: Extent(presentations=2.5), "2.5"),
        (lambda: Extent(depth=0), "depth is 0"),
        (lambda: Extent(depth=41), "from 1 to 40"),
        (lambda: Workers(jobs=0), "jobs is 0"),
        (
            lambda: Workers(jobs=4096),
            r"jobs is 4096; expected an integer from 1 to \d+",
        ),
        (lambda: Workers(jobs=4097, backend="ray"), "from 1 to 4096"),
        (lambda: Workers(backend="slurm"), "'slurm'; valid: local, ray"),
        (lambda: RecordingConfig(seed=-1), "seed is -1"),
        (lambda: RecordingConfig(grid_cells=1), "grid cells per joint is 1"),
        (lambda: RecordingConfig(object_pose="guess"), "valid: vision, truth"),
        (lambda: RecordingConfig(gross_motion="fly"), "valid: harmonic, cartesian"),
    ],
)
def test_absurd_sizes_and_choices_are_refused(make, words):
    with pytest.raises((InvalidValue, InvalidChoice), match=words):
        make()
