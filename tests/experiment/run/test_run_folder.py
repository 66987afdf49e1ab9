import signal
import subprocess
import sys
import time
from pathlib import Path

import ideal_env
import numpy as np
import pyarrow.parquet as pq
import pytest
import yaml
from ideal_env import IdealEnv
from ideal_grower import grown_tree

from prospect_mj import paths, storage
from prospect_mj.agent import LinearSettings, checkpoint
from prospect_mj.errors import FolderInUse, RecordingError, RunFolderError
from prospect_mj.experiment.run import config_file, fingerprint, folder_guard, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.records import ACTION_SCHEMA, TRIAL_SCHEMA
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.locking import LockedFolder
from prospect_mj.recording import provenance
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.key import RecordingKey

CONFIG = TrainConfig(trials=4, pretrain=2, seed=4)
FILES = {
    "config.yaml",
    "actions.parquet",
    "trials.parquet",
    "weights.npz",
    "learning_curve.png",
}
LAST_WORD = {"say": lambda _: None}


@pytest.fixture(scope="module", autouse=True)
def quick_curve():
    """Draw nothing: `test_plots.py` does, and here it would take most of the time."""
    with pytest.MonkeyPatch.context() as patches:
        patches.setattr(session.plots, "learning_curve", lambda *_: b"a picture")
        yield


def make_env(config):
    return IdealEnv(config, noise=0.05)


def content(folder):
    return {file.name: file.read_bytes() for file in Path(folder).iterdir()}


@pytest.fixture(scope="module")
def uninterrupted(tmp_path_factory, quick_curve):
    folder = tmp_path_factory.mktemp("runs") / "whole"
    session.start(CONFIG, folder, make_env, **LAST_WORD)
    return content(folder)


def test_folder_holds_what_is_promised(uninterrupted, tmp_path):
    assert set(uninterrupted) == FILES
    for name, data in uninterrupted.items():
        (tmp_path / name).write_bytes(data)
    actions = pq.read_table(tmp_path / "actions.parquet")
    trials = pq.read_table(tmp_path / "trials.parquet")
    assert actions.schema == ACTION_SCHEMA
    assert trials.schema == TRIAL_SCHEMA
    assert trials["trial"].to_pylist() == list(range(4))
    assert sum(trials["n_actions"].to_pylist()) == actions.num_rows
    learner = checkpoint.read(tmp_path / "weights.npz").learner
    assert learner.n_updates == actions.num_rows
    assert learner.weights.any()
    stored = yaml.safe_load((tmp_path / "config.yaml").read_text())
    assert stored["config"]["trials"] == 4
    assert stored["versions"]["numpy"] == np.__version__
    assert {"mujoco", "mink", "prospect-mj"} <= stored["versions"].keys()


def test_same_seed_gives_the_same_bytes(uninterrupted, tmp_path):
    session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    assert content(tmp_path) == uninterrupted


class Killed(BaseException):
    pass


def kill_at_write(monkeypatch, number, before):
    """Stop everything right before or after the given file replacement."""
    writes = iter(range(1000))
    replace = Path.replace

    def dying_replace(source, target):
        dies = next(writes) == number
        if dies and before:
            raise Killed
        replace(source, target)
        if dies:
            raise Killed

    monkeypatch.setattr(Path, "replace", dying_replace)
    # A killed process does not tidy up.
    monkeypatch.setattr(Path, "unlink", lambda *_, **__: None)


@pytest.mark.parametrize("write", range(4))
def test_death_at_birth_leaves_a_folder_that_can_be_used(
    write, uninterrupted, tmp_path, monkeypatch
):
    with monkeypatch.context() as patches:
        kill_at_write(patches, write, before=True)
        with pytest.raises(Killed):
            session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    assert any(tmp_path.iterdir())
    if write == 0:
        session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    else:
        session.resume(tmp_path, CONFIG, make_env, **LAST_WORD)
    assert content(tmp_path) == uninterrupted


# 4 writes make the folder, 3 more each trial, 1 the curve.
WRITES = range(4, 4 + 3 * 4 + 1)


