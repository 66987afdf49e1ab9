"""Where no window can be opened, that is told before anything waits for one."""

import sys

import glfw
import pytest

from prospect_mj import display
from prospect_mj.errors import NoDisplay

linux = pytest.mark.skipif(sys.platform != "linux", reason="X11's variables")


@pytest.fixture(autouse=True)
def no_display(monkeypatch):
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)


@linux
def test_without_a_display_it_says_what_to_do_instead():
    with pytest.raises(NoDisplay, match=r"DISPLAY .*; look at the film$"):
        display.require_display("look at the film")


@linux
def test_a_display_that_is_not_there_is_found_out(monkeypatch):
    monkeypatch.setenv("DISPLAY", ":9876")
    reason = display.why_no_window()
    assert reason.startswith("no window can be opened: ")
    assert ":9876" in reason


@pytest.mark.parametrize(
    ("said", "told"), [([b"X11: no screen"], "X11: no screen"), ([], "gave no reason")]
)
def test_a_window_that_fails_has_a_reason(said, told, monkeypatch, capsys):
    def listen(callback):
        for words in said:
            callback(0, words)

    monkeypatch.setattr(glfw, "set_error_callback", listen)
    monkeypatch.setattr(glfw, "init", lambda: False)
    monkeypatch.setattr(glfw, "window_hint", lambda *_: None)
    monkeypatch.setattr(glfw, "create_window", lambda *_: None)
    assert display.main() == 1
    assert told in capsys.readouterr().err


def test_a_driver_that_takes_the_process_down_is_survived(monkeypatch):
    monkeypatch.setenv("DISPLAY", ":0")
    crash = "import os; os.abort()"
    monkeypatch.setattr(display, "_PROBE", ("-c", crash))
    assert "exit code -6" in display.why_no_window()


def test_a_window_that_never_comes_is_given_up(monkeypatch):
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(display, "_PATIENCE", 0.2)
    monkeypatch.setattr(display, "_PROBE", ("-c", "import time; time.sleep(60)"))
    assert "within 0 s" in display.why_no_window()


def test_a_window_that_opens_is_no_reason(monkeypatch):
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(display, "_PROBE", ("-c", ""))
    assert display.why_no_window() is None
    display.require_display("look away")
