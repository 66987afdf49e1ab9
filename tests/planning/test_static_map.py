"""The static part is computed once, found again, and never taken from a wrong file."""

import os
from dataclasses import replace

import numpy as np
import pytest
from arm_scene import ArmScene

from prospect_mj.planning import kernel_cache, static_map
from prospect_mj.planning.arm_body import arm_body
from prospect_mj.planning.joint_grid import JointGrid
from prospect_mj.planning.static_map import static_room
from prospect_mj.planning.surroundings import Surroundings

MARGIN = 0.02
"""[m]"""


@pytest.fixture(scope="module")
def scene():
    return ArmScene()


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The user's cache, empty."""
    monkeypatch.setattr(static_map.platformdirs, "user_cache_path", tmp_path.joinpath)
    return tmp_path


@pytest.fixture
def computed(monkeypatch):
    """Arguments of every computation from now on."""
    calls, compute = [], static_map.room_among

    def spy(*arguments):
        calls.append(arguments)
        return compute(*arguments)

    monkeypatch.setattr(static_map, "room_among", spy)
    return calls


def question(scene, side="left", cells=(3, 4, 3, 5)):
    body = arm_body(scene.model, side)
    low, high = body.limits[:4].T
    grid = JointGrid(tuple(low), tuple(high), cells)
    return body, Surroundings(scene.model, side).fixed, grid, MARGIN


def files(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


def test_it_is_computed_once_and_then_read(scene, folder, computed):
    first = static_room(*question(scene))
    again = static_room(*question(scene))
    assert len(computed) == 1
    assert np.array_equal(first, again)
    assert first.dtype == again.dtype == np.float32
    assert first.shape == again.shape == (3 * 4 * 3, 5)
    assert len(files(folder)) == 1


def other_bodies(body):
    arrays = body.arrays
    for name in arrays._fields:
        content = getattr(arrays, name)
        if content.size:
            moved = content + 1e-6
            yield replace(body, arrays=arrays._replace(**{name: moved}))


def test_another_arm_world_grid_or_margin_is_another_question(scene, folder, computed):
    body, fixed, grid, margin = asked = question(scene)
    static_room(*asked)
    finer = JointGrid(grid.low, grid.high, (3, 4, 3, 6))
    turned = JointGrid(grid.low, grid.high, (4, 3, 3, 5))
    wider = JointGrid((grid.low[0] - 0.1, *grid.low[1:]), grid.high, grid.cells)
    others = [
        question(scene, "right"),
        (body, fixed + 1e-6, grid, margin),
        (body, fixed[:-1], grid, margin),
        (body, fixed, finer, margin),
        (body, fixed, turned, margin),
        (body, fixed, wider, margin),
        (body, fixed, grid, margin + 1e-6),
        *((each, fixed, grid, margin) for each in other_bodies(body)),
    ]
    for n, other in enumerate(others, start=2):
        static_room(*other)
        assert len(computed) == n
    static_room(*asked)
    assert len(computed) == len(others) + 1 == len(files(folder))


def test_other_code_is_another_question(scene, folder, computed, monkeypatch):
    static_room(*question(scene))
    monkeypatch.setattr(kernel_cache, "sources", lambda: "changed")
    static_room(*question(scene))
    assert len(computed) == 2


@pytest.mark.parametrize("compiler", [static_map.numba, static_map.np])
def test_another_compiler_is_another_question(
    compiler, scene, folder, computed, monkeypatch
):
    static_room(*question(scene))
    monkeypatch.setattr(compiler, "__version__", "0.0.1")
    static_room(*question(scene))
    assert len(computed) == 2


DAMAGES = {
    "empty": lambda whole: b"",
    "cut off": lambda whole: whole[: len(whole) // 2],
    "cut off in its header": lambda whole: whole[:40],
    "no array": lambda whole: b"\x00" * len(whole),
    "a broken header": lambda whole: whole[:11] + b"(((((((" + whole[18:],
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_a_damaged_file_is_made_again(scene, folder, computed, damage):
    right = static_room(*question(scene))
    (path,) = files(folder)
    whole = path.read_bytes()
    path.write_bytes(damage(whole))
    assert np.array_equal(static_room(*question(scene)), right)
    assert len(computed) == 2
    assert files(folder) == [path]
    assert path.read_bytes() == whole


@pytest.mark.parametrize(
    "wrong", [np.zeros(3, np.float32), np.zeros((36, 5)), np.zeros((36, 5), object)]
)
def test_a_file_of_something_else_is_made_again(scene, folder, computed, wrong):
    right = static_room(*question(scene))
    np.save(files(folder)[0], wrong, allow_pickle=True)
    assert np.array_equal(static_room(*question(scene)), right)
    assert len(computed) == 2


def test_without_a_writable_folder_it_is_computed_each_time(
    scene, folder, computed, monkeypatch
):
    (folder / "file").write_text("where a folder should be")
    monkeypatch.setattr(static_map, "_folder", lambda: folder / "file" / "maps")
    first = static_room(*question(scene))
    assert np.array_equal(first, static_room(*question(scene)))
    assert len(computed) == 2


def test_where_writing_fails_half_way_nothing_is_left(
    scene, folder, computed, monkeypatch
):
    def full(file, array):
        file.write(b"half")
        raise OSError("no space left on device")

    monkeypatch.setattr(static_map.np, "save", full)
    static_room(*question(scene))
    assert len(computed) == 1
    assert files(folder) == []


def test_a_file_is_never_seen_half_written(scene, folder, monkeypatch):
    """It gets its name when it is whole."""
    seen, replaced = [], static_map.Path.replace

    def spy(self, target):
        seen.append((os.fspath(self), np.load(self).shape, target.exists()))
        return replaced(self, target)

    monkeypatch.setattr(static_map.Path, "replace", spy)
    static_room(*question(scene))
    ((name, shape, existed),) = seen
    assert name.endswith(".tmp")
    assert shape == (36, 5)
    assert not existed
