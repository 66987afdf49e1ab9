"""Runs of several seeds: made, stopped, gone on with, summed up."""

import shutil
import signal
import subprocess
import sys
import time
import warnings
from pathlib import Path
from subprocess import DEVNULL, PIPE

import ideal_env
import pytest
import yaml
from ideal_env import IdealEnv, refuse

from prospect_mj import storage
from prospect_mj.errors import (
    FolderInUse,
    MissingFile,
    RecordingError,
    RenderingUnavailable,
    RunFolderError,
    SimulationDiverged,
)
from prospect_mj.experiment.run import folder_guard, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.side_by_side import Ended
from prospect_mj.experiment.seeds import seeds_progress
from prospect_mj.experiment.seeds.seeds_folder import n_finished
from prospect_mj.experiment.seeds.train_seeds import train_seeds
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.locking import LockedFolder

CONFIG = TrainConfig(trials=6)


def tree(folder):
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def make(out, seeds=(0, 2), config=CONFIG, env=IdealEnv):
    return train_seeds(config, seeds, out, 1, env, say=lambda words: None)


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    out = tmp_path_factory.mktemp("made") / "out"
    return out, make(out)


@pytest.fixture
def out(made, tmp_path):
    shutil.copytree(made[0], tmp_path / "out")
    return tmp_path / "out"


def test_each_is_the_run_that_its_seed_makes_alone(made, tmp_path):
    out, summary = made
    session.start(
        TrainConfig(trials=6, seed=2), tmp_path / "alone", IdealEnv, lambda _: None
    )
    assert tree(out / "seed-0002") == tree(tmp_path / "alone")
    assert [one.seed for one in summary.seeds] == [0, 2]


def test_the_folder_has_summary_and_picture(made):
    out, summary = made
    names = {path.name for path in out.iterdir()}
    files = {"summary.md", "summary.yaml", "learning_curves.png"}
    assert names == {"seed-0000", "seed-0002", *files}
    assert (out / "summary.md").read_text() == summary.markdown()
    stored = yaml.safe_load((out / "summary.yaml").read_text())
    assert [one["seed"] for one in stored["seeds"]] == [0, 2]
    assert stored["first_mean"]["estimate"] == summary.first_mean.estimate


def test_the_same_again_runs_nothing(out, made):
    before = tree(out)
    assert make(out, env=refuse).markdown() == made[1].markdown()
    assert tree(out) == before


def test_where_nothing_can_be_written_finished_runs_are_summed_up(
    out, made, monkeypatch
):
    def read_only(path, mode="r", *more, **named):
        if set(mode) & set("wa+"):
            raise OSError(30, "Read-only file system", str(path))
        return usual(path, mode, *more, **named)

    usual = Path.open
    monkeypatch.setattr(Path, "open", read_only)
    monkeypatch.setattr(folder_guard.os, "access", lambda *_: False)
    assert make(out, env=refuse).markdown() == made[1].markdown()
    with pytest.raises(RunFolderError, match="can't be written to"):
        make(out, (0, 1))


class Interrupted(IdealEnv):
    def __init__(self, config):
        super().__init__(config)
        self.seed = config.seed

    def reset(self, *, seed, options):
        if self.seed == 2 and options["trial"] == 3:
            raise KeyboardInterrupt
        return super().reset(seed=seed, options=options)


def test_what_was_stopped_goes_on(tmp_path, made):
    with pytest.raises(KeyboardInterrupt):
        make(tmp_path / "out", env=Interrupted)
    assert RunView.read(tmp_path / "out" / "seed-0002").n_trials == 3
    assert not (tmp_path / "out" / "summary.md").exists()
    make(tmp_path / "out")
    assert tree(tmp_path / "out") == tree(made[0])


def test_more_seeds_and_trials_can_be_added(out):
    summary = make(out, (0, 1, 2))
    assert [one.seed for one in summary.seeds] == [0, 1, 2]
    assert make(out, (0, 1, 2), CONFIG.with_trials(8)).trials == 8


@pytest.mark.parametrize(
    ("config", "words"),
    [
        (TrainConfig(trials=6, supervisor="safe"), "supervisor is none, not safe"),
        (TrainConfig(trials=5), "seed-0000 has 6 trials"),
    ],
)
def test_a_folder_of_another_configuration_is_refused(out, config, words):
    before = tree(out)
    with pytest.raises(RunFolderError, match=words):
        make(out, config=config)
    assert tree(out) == before


@pytest.mark.parametrize("name", ["notes.txt", "seeds.txt", "seed-0001/notes.txt"])
def test_a_folder_with_something_else_in_it_is_refused(out, name):
    (out / name).parent.mkdir(exist_ok=True)
    (out / name).touch()
    before = tree(out)
    with pytest.raises(RunFolderError, match="is not empty"):
        make(out, (0, 1, 2))
    assert tree(out) == before


def test_a_file_is_refused(tmp_path):
    (tmp_path / "out").touch()
    with pytest.raises(RunFolderError, match="is not a folder"):
        make(tmp_path / "out")


def test_a_folder_that_can_not_be_read_is_refused(tmp_path, monkeypatch):
    def unreadable(folder):
        raise PermissionError(13, "Permission denied", str(folder))

    monkeypatch.setattr(Path, "iterdir", unreadable)
    with pytest.raises(RunFolderError, match="can't be read: Permission denied"):
        make(tmp_path)


