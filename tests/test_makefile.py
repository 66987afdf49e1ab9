"""What the Makefile's targets hand over to the commands behind them."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent

pytestmark = pytest.mark.skipif(not shutil.which("make"), reason="make is not there")


@pytest.fixture
def make(tmp_path):
    """Run a target with a `prospect` that only says what it was told to do."""
    prospect = tmp_path / "bin" / "prospect"
    prospect.parent.mkdir()
    prospect.write_text('#!/bin/sh\nfor word in "$@"; do echo "$word"; done\n')
    prospect.chmod(0o755)
    for done in (".runtime-installed", ".gl-checked"):
        (tmp_path / done).touch()
    # What a make above this one was told is none of its business.
    environment = {k: v for k, v in os.environ.items() if not k.startswith("MAKE")}

    def run(*words):
        done = subprocess.run(
            ["make", f"VENV={tmp_path}", *words],
            cwd=ROOT,
            env=environment,
            capture_output=True,
            text=True,
            check=True,
        )
        return done.stdout.splitlines()

    return run


@pytest.mark.parametrize(
    ("words", "options"),
    [
        ("live", "--runs=20 --trials=1000"),
        ("live RUNS=5", "--runs=5 --trials=1000"),
        (
            "live RUNS=5 TRIALS=700 OUT=some/folder ARGS=--jobs=1",
            "--runs=5 --trials=700 --out=some/folder --jobs=1",
        ),
    ],
)
def test_live_runs_are_as_many_as_asked(make, words, options):
    assert make(*words.split()) == ["live-runs", *options.split()]


def test_other_targets_have_their_own_numbers(make):
    runs = ["reproduce", "--runs=1000", "--trials=1000"]
    assert make("reproduce") == runs
    assert make("reproduce", "OUT=a folder") == [*runs, "--out=a folder"]
    assert make("train", "TRIALS=20") == ["train", "--trials=20"]
    assert make("bench", "ARGS=--json") == ["bench", "--json"]
    assert make("doctor") == ["doctor"]
