"""The greedy policy of a run on fresh presentations, killed and gone on with."""

import shutil
from datetime import date
from pathlib import Path

import numpy as np
import pytest
import yaml
from ideal_env import IdealEnv, refuse
from left_handed import go_on, left_handed

from prospect_mj.errors import (
    FolderInUse,
    RecordingError,
    RenderingUnavailable,
    RunFolderError,
)
from prospect_mj.experiment.evaluation import evaluate as module
from prospect_mj.experiment.evaluation.evaluate import evaluate
from prospect_mj.experiment.evaluation.evaluation_folder import EvaluationFolder
from prospect_mj.experiment.run.kept_episodes import Kept
from prospect_mj.experiment.run.run_folder import RunFolder
from prospect_mj.experiment.run.training import Stream, trial_seed
from prospect_mj.experiment.view.evaluation_settings import EvaluationSettings
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.tables import parquet

SETTINGS = EvaluationSettings(trials=3, seed=5)


def quietly(run, settings=SETTINGS, out=None, make_env=IdealEnv):
    return evaluate(run, settings, out, make_env, say=lambda words: None)


def content(folder):
    return {file.name: file.read_bytes() for file in Path(folder).iterdir()}


@pytest.fixture
def run(tmp_path):
    return left_handed(tmp_path / "run")


def test_the_policy_is_greedy_and_learns_nothing(run):
    view = quietly(run)
    assert run.actions["explored"].to_numpy().all()
    assert not view.actions["explored"].to_numpy().any()
    np.testing.assert_array_equal(view.learner.weights, run.learner.weights)
    assert view.learner.n_updates == run.learner.n_updates
    q_values = np.array(view.actions["q_values"].to_pylist())
    chosen = q_values[np.arange(len(q_values)), view.actions["action"].to_numpy()]
    np.testing.assert_array_equal(chosen, q_values.max(axis=1))


def test_both_orientations_are_shown_in_turn(run):
    view = quietly(run)
    assert view.trials["orientation"].to_pylist() == ["left", "right"] * 3
    assert view.trials["solved"].to_pylist() == [True, False] * 3
    assert view.trials["n_actions"].to_pylist() == [2, 10] * 3
    assert not view.trials["pretraining"].to_numpy().any()


class Told(IdealEnv):
    """It remembers what it was told to show."""

    def reset(self, *, seed, options):
        self.seeds.append(seed)
        self.options.append(options)
        return super().reset(seed=seed, options=options)


@pytest.fixture
def told():
    Told.seeds, Told.options = [], []
    return Told


def test_a_view_knows_what_was_presented(run, told):
    view = quietly(run, make_env=told)
    assert told.seeds == [view.presentation_seed(trial) for trial in range(6)]
    left_handed(run.path.with_name("other"), make_env=told)
    assert told.seeds[6:] == [run.presentation_seed(trial) for trial in range(2)]


def test_no_training_has_shown_what_an_evaluation_shows():
    seeds = {
        EvaluationSettings(seed=seed).presentation_seed(trial)
        for seed in (0, 1, 2**63 - 1)
        for trial in range(200)
    }
    assert len(seeds) == 600
    # What trainings draw by has 32 bits.
    largest = trial_seed(0, 0, Stream.PRESENTATION).generate_state(1).dtype.itemsize
    assert largest == 4
    assert min(seeds) >= 2**63


def test_a_schedule_stays_where_the_training_had_come_to(tmp_path, told):
    shaping = ("grasp-left:3",)
    early = left_handed(tmp_path / "early", trials=2, shaping=shaping)
    late = left_handed(tmp_path / "late", trials=3, shaping=shaping)
    assert not quietly(early).trials["solved"].to_numpy().any()
    assert quietly(late, make_env=told).trials["solved"].to_numpy().sum() == 3
    assert {options["trial"] for options in told.options} == {3}


class Killed(BaseException):
    pass


def kill_at_write(monkeypatch, number):
    """Stop everything right before the given file replacement."""
    writes = iter(range(1000))
    replace = Path.replace

    def dying_replace(source, target):
        if next(writes) == number:
            raise Killed
        replace(source, target)

    monkeypatch.setattr(Path, "replace", dying_replace)
    # A killed process does not tidy up.
    monkeypatch.setattr(Path, "unlink", lambda *_, **__: None)


SHORT = EvaluationSettings(trials=2)
# Two writes begin it, two more each trial.
WRITES = range(2 + 2 * SHORT.n_trials)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """A run, and its evaluation that nothing stopped."""
    folder = tmp_path_factory.mktemp("whole")
    run = left_handed(folder / "run")
    return run, content(quietly(run, SHORT, folder / "whole").path)


@pytest.mark.parametrize(
    ("write", "named"), [*((write, True) for write in WRITES), (0, False), (5, False)]
)
def test_death_at_any_write_then_the_same_again_equals_uninterrupted(
    write, named, whole, tmp_path, monkeypatch
):
    shutil.copytree(whole[0].path, tmp_path / "run")
    run = RunView.read(tmp_path / "run")
    out = tmp_path / "cut" if named else None
    with monkeypatch.context() as patches:
        kill_at_write(patches, write)
        with pytest.raises(Killed):
            quietly(run, SHORT, out)
    cut = quietly(run, SHORT, out)
    assert content(cut.path) == whole[1]
    assert cut.path == (out or run.path / "evaluations" / "0001")


def test_a_finished_one_is_not_run_again(run):
    first = quietly(run)
    before = content(first.path)
    again = quietly(run, make_env=refuse)
    assert again.path == first.path
    assert content(again.path) == before


