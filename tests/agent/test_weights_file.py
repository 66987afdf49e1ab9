import numpy as np
import pytest

from prospect_mj.agent import LearnerSettings, LinearQ
from prospect_mj.errors import InvalidValue, UnfitWeights
from prospect_mj.storage import replace_file

SETTINGS = LearnerSettings(step_size=0.01, epsilon=0.2)


def learn(learner, n, seed):
    rng = np.random.default_rng(seed)
    for _ in range(n):
        phi, next_phi = rng.random((2, 303))
        action = learner.select(phi, rng)
        learner.update(phi, action, -1.0, next_phi, rng.random() < 0.2)


@pytest.fixture
def saved(tmp_path):
    learner, path = LinearQ(SETTINGS, "a run"), tmp_path / "weights.npz"
    learn(learner, 30, seed=1)
    learner.save(path)
    return path


def test_load_and_continue_is_bit_equal_to_never_stopping(saved):
    loaded, never_stopped = LinearQ.load(saved), LinearQ(SETTINGS)
    learn(never_stopped, 30, seed=1)
    for learner in (loaded, never_stopped):
        learn(learner, 30, seed=2)
    assert loaded.settings == SETTINGS
    assert loaded.n_updates == 60
    assert loaded.origin == "a run"
    assert loaded.weights.tobytes() == never_stopped.weights.tobytes()


def test_equal_learners_give_equal_bytes(saved):
    again = saved.with_name("again.npz")
    LinearQ.load(saved).save(again)
    assert again.read_bytes() == saved.read_bytes()


def test_path_may_be_a_string_and_is_taken_as_it_is(tmp_path):
    LinearQ().save(str(tmp_path / "no_suffix"))
    assert LinearQ.load(str(tmp_path / "no_suffix")).n_updates == 0
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
        {"settings": np.array('{"epsilon": 7}')},
        {"weights": None},
        {"weights": np.zeros((6, 302))},
        {"weights": np.zeros((6, 303), dtype=np.float32)},
        {"weights": np.full((6, 303), np.nan)},
        {"weights": np.array([{"an": "object"}])},
        {"n_updates": np.array([1, 2])},
        {"origin": None},
    ],
)
def test_foreign_archive_is_refused(saved, changes):
    rewrite(saved, **changes)
    with pytest.raises(InvalidValue, match=r"weights\.npz"):
        LinearQ.load(saved)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"format": np.array("prospect_mj linear Q 9")}, "format 'prospect_mj linear"),
        ({"weights": np.full((6, 303), np.nan)}, "weights that are not finite"),
    ],
)
def test_weights_of_no_use_say_why(saved, changes, words):
    rewrite(saved, **changes)
    with pytest.raises(UnfitWeights, match=rf"weights\.npz has {words}"):
        LinearQ.load(saved)


@pytest.mark.parametrize("content", [b"", b"text", b"PK\x03\x04 not really"])
def test_other_file_is_refused(tmp_path, content):
    path = tmp_path / "weights.npz"
    path.write_bytes(content)
    with pytest.raises(InvalidValue, match=r"weights\.npz"):
        LinearQ.load(path)


def test_lone_array_is_refused(tmp_path):
    np.save(tmp_path / "weights.npy", np.zeros((6, 303)))
    with pytest.raises(InvalidValue, match=r"weights\.npy"):
        LinearQ.load(tmp_path / "weights.npy")


def test_truncated_and_flipped_files_are_refused(saved):
    whole = saved.read_bytes()
    for damaged in (
        whole[:-100],
        whole[: len(whole) // 2],
        whole[:5000] + bytes([whole[5000] ^ 255]) + whole[5001:],
    ):
        saved.write_bytes(damaged)
        with pytest.raises(InvalidValue):
            LinearQ.load(saved)


def test_missing_file_is_refused(tmp_path):
    with pytest.raises(InvalidValue, match="nowhere"):
        LinearQ.load(tmp_path / "nowhere.npz")


@pytest.mark.parametrize("name", ["nowhere/weights.npz", "."])
def test_path_that_no_file_can_have_is_refused(tmp_path, name):
    path = tmp_path / name
    with pytest.raises(InvalidValue) as refused:
        LinearQ().save(path)
    assert repr(str(path)) in str(refused.value)
    assert not list(tmp_path.iterdir())


def test_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "file"
    replace_file(path, b"old")
    monkeypatch.setattr("os.fsync", lambda _: (_ for _ in ()).throw(OSError("full")))
    with pytest.raises(OSError, match="full"):
        replace_file(path, b"new")
    assert [file.read_bytes() for file in tmp_path.iterdir()] == [b"old"]
