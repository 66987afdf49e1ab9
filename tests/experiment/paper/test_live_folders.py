"""Folders of live runs: which of them may be compared with which recording."""

import shutil
from dataclasses import replace

import pytest
import yaml
from ideal_env import IdealEnv
from live_by_hand import live_run

from prospect_mj.agent import LinearSettings
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.paper.live.live_folders import read_live
from prospect_mj.experiment.populations.scenario import PopulationSettings
from prospect_mj.experiment.run import config_file, fingerprint, session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.recording import provenance
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.key import RecordingKey

DEFAULT = PopulationSettings()
PHYSICS = RecordingKey.present(RecordingConfig())


def quiet(words):
    pass


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Two complete runs of twenty trials, and one that has had twelve."""
    folder = tmp_path_factory.mktemp("live")
    for seed in range(2):
        config = TrainConfig(trials=20, seed=seed)
        session.start(config, folder / f"seed-{seed}", IdealEnv, quiet)
    live_run(folder / "seed-2", [10] * 12, trials=20, seed=2)
    (folder / "notes").mkdir()
    return folder


@pytest.fixture
def one(tmp_path):
    """A run by itself."""
    live_run(tmp_path / "run", [10, 4, 2])
    return tmp_path


def read(folder, trials=3, settings=DEFAULT, physics=PHYSICS):
    return read_live(folder, trials, settings, physics)


def test_complete_runs_are_read_and_others_counted(runs):
    found = read(runs, 20)
    assert found.n_actions.shape == (2, 20)
    assert found.unfinished == 1
    with RunFolder.open(runs / "seed-1") as folder:
        taken = folder.trials["n_actions"].to_pylist()
    assert found.n_actions[1].tolist() == taken


def test_fewer_trials_are_the_first_ones(runs):
    found = read(runs, 10)
    assert found.n_actions.shape == (3, 10)
    assert found.unfinished == 0
    all_trials = read(runs, 20).n_actions
    assert found.n_actions[:2].tolist() == all_trials[:, :10].tolist()


def test_a_run_that_was_killed_at_its_birth_is_unfinished(one):
    (one / "run" / "trials.parquet").unlink()
    found = read(one)
    assert (len(found.n_actions), found.unfinished) == (0, 1)


@pytest.mark.parametrize(
    "settings",
    [
        {"supervisor": "safe"},
        {"shaping": ("grasp-left:3",)},
        {"pretrain": 2},
        {"physics": "recorded"},
        {"gross_motion": "cartesian"},
        {"object_pose": "truth"},
        {"bootstrap_at_truncation": False},
        {"max_actions": 9},
        {"learner": LinearSettings(initial_sd=0.0)},
    ],
    ids=lambda settings: next(iter(settings)),
)
def test_runs_with_other_settings_are_refused(tmp_path, settings):
    live_run(tmp_path / "run", [4, 4, 4], **settings)
    (name,) = settings
    with pytest.raises(RunFolderError, match=name.replace("_", " ")):
        read(tmp_path)


def test_settings_of_the_population_count_not_the_defaults(tmp_path):
    live_run(tmp_path / "run", [4, 4, 4], supervisor="safe", shaping=("grasp-left:3",))
    safe = replace(DEFAULT, supervisor="safe", shaping=("grasp-left:3",))
    assert read(tmp_path, settings=safe).n_actions.tolist() == [[4, 4, 4]]


@pytest.mark.parametrize("name", PHYSICS.sha256)
def test_runs_of_other_physics_than_was_recorded_are_refused(runs, name):
    other = replace(PHYSICS, sha256={**PHYSICS.sha256, name: "another digest"})
    with pytest.raises(RunFolderError, match=f"{name} changed"):
        read(runs, 10, physics=other)


@pytest.mark.parametrize("package", ["mujoco", "scipy"])
def test_runs_of_other_versions_than_the_recordings_are_refused(runs, package):
    other = replace(PHYSICS, versions={**PHYSICS.versions, package: "0.1"})
    words = f"made with {package} .*, the recording with 0.1"
    with pytest.raises(RunFolderError, match=words):
        read(runs, 10, physics=other)


def test_runs_of_another_learner_are_refused(tmp_path):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(fingerprint, "learner_digest", lambda name: "another learner")
        live_run(tmp_path / "run", [10, 4, 2])
    with pytest.raises(RunFolderError, match="the learner's code changed since"):
        read(tmp_path)
    with pytest.raises(RunFolderError, match="learner has changed since the run began"):
        config_file.read(tmp_path / "run" / "config.yaml")


def test_runs_that_do_not_note_their_learner_are_read_but_not_continued(tmp_path):
    known = fingerprint.digests

    def without(config):
        found = known(config)
        del found[fingerprint.LEARNER]
        return found

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(fingerprint, "digests", without)
        live_run(tmp_path / "run", [10, 4, 2])
    assert read(tmp_path).n_actions.tolist() == [[10, 4, 2]]
    with pytest.raises(RunFolderError, match="does not note its learner"):
        config_file.read(tmp_path / "run" / "config.yaml")


def test_finished_runs_are_read_by_later_software_that_would_not_go_on_with_them(
    one, monkeypatch
):
    path = one / "run" / "config.yaml"
    versions = provenance.installed_versions(config_file.PACKAGES)
    later = versions | {"prospect-mj": "99.0", "numpy": "99.0"}
    monkeypatch.setattr(provenance, "installed_versions", lambda packages: later)
    digests = {"models/torso.xml": "another digest"}
    monkeypatch.setattr(fingerprint, "model_digests", lambda: digests)
    monkeypatch.setattr(fingerprint, "source_digest", lambda: "changed since")
    with pytest.raises(RunFolderError, match=r"99\.0 is installed"):
        config_file.read(path)
    assert read(one).n_actions.tolist() == [[10, 4, 2]]


def test_edited_settings_are_refused(one):
    path = one / "run" / "config.yaml"
    stored = yaml.safe_load(path.read_text())
    stored["config"]["learner"]["epsilon"] = 0.3
    path.write_text(yaml.safe_dump(stored))
    with pytest.raises(RunFolderError, match="settings were edited"):
        read(one)


def test_a_run_that_is_there_twice_is_refused(tmp_path, runs):
    shutil.copytree(runs / "seed-0", tmp_path / "seed-0")
    shutil.copytree(runs / "seed-0", tmp_path / "seed-1")
    with pytest.raises(RunFolderError, match=r"seed-1 .* has the seed of seed-0, 0"):
        read(tmp_path)


def test_folders_without_any_run_say_what_is_the_matter(tmp_path):
    with pytest.raises(RunFolderError, match="no run folder"):
        read(tmp_path)
    with pytest.raises(RunFolderError, match=r"nowhere, .* is not there"):
        read(tmp_path / "nowhere")
    (tmp_path / "notes.txt").touch()
    with pytest.raises(RunFolderError, match=r"notes\.txt, .* is not a folder"):
        read(tmp_path / "notes.txt")


def test_damaged_runs_are_refused(one, runs):
    file = one / "run" / "trials.parquet"
    file.write_bytes(file.read_bytes()[:100])
    with pytest.raises(RunFolderError, match="damaged"):
        read(one)
    shutil.copy(runs / "seed-1" / "trials.parquet", file)
    with pytest.raises(RunFolderError, match="from another run"):
        read(one)


@pytest.mark.parametrize("part", [0, 0.3, 0.6, 0.8])
def test_a_half_written_configuration_is_refused(one, part):
    path = one / "run" / "config.yaml"
    whole = path.read_text()
    path.write_text(whole[: int(part * len(whole))])
    with pytest.raises(RunFolderError, match="run"):
        read(one)
