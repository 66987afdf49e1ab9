"""Compiled code is kept per state of its sources, where the user wants it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numba
import pytest

from prospect_mj.planning import kernel_cache

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
