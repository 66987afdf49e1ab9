"""Rerun's programs that end too early, or don't answer."""

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
