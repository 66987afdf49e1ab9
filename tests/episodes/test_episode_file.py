"""A watched trial, and what is left of it in a file."""

import json
from dataclasses import astuple, fields

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.episodes import episode_file
from prospect_mj.episodes.episode import QUANTITIES
from prospect_mj.episodes.recorder import WatchedTask
from prospect_mj.errors import EpisodeError
from prospect_mj.task.pick_place import PickPlaceTask, TaskSettings

pytestmark = pytest.mark.gl

ACTIONS = (Action.INSERT_LEFT, Action.GRASP_LEFT, Action.INSERT_LEFT)


@pytest.fixture(scope="module")
def watched():
    with WatchedTask(PickPlaceTask(TaskSettings(supervisor="safe"))) as task:
        task.reset("left", np.random.default_rng(3))
        outcomes = [task.execute(action) for action in ACTIONS]
        return task.episode(), outcomes


@pytest.fixture
def stored(watched, tmp_path):
    path = tmp_path / "trial.npz"
    episode_file.write(path, watched[0], "run")
    return path


def same(one, other):
    if isinstance(one, np.ndarray):
        np.testing.assert_array_equal(one, other)
        assert one.dtype == other.dtype
    elif hasattr(one, "__dataclass_fields__"):
        for field in fields(one):
            same(getattr(one, field.name), getattr(other, field.name))
    elif isinstance(one, tuple):
        assert len(one) == len(other)
        for a, b in zip(one, other, strict=True):
            same(a, b)
    else:
        assert one == other


def test_a_file_holds_all_of_an_episode(watched, stored):
    same(watched[0], episode_file.read(stored, "run"))
    assert stored.stat().st_size < 1_500_000


def test_an_episode_tells_what_was_done(watched):
    episode, outcomes = watched
    assert [span.outcome.action for span in episode.actions] == list(ACTIONS)
    for span, outcome in zip(episode.actions, outcomes, strict=True):
        assert astuple(span.outcome)[:4] == astuple(outcome)[:4]
        assert [c.name for c in span.controllers] == [r.name for r in outcome.runs]
        assert span.end - span.start == pytest.approx(outcome.sim_seconds)
    assert not episode.actions[0].controllers
    assert episode.inserted
    assert episode.seconds == pytest.approx(sum(o.sim_seconds for o in outcomes))


def test_signals_are_there_for_every_control_period(watched):
    episode, _ = watched
    times = episode.signals.times
    np.testing.assert_allclose(np.diff(times), CONTROL_PERIOD)
    residual = episode.signals.measured[:, 0, QUANTITIES.index("residual")]
    assert 0 < np.nanmin(residual) < 0.02


def test_states_go_from_the_start_to_the_end(watched):
    episode, _ = watched
    times = episode.states.times
    assert (np.diff(times) > 0).all()
    assert np.diff(times).max() <= 2 * CONTROL_PERIOD + 1e-9
    assert times[0] == episode.actions[0].start
    assert times[-1] == episode.actions[-1].end


def test_paths_were_followed_during_their_action(watched):
    episode, _ = watched
    grasp = episode.actions[1]
    assert grasp.paths
    for path in grasp.paths:
        assert grasp.start <= path.start < path.end <= grasp.end + 1e-9


DAMAGED = {
    "empty": lambda whole: b"",
    "cut off": lambda whole: whole[: len(whole) // 2],
    "zeros": lambda whole: b"\0" * len(whole),
    "one bit": lambda whole: whole[:5000] + bytes([whole[5000] ^ 1]) + whole[5001:],
    "text": lambda whole: b"notes",
    "one array": lambda whole: b"\x93NUMPY" + whole[6:],
}


@pytest.mark.parametrize("damage", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_file_is_said_to_be_in_words_of_our_own(stored, damage):
    """NumPy's would tell the user to load it unsafely."""
    stored.write_bytes(damage(stored.read_bytes()))
    with pytest.raises(EpisodeError) as refused:
        episode_file.read(stored)
    expected = f"{stored} can't be read as an episode: it is damaged, or none"
    assert str(refused.value) == expected


def test_an_array_by_itself_is_no_episode(tmp_path):
    path = tmp_path / "array.npz"
    with path.open("wb") as file:
        np.save(file, np.zeros(3))
    with pytest.raises(EpisodeError, match="it is damaged, or none"):
        episode_file.read(path)


@pytest.mark.parametrize(
    ("name", "array", "words"),
    [
        ("states", np.zeros(3), r"its states are float64 of shape \(3,\)"),
        ("state_times", np.zeros(2), "its state times don't fit"),
    ],
)
def test_what_does_not_fit_is_named(stored, name, array, words):
    with np.load(stored) as there:
        arrays = dict(there)
    np.savez(stored, **{**arrays, name: array})
    with pytest.raises(EpisodeError, match=f"can't be read as an episode: {words}"):
        episode_file.read(stored)


def test_a_file_that_is_not_there_or_of_another_run_is_refused(stored, tmp_path):
    with pytest.raises(EpisodeError, match="there is no episode"):
        episode_file.read(tmp_path / "none.npz")
    with pytest.raises(EpisodeError, match="from another run"):
        episode_file.read(stored, "another")
    np.savez(tmp_path / "foreign.npz", description=np.frombuffer(b"[1]", np.uint8))
    with pytest.raises(EpisodeError, match="is not an episode"):
        episode_file.read(tmp_path / "foreign.npz")


def test_a_file_of_another_format_is_refused_with_both(tmp_path):
    told = np.frombuffer(b'{"format": 2}', np.uint8)
    np.savez(tmp_path / "later.npz", description=told)
    words = "later.npz has format 2; this version reads format 1"
    with pytest.raises(EpisodeError, match=words):
        episode_file.read(tmp_path / "later.npz")


@pytest.mark.parametrize("end", ["start", "end"])
@pytest.mark.parametrize("moment", [None, "soon"])
def test_an_action_without_a_time_is_damage(stored, end, moment):
    with np.load(stored) as arrays:
        whole = dict(arrays)
    told = json.loads(bytes(whole["description"]))
    told["actions"][0][end] = moment
    whole["description"] = np.frombuffer(json.dumps(told).encode(), np.uint8)
    np.savez(stored, **whole)
    with pytest.raises(EpisodeError, match="can't be read as an episode"):
        episode_file.read(stored)
