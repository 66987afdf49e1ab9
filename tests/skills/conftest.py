"""One workbench for all tests of a process: every test begins with a reset."""

import importlib.util
from pathlib import Path

import pytest

from prospect_mj.skills import Workbench

EXAMPLE = Path(__file__).resolve().parents[2] / "examples" / "seventh_skill.py"


@pytest.fixture(scope="session")
def bench():
    with Workbench() as bench:
        yield bench


@pytest.fixture(scope="session")
def put_back():
    """The skill of the example, which is in no package."""
    spec = importlib.util.spec_from_file_location(EXAMPLE.stem, EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.put_back
