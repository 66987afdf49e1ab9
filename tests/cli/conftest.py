"""What the tests of commands do alike."""

import shutil

import pytest
from folder_tree import tree
from ideal_env import IdealEnv

from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig


@pytest.fixture(scope="session")
def finished(tmp_path_factory):
    """A run of three trials on the ideal environment; only to be copied."""
    folder = tmp_path_factory.mktemp("finished") / "run"
    session.start(TrainConfig(trials=3, seed=1), folder, IdealEnv, lambda _: None)
    return folder


@pytest.fixture
def existing(tmp_path, monkeypatch, finished):
    """Where the command is: a run, a folder with something in it, and a file."""
    monkeypatch.chdir(tmp_path)
    shutil.copytree(finished, tmp_path / "run")
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "thesis.tex").touch()
    (tmp_path / "file").touch()
    return tmp_path


@pytest.fixture
def refused(tmp_path, capsys):
    """Run a command that is to refuse: the line that it prints, as it changes nothing.

    Give a function that returns the exit code.
    """

    def run(command):
        capsys.readouterr()
        before = tree(tmp_path)
        assert command() == 2
        said = capsys.readouterr()
        assert said.out == ""
        (line,) = said.err.splitlines()
        assert line.startswith("error: ")
        assert tree(tmp_path) == before
        return line

    return run
