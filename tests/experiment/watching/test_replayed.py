"""Trials of a run as they were, whether they were kept or not."""

from contextlib import closing
from dataclasses import replace

import numpy as np
import pytest

from prospect_mj.episodes import episode_file
from prospect_mj.errors import (
    EpisodeError,
    InvalidValue,
    RunFolderError,
    SimulationDiverged,
)
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.experiment.run.kept_episodes import Kept, kept_trials, path_of
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.experiment.watching import replayed
from prospect_mj.experiment.watching.presented_again import (
    drawn_presentation,
    present_again,
)
from prospect_mj.experiment.watching.replayed import Choice, chosen
from prospect_mj.recording import files
from prospect_mj.recording.recording import Recording
from prospect_mj.task.pick_place import PickPlaceTask

pytestmark = pytest.mark.gl

LIVE = TrainConfig(trials=2, seed=1, max_actions=4)
FILES = ("actions.parquet", "trials.parquet", "weights.npz", "config.yaml")


def quiet(words):
    pass


def trained(folder, config, kept=None):
    session.start(config, folder, say=quiet, kept=kept)
    return folder


@pytest.fixture(scope="module")
def live(tmp_path_factory):
    """A run of live physics that kept all of its trials, and the same without."""
    folder = tmp_path_factory.mktemp("live")
    kept = trained(folder / "kept", LIVE, Kept.parse("all"))
    return kept, trained(folder / "bare", LIVE)


@pytest.fixture(scope="module")
def grown(tmp_path_factory):
    """A run of recorded physics, whose recording grew with it."""
    folder = tmp_path_factory.mktemp("recorded")
    recording = str(folder / "recording")
    config = replace(LIVE, physics="recorded", grow=True, recording=recording)
    return trained(folder / "run", config)


def the_only(path, choice=None):
    (fetch,) = replayed.of(path, choice or Choice(), quiet).values()
    return fetch()


def states(replayed):
    return replayed.episode.states.rows


def test_a_recorded_run_is_bit_identical_to_one_that_was_not(live):
    kept, bare = live
    for name in FILES:
        assert (kept / name).read_bytes() == (bare / name).read_bytes(), name
    assert kept_trials(kept) == [0, 1]
    assert kept_trials(bare) == []


@pytest.mark.parametrize("trial", range(LIVE.trials))
def test_a_trial_that_was_not_kept_is_simulated_bit_identically(trial, live):
    kept, bare = (the_only(run, Choice(trial)) for run in live)
    np.testing.assert_array_equal(states(kept), states(bare))
    measured = [one.episode.signals.measured for one in (kept, bare)]
    np.testing.assert_array_equal(*measured)
    run = RunView.read(live[0])
    assert len(kept.episode.actions) == run.actions_of(trial).num_rows


def test_a_trial_of_recorded_physics_is_simulated_as_it_was_recorded(grown):
    run = RunView.read(grown)
    for trial in range(run.n_trials):
        one = the_only(grown, Choice(trial))
        rows = run.actions_of(trial).to_pylist()
        assert [s.name for s in one.episode.actions] == [r["action_name"] for r in rows]
        assert one.episode.inserted == rows[-1]["inserted"]
        assert one.story.q_values.tolist() == [r["q_values"] for r in rows]


@pytest.mark.filterwarnings("ignore:the recording may differ")
def test_the_presentation_is_the_one_that_the_environment_drew():
    # The recording that comes with the package, of today's physics or not.
    config = TrainConfig(trials=4, seed=3, physics="recorded")
    with closing(make_environment(config)) as env:
        recording = env.task.recording.presentations
        run = RunView(None, config, None, None, None, None)
        for trial in range(20):
            options = {"orientation": "right", "trial": trial}
            env.reset(seed=run.presentation_seed(trial), options=options)
            drawn = np.flatnonzero(recording.root == env.task.node)
            number = drawn_presentation(run, trial, "right")
            assert recording.number[drawn].tolist() == [number]


def test_physics_that_changed_since_are_noticed(live, grown, monkeypatch):
    for run in (live[1], grown):
        view = RunView.read(run)
        column = view.actions.schema.get_field_index("sim_seconds")
        later = [seconds + 0.02 for seconds in view.actions["sim_seconds"].to_pylist()]
        actions = view.actions.set_column(column, "sim_seconds", [later])
        changed = replace(view, actions=actions)
        with pytest.raises(
            RunFolderError, match=r"can't be simulated again: its action"
        ):
            replayed.replayed(changed, 0, quiet)


def test_a_recording_that_offers_more_presentations_is_told_of(grown):
    view = RunView.read(grown)
    folder = view.config.recording_folder
    added = folder / files.tree_file("left", 70)
    (first, *_) = files.tree_files(folder)
    added.write_bytes(first.read_bytes())
    with pytest.raises(RunFolderError, match="changed since: number of presentations"):
        replayed.replayed(view, 0, quiet)
    added.unlink()


