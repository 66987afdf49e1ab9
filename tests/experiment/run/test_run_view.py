"""Reading a run without going on with it."""

import numpy as np
import pytest
import yaml
from ideal_env import IdealEnv

from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.training import train
from prospect_mj.experiment.view.run_view import RunView

CONFIG = TrainConfig(trials=6, seed=4)


@pytest.fixture
def run(tmp_path):
    path = tmp_path / "run"
    session.start(CONFIG, path, IdealEnv, say=lambda _: None)
    return path


def test_a_view_has_what_the_run_has(run):
    view = RunView.read(run)
    with RunFolder.open(run) as folder:
        assert (view.config, view.origin) == (folder.config, folder.origin)
        assert view.actions == folder.actions
        assert view.trials == folder.trials
        np.testing.assert_array_equal(view.learner.weights, folder.learner.weights)
    steps = [view.actions_of(trial)["step"].to_pylist() for trial in range(6)]
    assert steps == [list(range(n)) for n in view.trials["n_actions"].to_pylist()]


def test_a_run_under_way_can_be_viewed_after_each_trial(tmp_path):
    path = tmp_path / "run"
    with RunFolder.create(path, CONFIG) as folder:
        with pytest.raises(RunFolderError, match="no finished trial yet"):
            RunView.read(path)
        for finished in train(CONFIG, IdealEnv(CONFIG), folder.learner):
            folder.commit(finished)
            view = RunView.read(path)
            assert view.n_trials == finished.trial.trial + 1
            assert view.learner.n_updates == view.actions.num_rows


def test_a_view_between_two_files_of_a_commit_is_the_state_before(run, tmp_path):
    # The writer replaces the weights last: tables may be a trial ahead of them.
    early = TrainConfig(trials=4, seed=4)
    session.start(early, tmp_path / "early", IdealEnv, say=lambda _: None)
    weights = (tmp_path / "early" / "weights.npz").read_bytes()
    (run / "weights.npz").write_bytes(weights)
    view = RunView.read(run)
    assert view.n_trials == 4
    assert view.trials["n_actions"].to_numpy().sum() == view.actions.num_rows


def test_a_run_of_other_versions_can_be_viewed_and_says_what_changed(run):
    path = run / "config.yaml"
    content = yaml.safe_load(path.read_text())
    content["versions"]["mujoco"] = "3.1.0"
    path.write_text(yaml.safe_dump(content, sort_keys=False))
    with pytest.raises(RunFolderError, match="can't be continued"):
        RunFolder.open(run)
    view = RunView.read(run)
    assert view.n_trials == 6
    assert view.outdated() == ["mujoco"]


def test_nothing_of_it_is_outdated_where_nothing_changed(run):
    assert RunView.read(run).outdated() == []


@pytest.mark.parametrize(
    ("name", "words"),
    [("actions.parquet", "damaged"), ("weights.npz", "damaged")],
)
def test_a_damaged_run_is_named(run, name, words):
    file = run / name
    file.write_bytes(file.read_bytes()[:100])
    with pytest.raises(RunFolderError, match=words) as refused:
        RunView.read(run)
    assert name in str(refused.value)


def test_what_is_no_run_is_named(tmp_path):
    with pytest.raises(RunFolderError, match="is not a run folder"):
        RunView.read(tmp_path)


def test_a_folder_of_runs_names_one_of_them(run):
    with pytest.raises(RunFolderError, match=r"runs are in it, such as .*run"):
        RunView.read(run.parent)
