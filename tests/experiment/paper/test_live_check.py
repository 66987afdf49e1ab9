import shutil
from dataclasses import replace

import numpy as np
import pytest
from ideal_env import IdealEnv
from synthetic import improving, pair

from prospect_mj.agent import LearnerSettings
from prospect_mj.errors import InvalidValue, RunFolderError
from prospect_mj.experiment import session
from prospect_mj.experiment.config import TrainConfig
from prospect_mj.experiment.paper import figures, live_check, live_runs
from prospect_mj.experiment.paper.live_check import FoundRuns, read_live
from prospect_mj.experiment.paper.live_runs import LiveRuns
from prospect_mj.experiment.paper.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.run_folder import RunFolder
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.provenance import model_digests, source_digest

DEFAULT = PopulationSettings()
SHA256 = model_digests() | {"sources": source_digest()}
PHYSICS = RecordingKey(RecordingConfig(), SHA256, {}, {})


def quiet(words):
    pass


def run(path, **settings):
    session.start(TrainConfig(**settings), path, IdealEnv, quiet)


def stop_after(n_trials):
    """An environment that is interrupted in the trial after so many."""

    class Stopping(IdealEnv):
        def reset(self, *, seed, options):
            if options["trial"] >= n_trials:
                raise KeyboardInterrupt
            return super().reset(seed=seed, options=options)

    return Stopping


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Two complete runs of twenty trials, and one that was stopped after twelve."""
    folder = tmp_path_factory.mktemp("live")
    for seed in range(2):
        run(folder / f"seed-{seed}", trials=20, seed=seed)
    config = TrainConfig(trials=20, seed=2)
    with pytest.raises(KeyboardInterrupt):
        session.start(config, folder / "seed-2", stop_after(12), quiet)
    (folder / "notes").mkdir()
    return folder


def test_complete_runs_are_read_and_others_counted(runs):
    found = read_live(runs, 20, DEFAULT, PHYSICS)
    assert found.n_actions.shape == (2, 20)
    assert found.unfinished == 1
    with RunFolder.open(runs / "seed-1") as folder:
        taken = folder.trials["n_actions"].to_pylist()
    assert found.n_actions[1].tolist() == taken


def test_fewer_trials_are_the_first_ones(runs):
    found = read_live(runs, 10, DEFAULT, PHYSICS)
    assert found.n_actions.shape == (3, 10)
    assert found.unfinished == 0
    all_trials = read_live(runs, 20, DEFAULT, PHYSICS).n_actions
    np.testing.assert_array_equal(found.n_actions[:2], all_trials[:, :10])


@pytest.mark.parametrize(
    "settings",
    [
        {"supervisor": "safe"},
        {"pretrain": 5},
        {"gross_motion": "cartesian"},
        {"bootstrap_at_truncation": False},
        {"max_actions": 9},
        {"learner": LearnerSettings(initial_sd=0.0)},
    ],
    ids=lambda settings: next(iter(settings)),
)
def test_runs_with_other_settings_are_refused(tmp_path, settings):
    run(tmp_path / "run", trials=6, **settings)
    (name,) = settings
    with pytest.raises(RunFolderError, match=name.replace("_", " ")):
        read_live(tmp_path, 6, DEFAULT, PHYSICS)


@pytest.mark.parametrize(
    "settings",
    [{"image_noise": 0.05}, {"presentations": 1}],
    ids=lambda settings: next(iter(settings)),
)
def test_populations_that_training_can_not_be_like_are_refused(runs, settings):
    (name,) = settings
    with pytest.raises(RunFolderError, match=name.replace("_", " ")):
        read_live(runs, 10, replace(DEFAULT, **settings), PHYSICS)


@pytest.mark.parametrize("name", SHA256)
def test_runs_of_other_physics_than_was_recorded_are_refused(runs, name):
    other = replace(PHYSICS, sha256=SHA256 | {name: "another digest"})
    with pytest.raises(RunFolderError, match=f"{name} changed"):
        read_live(runs, 10, DEFAULT, other)


def test_a_run_that_is_there_twice_is_refused(tmp_path, runs):
    shutil.copytree(runs / "seed-0", tmp_path / "seed-0")
    shutil.copytree(runs / "seed-0", tmp_path / "seed-1")
    with pytest.raises(RunFolderError, match=r"seed-1 .* has the seed of seed-0, 0"):
        read_live(tmp_path, 10, DEFAULT, PHYSICS)


def test_damaged_runs_and_folders_without_any_are_refused(tmp_path, runs):
    with pytest.raises(RunFolderError, match="no run folder"):
        read_live(tmp_path, 10, DEFAULT, PHYSICS)
    shutil.copytree(runs / "seed-0", tmp_path / "run")
    file = tmp_path / "run" / "trials.parquet"
    file.write_bytes(file.read_bytes()[:100])
    with pytest.raises(RunFolderError, match="damaged"):
        read_live(tmp_path, 10, DEFAULT, PHYSICS)
    shutil.copy(runs / "seed-1" / "trials.parquet", file)
    with pytest.raises(RunFolderError, match="from another run"):
        read_live(tmp_path, 10, DEFAULT, PHYSICS)


def test_runs_of_the_same_kind_leave_the_band_as_rarely_as_it_says():
    rng = np.random.default_rng(0)
    curves = np.cumsum(rng.standard_normal((500, 30)), axis=1)
    low, high = live_check.simultaneous_band(curves, 20, rng, 1500)
    fresh = np.cumsum(rng.standard_normal((300, 20, 30)), axis=2).mean(axis=1)
    inside = ((low <= fresh) & (fresh <= high)).all(axis=1)
    # Binomial: 285 expected, standard deviation 4.
    assert 268 <= inside.sum() <= 297
    pointwise = np.quantile(fresh, [0.025, 0.975], axis=0)
    assert (low < pointwise[0] + 0.05).all()
    assert (high - low > pointwise[1] - pointwise[0]).all()


def test_runs_that_are_all_alike_have_a_band_without_width():
    curves = np.tile([3.0, 2.0], (7, 1))
    band = live_check.simultaneous_band(curves, 4, np.random.default_rng(0), 50)
    np.testing.assert_allclose(band, [[3, 2], [3, 2]])


def test_live_runs_agree_with_their_like_and_not_with_others():
    recorded, rng = pair(runs=300)[0], np.random.default_rng(0)
    like = improving(20, Scenario(1000), 77).n_actions
    check = live_check.check(FoundRuns(like, 3), recorded, rng)
    assert check.agrees
    assert (check.runs, check.unfinished, check.inside) == (20, 3, 1.0)
    slow = improving(20, Scenario(1000), 77, speed=0.8).n_actions
    check = live_check.check(FoundRuns(slow, 0), recorded, rng)
    assert not check.agrees
    assert 0 < check.inside < 0.9


def test_without_a_complete_run_nothing_is_compared():
    none = FoundRuns(np.empty((0, 1000), np.int64), 4)
    check = live_check.check(none, pair(runs=5)[0], np.random.default_rng(0))
    assert (check.runs, check.unfinished, check.agrees) == (0, 4, False)
    assert check.table.num_rows == 0


def test_both_are_drawn():
    recorded, rng = pair(runs=50)[0], np.random.default_rng(0)
    check = live_check.check(FoundRuns(recorded.n_actions[:5], 0), recorded, rng)
    heading = figures.Heading("Title", "means")
    once, again = (figures.live(check.table, heading, 10, 2.0, 5) for _ in range(2))
    assert once == again
    moved = check.table.set_column(1, "live", check.table["recorded"])
    assert figures.live(moved, heading, 10, 2.0, 5) != once


def test_making_live_runs_starts_and_resumes_and_leaves_what_is_finished(
    tmp_path, runs
):
    wanted = LiveRuns(3, 20)
    (tmp_path / "all").mkdir()
    shutil.copytree(runs / "seed-0", tmp_path / "all" / "seed-0000")
    shutil.copytree(runs / "seed-2", tmp_path / "all" / "seed-0002")
    before = (tmp_path / "all" / "seed-0000" / "trials.parquet").stat()
    done = list(live_runs.advance(wanted, tmp_path / "all", 1, IdealEnv))
    assert sorted(path.name for path in done) == ["seed-0000", "seed-0001", "seed-0002"]
    after = (tmp_path / "all" / "seed-0000" / "trials.parquet").stat()
    assert after.st_mtime_ns == before.st_mtime_ns
    found = read_live(tmp_path / "all", 20, DEFAULT, PHYSICS)
    assert found.unfinished == 0
    run(tmp_path / "never-stopped" / "run", trials=20, seed=2)
    straight = read_live(tmp_path / "never-stopped", 20, DEFAULT, PHYSICS)
    np.testing.assert_array_equal(found.n_actions[2], straight.n_actions[0])


def test_making_live_runs_says_nothing_of_each(tmp_path, capsys):
    list(live_runs.advance(LiveRuns(1, 3), tmp_path, 1, IdealEnv))
    said = capsys.readouterr()
    assert said.out == said.err == ""


@pytest.mark.parametrize("sizes", [(0, 10), (-1, 10), (5, 0), (10**9, 10)])
def test_no_runs_or_absurdly_many_are_refused(sizes):
    with pytest.raises(InvalidValue):
        LiveRuns(*sizes)
