import json

import numpy as np
import pytest
from told import random_steps

from prospect_mj.agent import (
    LinearSettings,
    ReplaySettings,
    TableSettings,
    checkpoint,
    new_learner,
)
from prospect_mj.agent.learners import NAMES, SETTINGS, settings_of
from prospect_mj.errors import InvalidChoice, InvalidValue, UnfitCheckpoint
from prospect_mj.storage import replace_file

ALL = (
    LinearSettings(step_size=0.01, epsilon=0.2),
    ReplaySettings(buffer=20, replays=3),
    TableSettings(copied_habit=True, known_correction=True),
    TableSettings(buffer=20, replays=3),
    SETTINGS["discovery"](),
)


def learned(settings):
    learner = new_learner(settings, np.random.default_rng(9))
    go_on(learner, 30, seed=1)
    return learner


def go_on(learner, n, seed):
    """Learn from made-up transitions, and give the choices made on the way."""
    choosing, learning = (np.random.default_rng([seed, k]) for k in range(2))
    chosen = []
    for step in random_steps(n, seed):
        chosen.append(learner.select(step.observation, choosing).action)
        learner.update(step, learning)
    return chosen


def saved(folder, settings=ALL[0]):
    path = folder / "weights.npz"
    checkpoint.write(path, learned(settings), "a run")
    return path


@pytest.mark.parametrize("settings", ALL, ids=lambda s: s.name)
def test_read_and_continue_is_bit_equal_to_never_stopping(settings, tmp_path):
    stored, never_stopped = (
        checkpoint.read(saved(tmp_path, settings)),
        learned(settings),
    )
    chosen = [go_on(one, 40, seed=2) for one in (stored.learner, never_stopped)]
    assert chosen[0] == chosen[1]
    assert (stored.learner.settings, stored.origin) == (settings, "a run")
    assert stored.learner.n_updates == 70
    states = [one.state() for one in (stored.learner, never_stopped)]
    assert states[0].keys() == states[1].keys()
    for name, array in states[0].items():
        assert array.tobytes() == states[1][name].tobytes(), name


@pytest.mark.parametrize("settings", ALL, ids=lambda s: s.name)
def test_equal_learners_give_equal_bytes(settings, tmp_path):
    path = saved(tmp_path, settings)
    checkpoint.write(path.with_name("again"), checkpoint.read(path).learner, "a run")
    assert path.with_name("again").read_bytes() == path.read_bytes()


@pytest.mark.parametrize("name", NAMES)
def test_another_learner_is_refused_in_one_line(name, tmp_path):
    path = saved(tmp_path, SETTINGS[name]())
    assert checkpoint.read(path, name).learner.settings.name == name
    wanted = next(other for other in NAMES if other != name)
    with pytest.raises(UnfitCheckpoint) as refused:
        checkpoint.read(path, wanted)
    assert str(refused.value) == f"{path} holds a {name} learner, not {wanted}"


def test_path_may_be_a_string_and_is_taken_as_it_is(tmp_path):
    checkpoint.write(str(tmp_path / "no_suffix"), new_learner(ALL[0]))
    assert checkpoint.read(str(tmp_path / "no_suffix")).learner.n_updates == 0
    assert [file.name for file in tmp_path.iterdir()] == ["no_suffix"]


def rewrite(path, **changes):
    with np.load(path) as archive:
        arrays = dict(archive)
    arrays.update(changes)
    kept = {name: array for name, array in arrays.items() if array is not None}
    np.savez(path, **kept)


