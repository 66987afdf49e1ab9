"""Runs of deep learners: kept, gone on with, and missed in one line."""

import tempfile
from pathlib import Path

import numpy as np
import pytest

from prospect_mj import paths
from prospect_mj.agent import features, haptics
from prospect_mj.envs import pick_place, trials
from prospect_mj.errors import MissingPackage, RunFolderError
from prospect_mj.experiment.development.report.rivals import rivals
from prospect_mj.experiment.development.rivals import kept
from prospect_mj.experiment.development.rivals.deep import agents, runs
from prospect_mj.experiment.development.rivals.deep.agents import DeepRun
from prospect_mj.experiment.development.rivals.deep.runs import DeepLearned, DeepStore
from prospect_mj.experiment.development.rivals.rivals import deep_runs, run
from prospect_mj.experiment.development.rivals.settings import (
    DEEP,
    DQN_CONSTANT,
    LINEAR,
    LINEAR_MASKED,
    MASKABLE_PPO,
    RivalSettings,
)
from prospect_mj.recording import choices, presenter, task
from prospect_mj.recording.recording import Recording

NO_PLANNER = {"live_presentations": 0, "live_errors": ()}


@pytest.fixture
def made(monkeypatch):
    """The runs that are made, without their libraries and processes."""
    done = []

    def learn(wanted, jobs):
        for one in reversed(wanted):
            done.append(one)
            yield one, DeepLearned(np.full(one.trials, one.seed % 9, np.int16), 0.5)

    monkeypatch.setattr(runs, "_learn", learn)
    monkeypatch.setattr(agents, "check_installed", lambda: None)
    return done


def wanted(*seeds):
    return [DeepRun(MASKABLE_PPO, 20, seed) for seed in seeds]


def test_what_was_kept_is_not_made_again(made, tmp_path):
    told = []
    store = DeepStore(tmp_path / "rivals", "recording")
    first = store.get(wanted(3, 4), 1, told.append)
    assert [one.n_actions[0] for one in first] == [3, 4]
    again = store.get(wanted(4, 5, 3), 1, told.append)
    assert [one.n_actions[0] for one in again] == [4, 5, 3]
    assert [one.seed for one in made] == [4, 3, 5]
    assert len(told) == 3
    assert told[-1].startswith("maskable-ppo, seed 5: 20 trials")


def test_runs_of_another_recording_are_others(made, tmp_path):
    for recording in ("one", "two"):
        DeepStore(tmp_path, recording).get(wanted(1), 1, print)
    assert len(made) == 2


def test_a_damaged_run_is_one_line_and_stays(made, tmp_path):
    store = DeepStore(tmp_path, "recording")
    store.get(wanted(1), 1, print)
    (path,) = tmp_path.glob("*.parquet")
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(RunFolderError, match=r"damaged; move it away and run again"):
        store.get(wanted(1), 1, print)
    assert path.exists()


def test_a_missing_library_is_told_before_anything_is_done(monkeypatch, tmp_path):
    monkeypatch.setattr(agents, "find_spec", lambda module: None)
    settings = RivalSettings(agents=(LINEAR, DQN_CONSTANT))
    with pytest.raises(MissingPackage, match=r"torch .* extra rivals: pip install"):
        run(tmp_path, Recording.load(), settings)
    assert not list(tmp_path.iterdir())


def test_every_run_has_a_seed_of_its_own_in_a_comparison_of_any_size():
    small, large = (
        deep_runs(RivalSettings(deep_runs=size), recording=None) for size in (2, 5)
    )
    assert len({one.seed for one in large}) == 5 * len(DEEP)
    assert {*small} < {*large}
    other = deep_runs(RivalSettings(deep_runs=2, seed=1), recording=None)
    assert not {one.seed for one in other} & {one.seed for one in small}


def test_the_linear_learners_need_no_library(monkeypatch, tmp_path):
    monkeypatch.setattr(agents, "find_spec", lambda module: None)
    both = LINEAR, LINEAR_MASKED
    settings = RivalSettings(
        agents=both,
        linear_runs=60,
        deep_runs=20,
        deep_trials=800,
        size_errors=(5,),
        flips=(),
        **NO_PLANNER,
    )
    results = run(tmp_path, Recording.load(), settings, tell=lambda words: None)
    rows = {row["agent"]: row for row in results.learning.to_pylist()}
    times = [rows[agent]["smoothed"] for agent in both]
    assert 200 < times[1] < times[0] < 800
    words = "\n".join(rivals(results))
    assert "| linear, masked | 60 |" in words
    assert "wider by the error" not in words
    assert {*results.tables} == {
        f"rivals_{name}"
        for name in ("learning", "curves", "prices", "errors", "live_errors")
    }


def test_a_run_is_another_when_any_file_that_decides_has_changed(tmp_path):
    for name in ("envs", "recording"):
        (tmp_path / name).mkdir()
    one, patterns = tmp_path / "envs" / "one.py", ("envs/*.py", "recording/*.py")
    one.write_text("A = 1\n")
    first = kept.code(patterns, tmp_path)
    one.write_text("A = 1  # Counted.\n")
    assert kept.code(patterns, tmp_path) == first
    (tmp_path / "recording" / "other.py").write_text("B = 1\n")
    second = kept.code(patterns, tmp_path)
    one.write_text("A = 2\n")
    assert len({first, second, kept.code(patterns, tmp_path)}) == 3


@pytest.mark.parametrize(
    "module",
    [agents, features, haptics, choices, pick_place, presenter, task, trials],
)
def test_what_makes_the_environment_decides(module):
    package = Path(paths.__file__).parent
    decide = {path for each in runs._CODE for path in package.glob(each)}
    assert Path(module.__file__) in decide


@pytest.mark.slow
@pytest.mark.usefixtures("deep")
@pytest.mark.parametrize("agent", DEEP)
def test_a_deep_learner_is_the_same_after_another_in_its_process(agent, tmp_path):
    other, one = (DeepRun(agent, 60, seed) for seed in (4, 5))
    store = DeepStore(tmp_path, "recording")
    _, after = store.get([other, one], 1, print)
    assert len(after.n_actions) == 60
    assert after.n_actions.min() >= 2
    np.testing.assert_array_equal(after.n_actions, agents.train(one))


@pytest.mark.slow
@pytest.mark.usefixtures("deep")
@pytest.mark.parametrize("agent", [DQN_CONSTANT, MASKABLE_PPO])
def test_learning_leaves_nothing_among_the_temporary_files(
    agent, tmp_path, monkeypatch
):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    agents.train(DeepRun(agent, 10, 3))
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@pytest.mark.usefixtures("deep")
def test_masks_make_learning_faster():
    masked, free = (
        agents.train(DeepRun(agent, 500, seed=1)).mean()
        for agent in (MASKABLE_PPO, DQN_CONSTANT)
    )
    assert masked < 4 < free
