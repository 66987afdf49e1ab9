"""The key: what decides an outcome, and what has changed, in words."""

from dataclasses import asdict, replace
from datetime import date

import pytest
import yaml
from ideal_grower import key

from prospect_mj.errors import RecordingError
from prospect_mj.recording.key import NAME, RecordingKey

KEY = key()
CHANGED = {
    "it was made with seed 0, not 5": key(seed=5),
    "it was made with object pose vision, not truth": key(object_pose="truth"),
    "it was made with gross motion harmonic, not cartesian": key(
        gross_motion="cartesian"
    ),
    "it was made with grid cells 16, not 8": key(grid_cells=8),
    "it was made with world standard, not post": key(world="post"),
    "world changed since": replace(KEY, sha256={**KEY.sha256, "world": "ab"}),
    "it was made with mujoco 3.17.0, not 3.18.0": replace(
        KEY, versions={**KEY.versions, "mujoco": "3.18.0"}
    ),
    "it was made with mujoco 3.17.0, not None": replace(
        KEY, versions={"numpy": "2.4.6"}
    ),
    "sources changed since": replace(KEY, sha256={**KEY.sha256, "sources": "ef"}),
    "models/torso.xml changed since": replace(
        KEY, sha256={"sources": "cd", "world": "ef"}
    ),
}


@pytest.mark.parametrize(("words", "other"), CHANGED.items(), ids=CHANGED.keys())
def test_every_difference_is_told_and_makes_another_digest(words, other):
    assert KEY.differences(other) == [words]
    assert KEY.digest != other.digest


def test_the_machine_is_told_but_decides_nothing():
    elsewhere = replace(KEY, machine={"system": "Plan 9"})
    assert KEY.differences(elsewhere) == []
    assert KEY.digest == elsewhere.digest
    assert "Plan 9" in elsewhere.as_yaml().decode()


def test_straight_movements_need_no_grid():
    """So its cells are no difference; of the harmonic ones they are."""
    straight = key(gross_motion="cartesian")
    assert straight.differences(key(gross_motion="cartesian", grid_cells=8)) == []
    words = straight.differences(key(grid_cells=8))
    assert words == [
        "it was made with gross motion cartesian, not harmonic",
        "it was made with grid cells 16, not 8",
    ]


def test_the_order_of_a_file_decides_nothing():
    turned = replace(KEY, versions=dict(reversed(KEY.versions.items())))
    assert KEY.digest == turned.digest


@pytest.mark.parametrize("kept", [KEY, *CHANGED.values()])
def test_a_key_comes_back_from_its_file(kept, tmp_path):
    (tmp_path / NAME).write_bytes(kept.as_yaml())
    back = RecordingKey.read(tmp_path)
    assert back == kept
    assert back.digest == kept.digest


EDITED = KEY.as_yaml().decode()


def edited(**changes):
    return yaml.safe_dump({**yaml.safe_load(KEY.as_yaml()), **changes})


DAMAGED = {
    "empty": ("", "is not the key of a recording"),
    "cut": (KEY.as_yaml().decode()[:60], "damaged"),
    "no YAML": ("{", "damaged"),
    "binary": (b"\xff\xfe\x00".decode("latin-1"), "damaged"),
    "a list": ("- 1\n- 2\n", "is not the key of a recording"),
    "a later format": (edited(prospect_mj_recording=2), "has format 2; this version"),
    "no format": (edited(prospect_mj_recording=True), "is not the key of a recording"),
    "a day": (edited(versions={"mujoco": date(2026, 11, 6)}), "an entry of versions"),
    "a number": (edited(versions={1: "x", "mujoco": "3"}), "an entry of versions"),
    "a digest by number": (edited(sha256={"sources": 7}), "an entry of sha256"),
    "no such day": (EDITED.replace("3.17.0", "2024-99-99"), "it is damaged"),
    "deep": ("[" * 5000, "it is damaged"),
    "absurd seed": (edited(config={**asdict(KEY.config), "seed": -1}), "seed is -1"),
    "unknown world": (
        edited(config={**asdict(KEY.config), "world": "moon"}),
        "world is 'moon'; valid: standard, post",
    ),
    "unknown setting": (edited(config={"seed": 1, "speed": 2}), "speed"),
    "no settings": (edited(config=None), "damaged"),
    "no digests": (edited(sha256="abc"), "damaged"),
    "no versions": (edited(versions=None), "damaged"),
}


@pytest.mark.parametrize(("text", "words"), DAMAGED.values(), ids=DAMAGED.keys())
def test_a_damaged_key_is_one_clear_line(text, words, tmp_path):
    (tmp_path / NAME).write_text(text, "latin-1")
    with pytest.raises(RecordingError, match=words) as refused:
        RecordingKey.read(tmp_path)
    assert str(tmp_path / NAME) in str(refused.value)


def test_a_key_that_may_not_be_read_is_not_called_damaged(tmp_path, monkeypatch):
    (tmp_path / NAME).write_bytes(KEY.as_yaml())

    def refuse(path, *args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.read_text", refuse)
    with pytest.raises(RecordingError, match="can't be read: Permission denied"):
        RecordingKey.read(tmp_path)


def test_a_folder_without_a_key_is_no_recording(tmp_path):
    with pytest.raises(RecordingError, match=r"is not a recording: it has no"):
        RecordingKey.read(tmp_path)
