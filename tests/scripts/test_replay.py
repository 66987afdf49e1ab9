"""Replaying from the command line."""

import os
import shutil
import signal
from pathlib import Path

import numpy as np
import pytest

from prospect_mj.cli import replay, video
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.kept_episodes import Kept, path_of
from prospect_mj.replay import viewer

pytestmark = pytest.mark.gl


@pytest.fixture(scope="module")
def trained(tmp_path_factory):
    """A run that kept the first of its two trials."""
    run = tmp_path_factory.mktemp("trained") / "run"
    config = TrainConfig(trials=2, seed=5, max_actions=2)
    session.start(config, run, say=lambda _: None, kept=Kept.parse("every=2"))
    return run


@pytest.fixture
def here(trained, tmp_path, monkeypatch):
    """A folder with the run in it, and with what can be in the way."""
    monkeypatch.chdir(tmp_path)
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    shutil.copytree(trained, "run")
    shutil.copytree("run", "damaged")
    path_of(Path("damaged"), 0).write_bytes(b"PK")
    shutil.copytree("run", "cut")
    Path("cut/actions.parquet").write_bytes(b"PAR1")
    Path("there.rrd").write_text("mine")
    Path("there.mp4").write_text("mine")
    Path("empty").mkdir()
    Path("notes.npz").write_text("no archive")
    np.savez("other.npz", a=1)
    return tmp_path


def said(capsys):
    """The only line on stderr."""
    (line,) = capsys.readouterr().err.splitlines()
    return line


BAD = {
    "empty --save a.rrd": "empty is not a run folder",
    "none --save a.rrd": "none is not a run folder",
    "run": "there is no display",
    "run --save there.rrd": "a file that does not exist",
    "run --save a.mp4": "a name that ends in .rrd",
    "run --save none/a.rrd": "a folder that exists",
    "run --save a.rrd --serve": "none beside --save",
    "run --save a.rrd --port 8000": "none without --serve",
    "": "RUN",
    "run --serve --port 0": "--port",
    "run --serve --host localhost": "an IPv4 address",
    "run --save a.rrd --trial 2": "0 to 1, as far as the run has come",
    "run --save a.rrd --trial -1": "0 to 1, as far as the run has come",
    "run --save a.rrd --trial one": "one",
    "run --save a.rrd --trial 0 --worst": "one of --trial, --worst, --failures",
    "run --save there.rrd --failures": "there.rrd is not a folder",
    "damaged --save a.rrd": "can't be read as an episode",
    "cut --save a.rrd": "actions.parquet can't be read",
    "notes.npz --save a.rrd": "notes.npz can't be read as an episode",
    "other.npz --save a.rrd": "other.npz is not an episode",
    "there.rrd --save a.rrd": "rerun there.rrd opens what was saved",
    "gone.npz --save a.rrd": "there is no episode gone.npz",
    "run/episodes/trial-000000.npz --trial 0 --save a.rrd": "one episode",
    f"run --save {'x' * 300}.rrd": "can be made",
}


@pytest.mark.parametrize("arguments", BAD)
def test_what_cant_be_replayed_is_one_line(arguments, here, capsys):
    before = sorted(here.rglob("*"))
    assert replay.main(arguments.split()) == 2
    assert BAD[arguments] in said(capsys)
    assert sorted(here.rglob("*")) == before
    assert Path("there.rrd").read_text() == "mine"


BAD_VIDEO = {
    "": "RUN",
    "run": "OUT.mp4",
    "run there.mp4": "a file that does not exist",
    "run a.avi": "a name that ends in .mp4",
    "run none/a.mp4": "a folder that exists",
    "run a.mp4 --width 63": "63",
    "run a.mp4 --height 101": "an even number",
    "run a.mp4 --trial 9": "0 to 1, as far as the run has come",
    "damaged a.mp4": "can't be read as an episode",
    "empty a.mp4": "empty is not a run folder",
}


@pytest.mark.parametrize("arguments", BAD_VIDEO)
def test_what_cant_be_filmed_is_one_line(arguments, here, capsys):
    assert video.main(arguments.split()) == 2
    assert BAD_VIDEO[arguments] in said(capsys)
    assert not Path("a.mp4").exists()
    assert Path("there.mp4").read_text() == "mine"


def test_a_kept_trial_is_read_and_another_one_simulated_again(here, capsys):
    assert replay.main(["run", "--save", "a.rrd"]) == 0
    out, err = capsys.readouterr()
    assert (out, err) == ("a.rrd\n", "")
    assert replay.main(["run", "--save", "b.rrd", "--trial", "1"]) == 0
    assert capsys.readouterr().err == ("trial 1 was not kept: it is simulated again\n")
    for name in ("a.rrd", "b.rrd"):
        assert Path(name).read_bytes()[:4] == b"RRF2"
    assert sorted(path.name for path in here.glob("*.rrd")) == [
        *("a.rrd", "b.rrd", "there.rrd"),
    ]


def test_failures_are_saved_into_a_folder(here, capsys):
    assert replay.main(["run", "--failures", "--save", "new/folder"]) == 0
    (name,) = capsys.readouterr().out.splitlines()
    assert name == "new/folder/trial-000000.rrd"
    assert Path(name).is_file()


def test_an_episode_is_replayed_without_its_run(here, capsys):
    shutil.copy(path_of(Path("run"), 0), "alone.npz")
    assert replay.main(["alone.npz", "--save", "alone.rrd"]) == 0


def test_a_viewer_that_is_missing_is_named_before_anything_is_done(
    here, capsys, monkeypatch
):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert replay.main(["run", "--serve"]) == 2
    assert "pip install rerun-sdk" in said(capsys)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_serving_ends_with_whatever_ends_a_process(number, here, capsys, monkeypatch):
    monkeypatch.setattr(viewer, "serve", lambda *_: signal.raise_signal(number))
    usual = signal.getsignal(signal.SIGTERM)
    assert replay.main(["run", "--serve", "--port", str(viewer.free_port())]) == 0
    assert said(capsys) == "stopped"
    assert signal.getsignal(signal.SIGTERM) is usual


@pytest.fixture
def nobody(here):
    """This process without root's rights, in a folder that others may look into."""
    if os.geteuid() == 0:
        here.chmod(0o755)
        Path("run").chmod(0o700)
        Path("open").mkdir()
        Path("open").chmod(0o777)
        # What is imported late may be where nobody can read.
        replay.main(["run", "--trial", "9", "--save", "a.rrd"])
        os.seteuid(65534)
        yield
        os.seteuid(0)
    else:
        Path("run").chmod(0o000)
        Path("open").mkdir()
        here.chmod(0o555)
        yield
        here.chmod(0o755)
        Path("run").chmod(0o700)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ("run --save open/a.rrd", "run can't be read: Permission denied"),
        ("run/episodes/trial-000000.npz --save open/a.rrd", "Permission denied"),
        ("open --save a.rrd", "a folder that may be written"),
    ],
)
def test_folders_without_permission_are_one_line(arguments, words, nobody, capsys):
    capsys.readouterr()
    assert replay.main(arguments.split()) == 2
    assert words in said(capsys)
