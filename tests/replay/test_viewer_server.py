"""Rerun's programs that end too early, or don't answer."""

import os
import subprocess
import sys
import time

import pytest

from prospect_mj.replay import screenshot, viewer


@pytest.fixture
def program(tmp_path, monkeypatch):
    """Takes the place of Rerun's program: a shell's script."""

    def replace(script):
        path = tmp_path / "rerun"
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        for module in (viewer, screenshot):
            monkeypatch.setattr(module, "program", lambda: path)

    return replace


def test_no_page_is_told_of_a_server_that_ended(program, tmp_path):
    program("echo 'Error: no such file' >&2; exit 3")
    told, port = [], viewer.free_port()
    with pytest.raises(ChildProcessError, match="code 3: Error: no such file"):
        viewer.serve([tmp_path / "none.rrd"], viewer.HOST, port, told.append)
    assert told == []


SERVE = """
import sys
from pathlib import Path
from prospect_mj.replay import viewer

viewer.program = lambda: Path(sys.argv[1])
viewer._answers = lambda server, page: True
viewer.serve([], viewer.HOST, viewer.free_port(), print, Path(sys.argv[2]))
"""


def is_alive(process):
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def test_the_server_and_its_folder_go_with_a_process_that_is_killed(tmp_path):
    rerun, folder, started = (tmp_path / name for name in ("rerun", "passing", "pid"))
    tell = f"echo $$ > {started}.new && mv {started}.new {started}"
    rerun.write_text(f"#!/bin/sh\n{tell}\nexec sleep 60\n")
    rerun.chmod(0o755)
    folder.mkdir()
    (folder / "late.rrd").touch()
    process = subprocess.Popen([sys.executable, "-c", SERVE, rerun, folder])
    deadline = time.monotonic() + 30
    while not started.exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    server = int(started.read_text())
    assert is_alive(server)
    process.kill()
    process.wait()
    while (is_alive(server) or folder.exists()) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert not is_alive(server)
    assert not folder.exists()


def test_a_viewer_that_never_answers_is_given_up(program, tmp_path, monkeypatch):
    class Deaf:
        def __init__(self, url):
            raise TimeoutError("no answer")

    program("exec sleep 60")
    monkeypatch.setattr(screenshot, "ViewerClient", Deaf)
    for name in ("_PATIENCE", "_POLL", "_REST"):
        monkeypatch.setattr(screenshot, name, 0.01)
    with pytest.raises(ChildProcessError, match="does not answer: no answer"):
        screenshot.photograph(tmp_path / "late.rrd", tmp_path / "late.png")
