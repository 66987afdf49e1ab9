"""Replaying from the command line."""

import os
import shutil
import signal
from pathlib import Path

import numpy as np
import pytest

from prospect_mj.cli import replay, replay_files, video
from prospect_mj.errors import EpisodeError
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.kept_episodes import Kept, path_of
from prospect_mj.replay import rerun_export, viewer

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


def said_beside(capsys, printed):
    """The only line on stderr, beside one line on stdout."""
    out, err = capsys.readouterr()
    assert out == f"{printed}\n"
    (line,) = err.splitlines()
    return line


BAD = {
    "empty --save a.rrd": "empty is not a run folder",
    "none --save a.rrd": "none is not a run folder",
    "run": "there is no display",
    "none": "none is not a run folder",
    "empty": "empty is not a run folder",
    "run --trial 2": "--trial is 2; expected 0 to 1",
    "gone.npz": "there is no episode gone.npz",
    "notes.npz": "it is damaged, or none",
    "run --save there.rrd": "a file that does not exist",
    "run --save a.mp4": "a name that ends in .rrd",
    "run --save none/a.rrd": "a folder that exists",
    "run --save a.rrd --serve": "none beside --save",
    "run --save a.rrd --port 8000": "--port is 8000; expected none without --serve",
    "run --host 0.0.0.0": "--host is '0.0.0.0'; expected none without --serve",
    "": "RUN",
    "run --serve --port 0": "--port",
    "run --serve --host localhost": "an IPv4 address",
    "run --save a.rrd --trial 2": "0 to 1, as far as the run has come",
    "run --save a.rrd --trial -1": "0 to 1, as far as the run has come",
    "run --save a.rrd --trial one": "--trial is 'one'; expected a whole number",
    "run --save a.rrd --trial 0 --worst": "one of --trial, --worst, --failures",
    "run --save there.rrd --failures": "a folder beside --failures",
    "run --save new.rrd --failures": "a folder beside --failures",
    "run --save notes.npz --failures": "notes.npz is not a folder",
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
def test_what_cant_be_replayed_is_one_line(arguments, here, refused):
    assert BAD[arguments] in refused(lambda: replay.main(arguments.split()))


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
def test_what_cant_be_filmed_is_one_line(arguments, here, refused):
    assert BAD_VIDEO[arguments] in refused(lambda: video.main(arguments.split()))


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


@pytest.fixture
def two(here):
    """The run with both of its trials kept, neither of them solved."""
    shutil.copy(path_of(Path("run"), 0), path_of(Path("run"), 1))
    return [path_of(Path("run"), number) for number in (0, 1)]


SAVE = ["run", "--failures", "--save", "new/folder"]


@pytest.mark.parametrize("damaged", [0, 1])
def test_a_trial_that_cant_be_read_keeps_no_other_from_being_saved(
    damaged, two, capsys
):
    two[damaged].write_bytes(b"PK")
    assert replay.main(SAVE) == 0
    line = said_beside(capsys, f"new/folder/trial-00000{1 - damaged}.rrd")
    assert line.startswith(f"warning: trial-00000{damaged} is left out: ")
    assert "can't be read as an episode" in line
    assert [path.stem for path in Path("new/folder").iterdir()] == [
        f"trial-00000{1 - damaged}"
    ]


def test_a_trial_that_cant_be_exported_leaves_nothing_behind(two, capsys, monkeypatch):
    usual, given = rerun_export.log_panels, []

    def log_panels(*what):
        given.append(what)
        if len(given) == 1:
            raise EpisodeError("its states are of no use")
        usual(*what)

    monkeypatch.setattr(rerun_export, "log_panels", log_panels)
    assert replay.main(SAVE) == 0
    line = said_beside(capsys, "new/folder/trial-000001.rrd")
    assert line == "warning: trial-000000 is left out: its states are of no use"
    assert [path.name for path in Path("new/folder").iterdir()] == ["trial-000001.rrd"]


@pytest.mark.parametrize("folder", ["new/folder", "empty"])
def test_if_none_can_be_saved_that_is_one_line_and_no_folder(folder, two, refused):
    for path in two:
        path.write_bytes(b"PK")
    line = refused(lambda: replay.main([*SAVE[:-1], folder]))
    assert line.startswith("error: none of the 2 trials can be replayed: trial-000000")
    assert "can't be read as an episode" in line


def test_what_was_saved_before_a_failure_of_the_machine_is_named(
    two, capsys, monkeypatch
):
    usual = replay_files.export

    def export(episode, story, path):
        if path.stem == "trial-000001":
            raise OSError("No space left on device")
        usual(episode, story, path)

    monkeypatch.setattr(replay_files, "export", export)
    assert replay.main(SAVE) == 1
    assert said_beside(capsys, "new/folder/trial-000000.rrd") == (
        "error: No space left on device"
    )


def test_the_viewer_opens_what_can_be_shown(two, monkeypatch, capsys):
    shown = []
    monkeypatch.setattr(viewer, "serve", lambda files, *_: shown.extend(files))
    two[0].write_bytes(b"PK")
    port = str(viewer.free_port())
    assert replay.main(["run", "--failures", "--serve", "--port", port]) == 0
    assert [path.name for path in shown] == ["trial-000001.rrd"]
    assert said(capsys).startswith("warning: trial-000000 is left out: ")


def test_an_episode_is_replayed_without_its_run(here, capsys):
    shutil.copy(path_of(Path("run"), 0), "alone.npz")
    assert replay.main(["alone.npz", "--save", "alone.rrd"]) == 0


def test_a_viewer_that_is_missing_is_named_before_anything_is_done(
    here, refused, monkeypatch
):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert "pip install rerun-sdk" in refused(lambda: replay.main(["run", "--serve"]))


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