def test_nothing_is_written_where_nothing_can_be_simulated(tmp_path):
    with pytest.raises(RenderingUnavailable):
        make(tmp_path / "out", env=refuse)
    assert not (tmp_path / "out").exists()


def test_nothing_is_written_where_no_episode_can_be_kept(tmp_path):
    class Blind(IdealEnv):
        def watch(self):
            raise RecordingError("nothing to be seen")

    with pytest.raises(RecordingError):
        train_seeds(CONFIG, (0, 1), tmp_path / "out", 1, Blind, kept=Kept(1))
    assert not (tmp_path / "out").exists()


def test_two_at_once_are_refused(out):
    with LockedFolder(out), pytest.raises(FolderInUse):
        make(out)


class Diverging(IdealEnv):
    def __init__(self, config):
        super().__init__(config)
        self.seed = config.seed

    def step(self, action):
        if self.seed == 0:
            raise SimulationDiverged("bad acceleration")
        return super().step(action)


def test_one_that_fails_keeps_no_other_from_its_end(tmp_path):
    with pytest.raises(ChildProcessError, match="seed-0000: bad acceleration"):
        make(tmp_path / "out", env=Diverging)
    assert RunView.read(tmp_path / "out" / "seed-0002").n_trials == 6


def test_a_disk_that_is_full_is_the_machines_fault_and_the_file_is_named(
    tmp_path, monkeypatch
):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(storage.os, "fsync", full)
    words = r"^1 of 1 runs failed: seed-0002: \S+config\.yaml: No space left on device$"
    with pytest.raises(ChildProcessError, match=words):
        make(tmp_path / "out", (2,))


class Incomplete(Diverging):
    """An installation that lacks a file: an error of the system, and of the input."""

    def step(self, action):
        if self.seed == 2:
            raise MissingFile("torso.xml is missing")
        return super().step(action)


def test_input_at_fault_in_any_of_them_is_told_of_as_such(tmp_path):
    with pytest.raises(RunFolderError, match=r"^2 of 2 runs failed: "):
        make(tmp_path / "out", env=Incomplete)


class Dim(IdealEnv):
    def __init__(self, config):
        super().__init__(config)
        warnings.warn("the lamp is dim", RuntimeWarning, stacklevel=1)


def test_what_all_say_alike_is_said_once(tmp_path):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        make(tmp_path / "out", (0, 1, 2), env=Dim)
    (told,) = caught
    assert (str(told.message), told.category) == ("the lamp is dim", RuntimeWarning)


class Dimming(IdealEnv):
    """Warns when the trials are under way, in another process or not."""

    def reset(self, *, seed, options):
        warnings.warn("the lamp is dim", RuntimeWarning, stacklevel=1)
        return super().reset(seed=seed, options=options)


def test_what_a_run_warns_of_keeps_its_kind(tmp_path):
    with pytest.warns(RuntimeWarning, match="the lamp is dim") as caught:
        make(tmp_path / "out", env=Dimming)
    assert len(caught) == 1


def test_without_a_terminal_each_run_is_a_line(tmp_path, capsys):
    make(tmp_path / "out")
    lines = capsys.readouterr().err.splitlines()
    assert lines == ["seed-0000 finished, 1 of 2", "seed-0002 finished, 2 of 2"]


def test_on_a_terminal_trials_are_counted_while_they_are_made(
    tmp_path, capsys, monkeypatch
):
    monkeypatch.setattr(seeds_progress, "_EVERY", 0.01)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    path = tmp_path / "run"
    with seeds_progress.SeedsProgress([path], 6) as progress:
        session.start(CONFIG, path, IdealEnv, lambda _: None)
        deadline = time.monotonic() + 10
        while progress._bar.n < 6 and time.monotonic() < deadline:
            time.sleep(0.01)
        # Before it is closed, which would count once more.
        assert progress._bar.n == 6
        progress.ended(Ended(path, None, ()))
    assert "6/6" in capsys.readouterr().err


def begun(out):
    """The command for two runs of some seconds, when it has come to some trials."""
    options = f"0.01 --seeds 0:2 --jobs 2 --trials 30 --out {out}".split()
    command = [sys.executable, ideal_env.__file__, *options]
    process = subprocess.Popen(command, stdout=DEVNULL, stderr=PIPE, text=True)
    folders = [out / f"seed-000{seed}" for seed in (0, 1)]
    deadline = time.monotonic() + 60
    while min(map(n_finished, folders)) < 3 and time.monotonic() < deadline:
        time.sleep(0.02)
    return process, folders


@pytest.mark.smoke
def test_the_same_again_goes_on_after_a_kill_of_the_command_alone(tmp_path):
    """Its processes end with it, and give back the folders of their runs."""
    process, folders = begun(tmp_path / "out")
    process.kill()
    process.communicate()
    assert process.returncode == -signal.SIGKILL
    assert all(3 <= n_finished(folder) < 30 for folder in folders)
    deadline = time.monotonic() + 60
    for folder in folders:
        while not is_free(folder) and time.monotonic() < deadline:
            time.sleep(0.1)
        assert n_finished(folder) < 30


@pytest.mark.smoke
def test_an_interruption_is_one_line(tmp_path):
    """Also of Python itself, which counts the semaphores that processes left behind."""
    process, _ = begun(tmp_path / "out")
    process.send_signal(signal.SIGINT)
    _, told = process.communicate()
    assert process.returncode == 130
    assert told == "interrupted: all finished trials are kept\n"


def is_free(folder):
    try:
        LockedFolder(folder).close()
    except FolderInUse:
        return False
    return True