@pytest.mark.parametrize(
    ("write", "before"), [*((write, True) for write in WRITES), (WRITES[-1], False)]
)
def test_death_at_any_write_then_resume_equals_uninterrupted(
    write, before, uninterrupted, tmp_path, monkeypatch
):
    with monkeypatch.context() as patches:
        kill_at_write(patches, write, before)
        with pytest.raises(Killed):
            session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    with RunFolder.open(tmp_path) as folder:
        finished = (write - 4 + (not before)) // 3
        assert folder.n_trials == finished
    session.resume(tmp_path, CONFIG, make_env, **LAST_WORD)
    assert content(tmp_path) == uninterrupted


def test_killed_process_loses_no_finished_trial(tmp_path):
    """SIGKILL of a real process and of the one that resumed it, then to the end."""
    script, killed, whole = ideal_env.__file__, tmp_path / "killed", tmp_path / "whole"
    config = TrainConfig(trials=100, seed=7)
    begin = ["--trials", "100", "--seed", "7", "--out", str(killed)]
    for options in (begin, ["--resume", str(killed)]):
        before = trials_done(killed)
        process = subprocess.Popen(
            [sys.executable, script, "0.002", *options], stdout=subprocess.DEVNULL
        )
        deadline = time.monotonic() + 60
        while trials_done(killed) < before + 15 and time.monotonic() < deadline:
            time.sleep(0.002)
        process.kill()
        assert process.wait() == -signal.SIGKILL
        assert before + 15 <= trials_done(killed) < 100
    session.resume(killed, config, make_env, **LAST_WORD)
    session.start(config, whole, make_env, **LAST_WORD)
    assert content(killed) == content(whole)


def trials_done(folder):
    try:
        return pq.read_metadata(folder / "trials.parquet").num_rows
    except FileNotFoundError:
        return 0


def test_finished_run_stays_as_it_is(uninterrupted, tmp_path):
    session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    times = {file: file.stat().st_mtime_ns for file in tmp_path.iterdir()}
    said = []
    assert session.resume(tmp_path, CONFIG, make_env, said.append) is None
    assert "finished" in said[0]
    assert content(tmp_path) == uninterrupted
    assert {file: file.stat().st_mtime_ns for file in tmp_path.iterdir()} == times


def test_extended_run_equals_a_longer_one(uninterrupted, tmp_path):
    short = CONFIG.with_trials(3)
    session.start(short, tmp_path, make_env, **LAST_WORD)
    session.resume(tmp_path, CONFIG, make_env, **LAST_WORD)
    assert content(tmp_path) == uninterrupted


def test_run_cannot_be_shortened(tmp_path):
    session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    with pytest.raises(RunFolderError, match="only add"):
        session.resume(tmp_path, CONFIG.with_trials(3), make_env)


@pytest.mark.parametrize(
    ("other", "named"),
    [
        (TrainConfig(trials=4, pretrain=2, seed=5), "seed is 4, not 5"),
        (TrainConfig(trials=9, pretrain=1, seed=4), "pretrain is 2, not 1"),
        (
            TrainConfig(4, 2, seed=4, learner=LinearSettings(epsilon=0.5)),
            r"its learner\.epsilon is 0\.05, not 0\.5$",
        ),
    ],
)
def test_other_configuration_is_refused(tmp_path, other, named):
    session.start(CONFIG, tmp_path, make_env, **LAST_WORD)
    before = content(tmp_path)
    with pytest.raises(RunFolderError, match=named):
        session.resume(tmp_path, other, make_env)
    assert content(tmp_path) == before


