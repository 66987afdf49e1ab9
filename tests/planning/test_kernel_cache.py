"""Compiled code is kept per state of its sources, where the user wants it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numba
import pytest
from arm_scene import ArmScene
from kept_kernels import kept_functions

from prospect_mj.planning import kernel_cache, occupancy
from prospect_mj.planning.goals import GoalSet
from prospect_mj.planning.planner import GrossPlanner, World
from prospect_mj.robot import posture

PACKAGE = Path(kernel_cache.__file__).parent
USE = """
import numba, sys
from prospect_mj.planning import streamline
print(numba.config.CACHE_DIR)
"""


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A copy of the package's sources that may be changed."""
    copy = tmp_path / "planning"
    shutil.copytree(PACKAGE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(kernel_cache, "__file__", str(copy / "kernel_cache.py"))
    return copy


@pytest.fixture
def chosen(tmp_path, monkeypatch):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "chosen"))
    monkeypatch.setattr(numba.config, "CACHE_DIR", numba.config.CACHE_DIR)
    return tmp_path / "chosen"


def folder():
    kernel_cache.use()
    return Path(numba.config.CACHE_DIR)


def test_any_change_of_any_source_leads_to_another_folder(package, chosen):
    seen = {folder()}
    names = sorted(path.name for path in PACKAGE.glob("*.py"))
    assert len(names) > 15
    for name in names:
        with (package / name).open("a") as file:
            file.write("# changed\n")
        seen.add(folder())
    assert len(seen) == len(names) + 1
    (package / "ascent.py").rename(package / "descent.py")
    seen.add(folder())
    assert len(seen) == len(names) + 2


def test_the_same_sources_lead_to_the_same_folder(package, chosen):
    first = folder()
    path = package / "ascent.py"
    os.utime(path, (0, 0))
    assert folder() == first
    text = path.read_text()
    path.write_text(text + "\n")
    path.write_text(text)
    assert folder() == first


def test_it_is_under_the_folder_that_the_user_chose(chosen):
    assert folder().parent == chosen
    assert folder().name.startswith("kernels-")


def test_otherwise_it_is_in_the_users_cache(monkeypatch, chosen, tmp_path):
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    users = tmp_path / "users"
    monkeypatch.setattr(kernel_cache.platformdirs, "user_cache_path", users.joinpath)
    assert folder().parent == users / "prospect_mj"


def test_whoever_imports_a_planner_uses_it(tmp_path):
    """In a new process: set before anything is compiled."""
    environment = os.environ | {"NUMBA_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(
        [sys.executable, "-c", USE], env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert Path(done.stdout.strip()).parent == tmp_path
    assert done.stdout.strip().endswith(kernel_cache.sources()[:16])


def test_what_is_cached_has_one_signature():
    """Two processes that compile at the same time could mix up two of them.

    The folder is that of the sources as they are: what any process has ever compiled of
    them is there.
    """
    scene = ArmScene()
    goal = GoalSet(lambda: posture.over_well("left")[None])
    planner = GrossPlanner(scene.model, "left")
    way = planner.plan(posture.home("left"), [goal], World(scene.data, scene.jars))
    assert way.field is not None
    functions = kept_functions(occupancy.free_cells)
    assert any("free_cells" in name for name in functions), functions
    assert len(functions) > 20
    assert sorted(set(functions)) == functions