def test_another_one_has_a_folder_of_its_own(run):
    first = quietly(run)
    other = quietly(run, EvaluationSettings(trials=3, seed=6))
    assert [first.path.name, other.path.name] == ["0001", "0002"]
    assert quietly(run, make_env=refuse).path == first.path


def test_a_run_that_learns_on_leaves_an_evaluation_its_learner(run, monkeypatch):
    with monkeypatch.context() as patches:
        kill_at_write(patches, 7)
        with pytest.raises(Killed):
            quietly(run)
    longer = go_on(run.path, 5)
    finished = quietly(longer)
    assert finished.path.name == "0001"
    assert finished.evaluation.learned.trials == 2
    np.testing.assert_array_equal(finished.learner.weights, run.learner.weights)
    newer = quietly(longer)
    assert newer.path.name == "0002"
    assert newer.evaluation.learned.trials == 5
    with pytest.raises(RunFolderError, match="of the learner after 2 trials"):
        quietly(longer, out=finished.path)


def test_a_run_under_way_can_be_evaluated(run):
    with RunFolder.open(run.path):
        assert quietly(RunView.read(run.path)).n_trials == 6


def test_an_evaluation_under_way_can_be_viewed_after_each_trial(run):
    out, seen = run.path.with_name("out"), []

    class Viewed(IdealEnv):
        def reset(self, *, seed, options):
            if seen or (out / "trials.parquet").exists():
                seen.append(RunView.read(out).n_trials)
            return super().reset(seed=seed, options=options)

    quietly(run, out=out, make_env=Viewed)
    assert seen == [1, 2, 3, 4, 5]


def test_two_at_once_are_refused(run):
    view = quietly(run)
    with EvaluationFolder.open(view.path), pytest.raises(FolderInUse):
        quietly(run)


def test_nothing_is_written_where_nothing_can_be_simulated(run):
    with pytest.raises(RenderingUnavailable):
        quietly(run, make_env=refuse)
    assert not (run.path / "evaluations").exists()


def test_nothing_is_written_where_no_episode_can_be_kept(run):
    class Blind(IdealEnv):
        def watch(self):
            raise RecordingError("nothing to be seen")

    with pytest.raises(RecordingError):
        evaluate(run, SETTINGS, make_env=Blind, say=lambda _: None, kept=Kept(1))
    assert not (run.path / "evaluations").exists()


def test_an_evaluation_is_no_run(run):
    view = quietly(run)
    with pytest.raises(RunFolderError, match="is an evaluation, not a run"):
        quietly(view)
    with pytest.raises(RunFolderError, match="not a run folder"):
        RunFolder.open(view.path)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("weights.npz", "weights.npz can't be read"),
        ("actions.parquet", "actions.parquet can't be read"),
        ("trials.parquet", "trials.parquet can't be read"),
        ("evaluation.yaml", "evaluation.yaml"),
    ],
)
def test_a_damaged_one_is_named_and_kept(run, name, words):
    view = quietly(run)
    file = view.path / name
    file.write_bytes(file.read_bytes()[:60])
    damaged = content(view.path)
    with pytest.raises(RunFolderError, match=words):
        RunView.read(view.path)
    with pytest.raises(RunFolderError, match=words):
        quietly(run, out=view.path)
    assert content(view.path) == damaged


@pytest.mark.parametrize(
    ("old", "new"), [("seed: 5", "seed: 6"), ("  seed: 3", "  seed: 4")]
)
def test_an_edited_one_is_refused(run, old, new):
    view = quietly(run)
    file = view.path / "evaluation.yaml"
    assert old in file.read_text()
    file.write_text(file.read_text().replace(old, new, 1))
    with pytest.raises(RunFolderError, match="its settings were edited"):
        RunView.read(view.path)


def test_a_description_of_something_else_is_refused(run):
    view = quietly(run)
    file = view.path / "evaluation.yaml"
    content = yaml.safe_load(file.read_text())
    # A day, which YAML knows and JSON does not.
    for place, name in ((content, "evaluation"), (content["sha256"], "learner")):
        kept = place[name]
        place[name] = date(2002, 6, 12)
        file.write_text(yaml.safe_dump(content, sort_keys=False))
        with pytest.raises(RunFolderError, match=r"evaluation.yaml"):
            RunView.read(view.path)
        place[name] = kept


def test_tables_that_do_not_fit_together_are_refused(run):
    view = quietly(run)
    actions = view.actions.slice(0, view.actions.num_rows - 1)
    (view.path / "actions.parquet").write_bytes(parquet(actions, view.origin))
    with pytest.raises(RunFolderError, match="don't fit together"):
        RunView.read(view.path)


def test_a_table_of_another_evaluation_is_refused(run):
    view = quietly(run)
    other = quietly(run, EvaluationSettings(trials=2, seed=5), run.path / "other")
    (view.path / "actions.parquet").write_bytes(
        (other.path / "actions.parquet").read_bytes()
    )
    with pytest.raises(RunFolderError, match="from another run"):
        RunView.read(view.path)


def test_ties_are_broken_by_the_evaluations_seed(run, monkeypatch):
    plain = module.policy

    def indifferent(learner):
        greedy = plain(learner)
        greedy.weights[:] = 0
        return greedy

    monkeypatch.setattr(module, "policy", indifferent)
    one, same, other = (
        quietly(run, EvaluationSettings(trials=3, seed=seed), run.path / name)
        for seed, name in ((0, "a"), (0, "b"), (1, "c"))
    )
    assert one.actions.equals(same.actions)
    assert len(set(one.actions["action"].to_pylist())) == 6
    assert one.actions["action"].to_pylist() != other.actions["action"].to_pylist()