@pytest.mark.filterwarnings("ignore:the recording may differ")
def test_a_recording_is_read_once_for_all_trials(monkeypatch):
    config = TrainConfig(trials=4, seed=3, physics="recorded")
    run, loaded = RunView(None, config, None, None, None, None), []
    load = Recording.load
    monkeypatch.setattr(
        Recording, "load", lambda *path: loaded.append(path) or load(*path)
    )
    drawn = [drawn_presentation(run, trial, "right") for trial in range(10)]
    assert len(loaded) == 1
    assert len(set(drawn)) > 1


def test_what_can_not_be_presented_again_is_closed(live, grown, monkeypatch):
    closed = []
    close = PickPlaceTask.close

    def fail(*_):
        raise SimulationDiverged("bad acceleration")

    monkeypatch.setattr(PickPlaceTask, "reset", fail)
    monkeypatch.setattr(
        PickPlaceTask, "close", lambda task: closed.append(task) or close(task)
    )
    for number, run in enumerate((live[0], grown), start=1):
        with pytest.raises(SimulationDiverged):
            present_again(RunView.read(run), 0, "left")
        assert len(closed) == number


def test_trials_are_chosen(live):
    view = RunView.read(live[0])
    assert chosen(view, Choice()) == [1]
    assert chosen(view, Choice(trial=0)) == [0]
    counts = view.trials["n_actions"].to_pylist()
    assert [counts[n] for n in chosen(view, Choice(worst=True))] == [max(counts)]
    for number in (-1, 2):
        with pytest.raises(InvalidValue, match="0 to 1, as far as the run has come"):
            chosen(view, Choice(trial=number))
    several = "is '--trial 0 --worst'; expected one of --trial, --worst, --failures"
    with pytest.raises(InvalidValue, match=several):
        Choice(trial=0, worst=True)


def test_failures_are_those_that_were_kept_or_the_last_ones(live):
    def solved(view, values):
        column = view.trials.schema.get_field_index("solved")
        return replace(view, trials=view.trials.set_column(column, "solved", [values]))

    view, bare = (RunView.read(run) for run in live)
    failures = Choice(failures=True)
    assert chosen(solved(view, [False, True]), failures) == [0]
    assert chosen(solved(bare, [False, False]), failures) == [0, 1]
    with pytest.raises(RunFolderError, match="all of its 2 trials are solved"):
        chosen(solved(view, [True, True]), failures)


def test_an_episode_can_be_replayed_by_itself(live, tmp_path):
    path = path_of(live[0], 0)
    one = the_only(path)
    np.testing.assert_array_equal(states(one), states(the_only(live[0], Choice(0))))
    assert one.story.title == "trial-000000"
    assert one.story.q_values is None
    refused = "is '--trial 0'; expected none beside the file of one episode"
    with pytest.raises(InvalidValue, match=refused):
        the_only(path, Choice(trial=0))
    with pytest.raises(EpisodeError, match="there is no episode"):
        the_only(tmp_path / "none.npz")


def test_a_damaged_episode_is_named_with_what_to_do(live, tmp_path):
    view = RunView.read(live[1])
    path = path_of(live[1], 0)
    path.parent.mkdir()
    for content in (b"", path_of(live[0], 0).read_bytes()[:5000]):
        path.write_bytes(content)
        with pytest.raises(EpisodeError, match="remove it, and the trial is simulated"):
            replayed.replayed(view, 0, quiet)
    episode = episode_file.read(path_of(live[0], 0))
    episode_file.write(path, episode, "another run")
    with pytest.raises(EpisodeError, match="is from another run"):
        replayed.replayed(view, 0, quiet)
    path.unlink()


def row(action, inserted=False, executed=True):
    return {"action": action, "executed": executed, "inserted": inserted}


@pytest.mark.parametrize(
    ("actions", "words"),
    [
        ([row(0), row(4, inserted=True)], "optimal"),
        ([row(5, executed=False), row(0), row(4, inserted=True)], "optimal"),
        ([row(1), row(3), row(4, inserted=True)], "early correction"),
        ([row(1), row(5), row(3), row(4, inserted=True)], "late correction"),
        ([row(0), row(2), row(3), row(4, inserted=True)], "solved in another way"),
        ([row(1), row(5)], "not solved"),
    ],
)
def test_a_strategy_is_told_in_words(actions, words):
    trial = {"orientation": "left", "solved": actions[-1]["inserted"]}
    assert replayed.strategy(trial, actions) == words


def test_a_title_has_run_trial_and_strategy(live):
    title = the_only(live[0], Choice(0)).story.title
    assert title.startswith("kept, trial 0: ")
