"""MuJoCo's window is closed as a whole: its thread first, whatever comes in between."""

import signal
import threading
import time
from contextlib import nullcontext

import mujoco
import pytest

from prospect_mj import viewer
from prospect_mj.viewer import Viewer


class PaperHandle:
    """What `launch_passive` returns; its thread takes a while to end."""

    def __init__(self):
        self.cam = mujoco.MjvCamera()
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self._draw, daemon=True)
        self.thread.start()

    def _draw(self):
        self.ended.wait()
        time.sleep(0.2)

    def lock(self):
        return nullcontext()

    def close(self):
        self.ended.set()


@pytest.fixture
def opened(monkeypatch):
    """The handles of all windows; `during` is called while one opens."""
    handles, during = [], []

    def launch(model, data, **options):
        handles.append(PaperHandle())
        for call in during:
            call()
        return handles[-1]

    monkeypatch.setattr(viewer.mujoco.viewer, "launch_passive", launch)
    yield handles, during
    for handle in handles:
        handle.close()


def test_closing_waits_until_nothing_is_drawn_any_more(opened):
    handles, _ = opened
    with Viewer(None, None) as window:
        assert handles[0].thread.is_alive()
    assert not handles[0].thread.is_alive()
    window.close()


def test_ctrl_c_while_it_opens_closes_it_first(opened):
    handles, during = opened
    during.append(lambda: signal.raise_signal(signal.SIGINT))
    usual = signal.getsignal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        Viewer(None, None)
    assert not handles[0].thread.is_alive()
    assert signal.getsignal(signal.SIGINT) is usual


def test_it_can_be_opened_beside_the_main_thread(opened):
    """Where no signal handler can be set."""
    windows = []
    thread = threading.Thread(target=lambda: windows.append(Viewer(None, None)))
    thread.start()
    thread.join()
    windows[0].close()
    assert not opened[0][0].thread.is_alive()
