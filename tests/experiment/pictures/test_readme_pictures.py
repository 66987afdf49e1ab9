"""The pictures of the pages that are made by running something."""

from contextlib import nullcontext
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from prospect_mj.experiment.pictures import (
    mind_picture,
    replay_picture,
    scene_picture,
    worlds_picture,
)
from prospect_mj.experiment.pictures.post_pictures import post_pictures
from prospect_mj.experiment.portraits.run_frame import name_of

ROOT = Path(__file__).resolve().parents[3]
RED, GREY = (0, 0, 200), (90, 90, 90)
"""Blue, green and red."""


def decoded(content):
    return cv2.imdecode(np.frombuffer(content, np.uint8), cv2.IMREAD_COLOR)


@pytest.mark.gl
def test_the_scene_has_a_step_for_each_of_four_different_frames():
    ticks = []
    picture = decoded(scene_picture.scene_picture(lambda: ticks.append(1)))
    assert len(ticks) == scene_picture.STEPS == 4
    assert picture.shape == (*scene_picture.SIZE, 3)
    halves = [np.hsplit(row, 2) for row in np.vsplit(picture.astype(float), 2)]
    frames = [frame for row in halves for frame in row]
    for before, after in pairwise(frames):
        assert (np.abs(after - before).max(axis=2) > 30).mean() > 0.02


def test_the_weights_are_of_the_run_that_the_pages_begin_with(monkeypatch):
    ticks, drawn = [], []

    def weights_of(run, kept):
        assert run.path.is_dir()
        drawn.append(run)
        return b"the picture"

    monkeypatch.setattr(mind_picture, "weights_of", weights_of)
    made = mind_picture.mind_picture(lambda: ticks.append(1), trials=2)
    assert made == b"the picture"
    assert len(ticks) == mind_picture.STEPS
    (run,) = drawn
    assert name_of(run) == "run train-0001, seed 0"
    assert (run.config.physics, run.n_trials) == ("recorded", 2)
    assert not run.path.parent.exists()


def test_the_picture_of_weights_in_the_docs_is_a_drawing():
    shown = cv2.imread(str(ROOT / "docs/images/weights.png"))
    assert shown.shape == (1800, 1200, 3)
    assert shown.std() > 30


@pytest.fixture
def photographed(monkeypatch):
    """All behind the picture of Rerun but what becomes of the screenshot."""

    def photograph(file, png, seconds):
        screen = np.full((1080, 1920, 3), GREY, np.uint8)
        screen[: replay_picture.BAR] = RED
        cv2.imwrite(str(png), screen)

    one = SimpleNamespace(episode=None, story=None)
    monkeypatch.setattr(replay_picture, "recorded_run", nullcontext)
    monkeypatch.setattr(replay_picture, "_last_late_correction", lambda run: one)
    monkeypatch.setattr(replay_picture, "_handed_over_at", lambda episode: 12.5)
    monkeypatch.setattr(replay_picture, "export", lambda *given: None)
    monkeypatch.setattr(replay_picture, "photograph", photograph)


def test_the_viewers_bar_is_cut_off_and_nothing_else(photographed):
    ticks = []
    shown = decoded(replay_picture.replay_picture(lambda: ticks.append(1)))
    assert len(ticks) == replay_picture.STEPS
    rows, columns, _ = shown.shape
    assert columns == replay_picture.WIDTH
    assert rows == round((1080 - replay_picture.BAR) * columns / 1920)
    assert (shown == GREY).all()


def test_the_picture_in_the_docs_begins_with_the_line_below_the_bar():
    """A line all across parts bar and panels; a bar of another height would show."""
    shown = cv2.imread(str(ROOT / "docs/images/replay.png")).astype(float)
    line, below = shown[0, 1:-1], shown[1:3, 1:-1]
    assert line.std(axis=0).max() < 4
    assert line.mean() > below.mean() + 15


@pytest.mark.gl
def test_every_world_has_a_cell_with_the_pixels_of_the_eye(monkeypatch):
    worlds = {name: worlds_picture.WORLDS[name] for name in ("noisy", "standard")}
    green = np.full((200, 200, 3), (20, 200, 20), np.uint8)
    post = {word: green for word in "abcd"}
    monkeypatch.setattr(worlds_picture, "WORLDS", worlds)
    monkeypatch.setattr(worlds_picture, "post_pictures", lambda size: post)
    ticks = []
    picture = decoded(worlds_picture.worlds_picture(lambda: ticks.append(1)))
    assert len(ticks) == len(worlds) + 1
    rows, columns = (2 * side for side in worlds_picture.CROP)
    caption, gap = worlds_picture.CAPTION, worlds_picture.GAP
    assert picture.shape == (rows + 200 + 2 * caption, 4 * columns + gap, 3)
    assert (picture[-200:, :200] == (20, 200, 20)).all()
    seen = picture[caption : caption + rows]
    cells = seen[:, : 2 * columns], seen[:, -2 * columns :]
    # Each pixel of the eye is four of the picture.
    assert all((cell[::2, ::2] == cell[1::2, 1::2]).all() for cell in cells)
    dark = [cell[:10].astype(float).std() for cell in cells]
    assert dark[0] > 2 * dark[1]


@pytest.mark.gl
def test_the_post_is_seen_to_stop_one_end_and_not_the_other():
    pictures = post_pictures(80)
    _, post, jammed, inserted = (p.astype(float) for p in pictures.values())
    assert {picture.shape for picture in pictures.values()} == {(80, 80, 3)}
    brass = [count_brass(picture) for picture in (post, jammed, inserted)]
    # All of it, what a jar that stands on it leaves free, and nothing.
    assert brass[0] > brass[1] > brass[2] == 0
    assert np.abs(jammed - inserted).mean() > 5


def count_brass(picture):
    red, green, blue = picture.transpose(2, 0, 1)
    return int(((red > 1.15 * green) & (green > 2 * blue) & (red > 110)).sum())
