"""Rerun's viewer: what it shows, and what is said where it can't."""

import os
import signal
import socket
import subprocess
import sys
from pathlib import Path
from urllib.request import urlopen

import cv2
import numpy as np
import pytest

from prospect_mj.errors import InvalidValue, MissingViewer
from prospect_mj.replay import colours, screenshot, viewer
from prospect_mj.replay.screenshot import photograph

pytestmark = pytest.mark.gl

SKY, TABLE, SHELL = (205, 211, 219), (133, 102, 71), (175, 180, 190)


@pytest.fixture(scope="module")
def shown(picture):
    """A late correction (rows, columns, 3), RGB, while the jar is handed over."""
    return cv2.cvtColor(cv2.imread(str(picture)), cv2.COLOR_BGR2RGB)


def part(shown, rows, columns):
    """By shares of height and width."""
    height, width = shown.shape[:2]
    (top, bottom), (left, right) = rows, columns
    return shown[
        int(top * height) : int(bottom * height), int(left * width) : int(right * width)
    ]


def n_colours(shown):
    return len(np.unique(shown.reshape(-1, 3) @ [1, 256, 65536]))


def share(shown, colour):
    """Of the pixels, how many are near to a colour."""
    return (np.abs(shown.astype(int) - colour).max(axis=2) < 30).mean()


def test_the_scene_is_not_blank(shown):
    scene = part(shown, (0.06, 0.55), (0.0, 0.54))
    assert n_colours(scene) > 500
    assert share(scene, SKY) > 0.1
    assert share(scene, TABLE) > 0.05
    assert share(scene, SHELL) > 0.01


def test_lanes_and_words_are_not_blank(shown):
    lanes = part(shown, (0.60, 0.73), (0.0, 0.54))
    assert share(lanes, (180, 60, 60)) > 0.01  # what failed
    assert n_colours(lanes) > 100
    assert n_colours(part(shown, (0.80, 0.92), (0.0, 0.30))) > 100


@pytest.mark.parametrize("rows", [(0.28, 0.40), (0.45, 0.57), (0.62, 0.75)])
@pytest.mark.parametrize("columns", [(0.56, 0.73), (0.79, 0.95)])
def test_no_panel_is_empty(rows, columns, shown):
    panel = part(shown, rows, columns)
    assert share(panel, colours.ARMS["left"]) > 5e-4
    assert share(panel, colours.ARMS["right"]) > 5e-4


def test_the_learners_estimates_and_the_look_are_there(shown):
    assert n_colours(part(shown, (0.80, 0.95), (0.57, 0.90))) > 50
    eyes = part(shown, (0.06, 0.23), (0.55, 0.80))
    assert n_colours(eyes) > 500
    assert (eyes.min(axis=2) > 150).mean() > 0.005  # the lid
    assert share(part(shown, (0.08, 0.22), (0.84, 0.99)), (102, 102, 106)) > 0.1


def test_a_blank_picture_would_be_noticed(shown):
    blank = np.full_like(shown, 20)
    assert n_colours(blank) == 1
    assert share(blank, SKY) == 0


def test_a_page_is_served_until_it_is_interrupted(exported):
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    code = (
        "import sys; from pathlib import Path; from prospect_mj.replay import viewer\n"
        "try:\n"
        "  viewer.serve([Path(sys.argv[1])], '127.0.0.1', int(sys.argv[2]),\n"
        "    lambda page: print(page, flush=True))\n"
        "except KeyboardInterrupt: print('stopped')\n"
    )
    command = [sys.executable, "-c", code, str(exported["optimal"]), str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as server:
        try:
            page = server.stdout.readline().strip()
            assert page.startswith(f"http://127.0.0.1:{port}/?url=rerun")
            with urlopen(page, timeout=20) as answer:
                assert b"Rerun" in answer.read()
        finally:
            server.send_signal(signal.SIGINT)
            rest, _ = server.communicate(timeout=20)
    assert rest == "stopped\n"
    viewer.check_port_free("127.0.0.1", port)


def test_a_port_that_is_taken_is_refused():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        for number in (port, port - 1):
            with pytest.raises(InvalidValue, match="a free one on 127"):
                viewer.check_port_free("127.0.0.1", number)
    for number in (0, 70_000):
        with pytest.raises(InvalidValue, match="--port"):
            viewer.check_port_free("127.0.0.1", number)


@pytest.mark.parametrize("host", ["localhost", "::1", "", "127.0.0.1:80", "8.8.8.8"])
def test_a_host_that_rerun_can_not_listen_on_is_refused(host):
    with pytest.raises(InvalidValue, match=r"--host is .* an IPv4 address"):
        viewer.check_port_free(host, 9090)


def test_a_viewer_that_is_not_installed_is_named(monkeypatch):
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(MissingViewer, match="pip install rerun-sdk"):
        viewer.program()


def test_a_viewer_without_a_driver_says_what_to_install(
    exported, tmp_path, monkeypatch
):
    nowhere = os.fspath(tmp_path / "none.json")
    for name in ("VK_DRIVER_FILES", "VK_ICD_FILENAMES"):
        monkeypatch.setenv(name, nowhere)
    with pytest.raises(ChildProcessError, match="install Debian's mesa-vulkan-drivers"):
        photograph(exported["optimal"], tmp_path / "none.png")


def test_a_viewer_that_is_slow_to_begin_is_waited_for(tmp_path, monkeypatch):
    """On a busy machine nobody listens yet when its client comes."""
    idle, refusals = tmp_path / "idle", iter(range(3))
    idle.write_text("#!/bin/sh\nexec sleep 60\n")
    idle.chmod(0o755)

    class Client:
        def __init__(self, url):
            if next(refusals, None) is not None:
                raise ConnectionError("transport error")

        def get_state(self):
            pass

        def open(self, file):
            self.file = file

        def set_time(self, timeline, duration, play_state):
            self.seconds = duration

        def save_screenshot(self, png):
            Path(png).write_text(f"{self.file} at {self.seconds} s")

    monkeypatch.setattr(screenshot, "ViewerClient", Client)
    monkeypatch.setattr(screenshot, "program", lambda: str(idle))
    for name in ("_POLL", "_REST"):
        monkeypatch.setattr(screenshot, name, 0.01)
    photograph(tmp_path / "late.rrd", tmp_path / "late.png", seconds=2.5)
    assert next(refusals, None) is None
    assert (tmp_path / "late.png").read_text() == f"{tmp_path}/late.rrd at 2.5 s"