@pytest.mark.parametrize("name", sorted(FILES - {"learning_curve.png"}))
@pytest.mark.parametrize("damage", ["empty", "half", "text", "gone"])
def test_damaged_file_is_named_and_nothing_is_written(
    name, damage, uninterrupted, tmp_path
):
    for file, data in uninterrupted.items():
        (tmp_path / file).write_bytes(data)
    (tmp_path / "learning_curve.png").unlink()
    victim = tmp_path / name
    match damage:
        case "empty":
            victim.write_bytes(b"")
        case "half":
            victim.write_bytes(uninterrupted[name][: len(uninterrupted[name]) // 2])
        case "text":
            victim.write_text("not: [this")
        case "gone":
            victim.unlink()
    before = content(tmp_path)
    with pytest.raises(RunFolderError, match=name.replace(".", r"\.")):
        session.resume(tmp_path, CONFIG, make_env)
    assert content(tmp_path) == before


@pytest.mark.parametrize("name", ["actions.parquet", "trials.parquet", "weights.npz"])
def test_file_of_another_run_is_noticed(name, uninterrupted, tmp_path):
    """Also of a run that took as many actions in as many trials."""
    run, other = tmp_path / "run", tmp_path / "other"
    for seed, folder in ((0, run), (99, other)):
        config = TrainConfig(trials=1, max_actions=1, seed=seed)
        session.start(config, folder, make_env, **LAST_WORD)
    (run / name).write_bytes((other / name).read_bytes())
    before = content(run)
    with pytest.raises(RunFolderError, match=f"{name} is from another run"):
        session.resume(run, TrainConfig(trials=1, max_actions=1), make_env)
    assert content(run) == before


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("energy: 2.4", "energy: 2.5"),
        ("seed: 4", "seed: 5"),
        ("pretrain: 2", "pretrain: 1"),
        ("epsilon: 0.05", "epsilon: 0.06"),
        ("bootstrap_at_truncation: true", "bootstrap_at_truncation: false"),
    ],
)
@pytest.mark.parametrize("digests_too", [False, True])
def test_edited_configuration_is_refused(
    old, new, digests_too, uninterrupted, tmp_path
):
    for file, data in uninterrupted.items():
        (tmp_path / file).write_bytes(data)
    path = tmp_path / "config.yaml"
    text = path.read_text()
    assert text.count(old) == 1
    stored = yaml.safe_load(text.replace(old, new))
    edited = TrainConfig.from_dict(stored["config"])
    if digests_too:
        stored["sha256"] = fingerprint.digests(edited)
    path.write_text(yaml.safe_dump(stored))
    before = content(tmp_path)
    named = "another run" if digests_too else "settings were edited"
    with pytest.raises(RunFolderError, match=named):
        session.resume(tmp_path, edited.with_trials(9), make_env)
    assert content(tmp_path) == before


@pytest.mark.parametrize(
    ("function", "name"),
    [
        ("torso_xml", "models/torso.xml"),
        ("jar_obj", "assets/jar.obj"),
        ("jar_png", "assets/jar.png"),
    ],
)
def test_changed_model_file_is_refused(function, name, tmp_path, monkeypatch):
    run, copy = tmp_path / "run", tmp_path / "copy"
    session.start(CONFIG, run, make_env, **LAST_WORD)
    before = content(run)
    copy.write_bytes(getattr(paths, function)().read_bytes())
    files = {**provenance._MODEL_FILES, name: lambda: copy}
    monkeypatch.setattr(provenance, "_MODEL_FILES", files)
    RunFolder.open(run).close()
    copy.write_bytes(copy.read_bytes() + b" ")
    with pytest.raises(RunFolderError, match=f"{name} has changed"):
        session.resume(run, CONFIG.with_trials(9), make_env)
    assert content(run) == before


def test_configuration_with_fewer_trials_than_were_run_is_refused(
    uninterrupted, tmp_path
):
    for file, data in uninterrupted.items():
        (tmp_path / file).write_bytes(data)
    path = tmp_path / "config.yaml"
    path.write_text(path.read_text().replace("trials: 4", "trials: 3"))
    with pytest.raises(RunFolderError, match="don't fit together"):
        RunFolder.open(tmp_path)


def test_table_with_other_columns_is_refused(uninterrupted, tmp_path):
    for file, data in uninterrupted.items():
        (tmp_path / file).write_bytes(data)
    table = pq.read_table(tmp_path / "trials.parquet")
    pq.write_table(table.drop_columns("solved"), tmp_path / "trials.parquet")
    with pytest.raises(RunFolderError, match="columns"):
        RunFolder.open(tmp_path)


def test_other_versions_are_refused(uninterrupted, tmp_path):
    for file, data in uninterrupted.items():
        (tmp_path / file).write_bytes(data)
    path = tmp_path / "config.yaml"
    stored = yaml.safe_load(path.read_text())
    stored["versions"]["mujoco"] = "1.0"
    path.write_text(yaml.safe_dump(stored))
    with pytest.raises(RunFolderError, match=r"mujoco 1\.0"):
        RunFolder.open(tmp_path)


def test_configuration_may_hold_numpy_floats(tmp_path):
    learner = LinearSettings(epsilon=np.float64(0.1))
    config = TrainConfig(trials=1, learner=learner)
    session.start(config, tmp_path, make_env, **LAST_WORD)
    assert config_file.read(tmp_path / "config.yaml") == config


def test_foreign_yaml_is_refused(tmp_path):
    (tmp_path / "config.yaml").write_text("trials: 5\n")
    with pytest.raises(RunFolderError, match="not the configuration of a run"):
        config_file.read(tmp_path / "config.yaml")


