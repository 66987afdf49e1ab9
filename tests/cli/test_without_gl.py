"""Where nothing can be rendered every script says so in one line and writes nothing."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[2] / "scripts"


@pytest.mark.parametrize(
    "command",
    [
        ("train.py", "--trials", "1", "--out", "run"),
        ("bench.py",),
        ("record.py", "--out", "run"),
        ("skill_study.py",),
        ("view.py", "--video", "film.mp4"),
    ],
    ids=lambda command: command[0],
)
def test_one_line_and_nothing_written(command, tmp_path):
    script, *options = command
    blind = {"MUJOCO_GL": "egl", "__EGL_VENDOR_LIBRARY_DIRS": "/nonexistent"}
    done = subprocess.run(
        [sys.executable, str(SCRIPTS / script), *options],
        cwd=tmp_path,
        env=os.environ | blind,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "libegl1" in done.stderr
    assert not list(tmp_path.iterdir())