@pytest.mark.parametrize(
    "changes",
    [
        {"format": None},
        {"format": np.array("something else")},
        {"settings": np.array("{")},
        {"settings": np.array('{"alpha": 1}')},
        {"settings": np.array('{"name": "linear", "epsilon": 7}')},
        {"settings": np.array('{"name": "clever"}')},
        {"settings": np.array("[]")},
        {"state.weights": None},
        {"state.weights": np.zeros((6, 302))},
        {"state.weights": np.zeros((6, 303), dtype=np.float32)},
        {"state.weights": np.full((6, 303), np.nan)},
        {"state.weights": np.array([{"an": "object"}])},
        {"state.n_updates": np.array([1, 2])},
        {"state.values": np.zeros(3)},
        {"origin": None},
    ],
)
@pytest.mark.parametrize("wanted", [None, "linear"])
def test_foreign_archive_is_refused(changes, wanted, tmp_path):
    rewrite(saved(tmp_path), **changes)
    with pytest.raises(InvalidValue, match=r"weights\.npz"):
        checkpoint.read(tmp_path / "weights.npz", wanted)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"format": np.array("prospect_mj learner 9")}, "has format 'prospect_mj lear"),
        ({"state.weights": np.full((6, 303), np.nan)}, "has no sound learner: weights"),
    ],
)
def test_learners_of_no_use_say_why(changes, words, tmp_path):
    rewrite(saved(tmp_path), **changes)
    with pytest.raises(UnfitCheckpoint, match=rf"weights\.npz {words}"):
        checkpoint.read(tmp_path / "weights.npz")


@pytest.mark.parametrize(
    "changes",
    [
        {"experience_count": np.array(-1)},
        {"experience_count": np.array(19)},
        {"experience_reward": np.full(20, np.nan)},
        {"experience_state": np.zeros((20, 303), np.int64)},
        {"experience_state": None},
    ],
)
def test_unsound_experience_is_refused(changes, tmp_path):
    path = saved(tmp_path, ALL[1])
    rewrite(path, **{f"state.{name}": array for name, array in changes.items()})
    with pytest.raises(UnfitCheckpoint, match=r"no sound learner: .*experience_"):
        checkpoint.read(path)


@pytest.mark.parametrize("content", [b"", b"text", b"PK\x03\x04 not really"])
def test_other_file_is_refused(tmp_path, content):
    path = tmp_path / "weights.npz"
    path.write_bytes(content)
    with pytest.raises(InvalidValue, match=r"weights\.npz"):
        checkpoint.read(path)


def test_lone_array_is_refused(tmp_path):
    np.save(tmp_path / "weights.npy", np.zeros((6, 303)))
    with pytest.raises(InvalidValue, match=r"weights\.npy"):
        checkpoint.read(tmp_path / "weights.npy")


def test_truncated_and_flipped_files_are_refused(tmp_path):
    path = saved(tmp_path)
    whole = path.read_bytes()
    for damaged in (
        whole[:-100],
        whole[: len(whole) // 2],
        whole[:5000] + bytes([whole[5000] ^ 255]) + whole[5001:],
    ):
        path.write_bytes(damaged)
        with pytest.raises(InvalidValue):
            checkpoint.read(path)


def test_missing_file_is_refused(tmp_path):
    with pytest.raises(InvalidValue, match="nowhere"):
        checkpoint.read(tmp_path / "nowhere.npz")


@pytest.mark.parametrize("name", ["nowhere/weights.npz", "."])
def test_path_that_no_file_can_have_is_refused(tmp_path, name):
    path = tmp_path / name
    with pytest.raises(InvalidValue) as refused:
        checkpoint.write(path, new_learner(ALL[0]))
    assert repr(str(path)) in str(refused.value)
    assert not list(tmp_path.iterdir())


def test_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "file"
    replace_file(path, b"old")
    monkeypatch.setattr("os.fsync", lambda _: (_ for _ in ()).throw(OSError("full")))
    with pytest.raises(OSError, match="full"):
        replace_file(path, b"new")
    assert [file.read_bytes() for file in tmp_path.iterdir()] == [b"old"]


@pytest.mark.parametrize("settings", ALL, ids=lambda s: s.name)
def test_settings_come_back_from_json(settings):
    plain = json.loads(json.dumps({**vars(settings)}))
    assert settings_of(plain) == settings


@pytest.mark.parametrize("plain", [{}, {"name": "clever"}, {"name": "table", "a": 1}])
def test_unknown_learners_and_settings_are_refused(plain):
    with pytest.raises(InvalidChoice):
        settings_of(plain)