def test_folder_belongs_to_one_process(tmp_path):
    with (
        RunFolder.create(tmp_path / "run", CONFIG),
        pytest.raises(FolderInUse, match="in use"),
    ):
        RunFolder.open(tmp_path / "run")
    RunFolder.open(tmp_path / "run").close()


def test_failed_environment_leaves_no_folder(tmp_path):
    with pytest.raises(Exception, match="OpenGL"):
        session.start(CONFIG, tmp_path / "a" / "b", ideal_env.refuse)
    assert not list(tmp_path.iterdir())


def test_environment_is_closed(tmp_path):
    made = []
    session.start(
        CONFIG,
        tmp_path,
        lambda config: made.append(make_env(config)) or made[0],
        **LAST_WORD,
    )
    assert made[0].closed


def test_default_folder_is_the_first_free_one(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "runs" / "train-0002").mkdir(parents=True)
    for expected in ("train-0001", "train-0003"):
        summary = session.start(CONFIG.with_trials(2), None, make_env, **LAST_WORD)
        assert summary.path == Path("runs") / expected


@pytest.mark.parametrize("name", ["file", "file/below"])
def test_out_below_or_at_a_file_is_refused(tmp_path, name):
    (tmp_path / "file").touch()
    with pytest.raises(RunFolderError):
        folder_guard.check_free(tmp_path / name)


def test_unwritable_parent_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("os.access", lambda *_: False)
    with pytest.raises(RunFolderError, match="can't be written"):
        folder_guard.check_free(tmp_path / "new")


def test_full_disk_is_an_error_of_the_machine_and_names_the_file(tmp_path, monkeypatch):
    def full(*_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(storage.os, "fsync", full)
    with pytest.raises(OSError, match=r"No space left.*run/config\.yaml"):
        RunFolder.create(tmp_path / "run", CONFIG)
    assert is_free(tmp_path / "run")


def is_free(path):
    LockedFolder(path).close()
    return not list(path.iterdir())


class Blind(IdealEnv):
    def watch(self):
        raise RecordingError("nothing to be seen")


def test_what_can_keep_no_episodes_is_refused_before_there_is_a_run(tmp_path):
    with pytest.raises(RecordingError):
        session.start(CONFIG, tmp_path / "run", Blind, kept=Kept(1), **LAST_WORD)
    assert not (tmp_path / "run").exists()


def test_what_can_keep_no_episodes_is_refused_before_the_run_is_longer(tmp_path):
    path = tmp_path / "run"
    session.start(CONFIG, path, Blind, **LAST_WORD)
    before = content(path)
    with pytest.raises(RecordingError):
        session.resume(path, CONFIG.with_trials(9), Blind, kept=Kept(1), **LAST_WORD)
    assert content(path) == before


def recorded_into(folder, number):
    """One more tree, as `prospect record` or a run that grows the folder makes it."""
    key = RecordingKey.present(RecordingConfig())
    with GrowingRecording.open(folder, key) as recording:
        recording.keep(grown_tree(1, "right", number))


@pytest.mark.parametrize("number", [0, 49])
def test_a_run_goes_on_in_a_recording_that_grew_by_what_it_draws(number, tmp_path):
    run, recording = tmp_path / "run", tmp_path / "recording"
    recorded_into(recording, 0)
    config = growing(recording)
    session.start(config, run, make_env, **LAST_WORD)
    recorded_into(recording, number)
    session.resume(run, config.with_trials(9), make_env, **LAST_WORD)
    with RunFolder.open(run) as folder:
        assert folder.n_trials == 9


def test_a_recording_from_which_a_run_would_draw_others_is_refused(tmp_path):
    run, recording = tmp_path / "run", tmp_path / "recording"
    recorded_into(recording, 0)
    config = growing(recording)
    session.start(config, run, make_env, **LAST_WORD)
    before = content(run)
    recorded_into(recording, 50)
    with pytest.raises(RunFolderError, match=r"number of presentations .* has changed"):
        session.resume(run, config.with_trials(9), make_env, **LAST_WORD)
    assert content(run) == before
    (outdated,) = RunView.read(run).outdated()
    assert "number of presentations" in outdated


def growing(recording):
    return TrainConfig(
        trials=4, physics="recorded", recording=str(recording), grow=True
    )
