"""The commands that draw pictures of the pages: a bar of real steps, or none."""

import io
import sys
from importlib import import_module

import pytest

from prospect_mj.cli import draw
from prospect_mj.errors import RenderingUnavailable

PICTURES = "prospect_mj.experiment.pictures"
LONG = {
    "field": ("field_plot", "field_picture"),
    "scene": ("scene_picture", "scene_picture"),
    "replay": ("replay_picture", "replay_picture"),
    "weights": ("mind_picture", "mind_picture"),
    "worlds": ("worlds_picture", "worlds_picture"),
}
"""Commands that take more than two seconds: module and function behind each."""


class Terminal(io.StringIO):
    def isatty(self):
        return True


@pytest.fixture
def open_terminal(monkeypatch):
    """To be called in the test: between set-up and test pytest takes stderr back."""

    def opened():
        shown = Terminal()
        monkeypatch.setattr(sys, "stderr", shown)
        return shown

    return opened


@pytest.mark.gl
@pytest.mark.parametrize("name", LONG)
def test_a_bar_is_there_at_once_and_counts_the_steps(
    name, tmp_path, open_terminal, monkeypatch
):
    terminal = open_terminal()
    module, function = LONG[name]
    pictures = import_module(f"{PICTURES}.{module}")

    def instead(tick):
        assert "loading" in terminal.getvalue()
        for done in range(pictures.STEPS):
            assert f" {done}/{pictures.STEPS} " in terminal.getvalue()
            tick()
        return b"it"

    monkeypatch.setattr(pictures, function, instead)
    # Else it tells of steps that follow too soon on one another at the end only.
    usual = draw.tqdm
    monkeypatch.setattr(draw, "tqdm", lambda **k: usual(**k, mininterval=0))
    out = tmp_path / "new" / "a.png"
    assert getattr(draw, name)(["--out", str(out)]) == 0
    assert f" {pictures.STEPS}/{pictures.STEPS} " in terminal.getvalue()
    assert out.read_bytes() == b"it"


def test_what_takes_a_second_has_no_bar(tmp_path, open_terminal):
    terminal = open_terminal()
    assert draw.automaton(["--out", str(tmp_path / "a.png")]) == 0
    assert terminal.getvalue() == ""


def test_elsewhere_than_on_a_terminal_there_is_no_bar(tmp_path, monkeypatch, capsys):
    from prospect_mj.experiment.pictures import mind_picture

    monkeypatch.setattr(mind_picture, "mind_picture", lambda tick: b"it")
    out = tmp_path / "a.png"
    assert draw.weights(["--out", str(out)]) == 0
    assert capsys.readouterr() == (f"wrote {out}\n", "")


@pytest.mark.parametrize("name", ["a.jpg", "folder.png"])
def test_what_is_no_picture_is_refused_before_it_is_drawn(name, tmp_path, capsys):
    (tmp_path / "folder.png").mkdir()
    assert draw.field(["--out", str(tmp_path / name)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("error: --out is ")


def test_a_picture_that_fails_leaves_the_old_one(tmp_path, monkeypatch, capsys):
    def refuse():
        raise RenderingUnavailable("no OpenGL library")

    monkeypatch.setattr(draw.gl, "require_gl", refuse)
    old = tmp_path / "a.png"
    old.write_bytes(b"old")
    assert draw.scene(["--out", str(old)]) == 2
    assert capsys.readouterr().err == "error: no OpenGL library\n"
    assert old.read_bytes() == b"old"
