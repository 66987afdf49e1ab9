"""Films of episodes."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from prospect_mj.episodes.episode import States
from prospect_mj.errors import EpisodeError, MissingEncoder
from prospect_mj.replay import video
from prospect_mj.replay.video import VideoSettings, film, moments

pytestmark = pytest.mark.gl

SMALL = VideoSettings(width=214, height=120, rate=5)


@pytest.fixture(scope="module")
def short(late):
    """Its last four seconds, in which the jar goes into the receptacle."""
    states = late.states
    shown = states.times > states.times[-1] - 4.0
    return replace(late, states=States(states.times[shown], states.rows[shown]))


@pytest.fixture(scope="module")
def filmed(short, tmp_path_factory):
    path = tmp_path_factory.mktemp("film") / "late.mp4"
    film(short, path, SMALL)
    return path


def frames(path):
    reader = cv2.VideoCapture(str(path))
    code = int(reader.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little")
    pictures, rate = [], reader.get(cv2.CAP_PROP_FPS)
    while (read := reader.read())[0]:
        pictures.append(cv2.cvtColor(read[1], cv2.COLOR_BGR2RGB))
    return code, rate, pictures


def test_a_film_plays_at_real_time_in_a_codec_of_browsers(filmed, short):
    code, rate, pictures = frames(filmed)
    assert code in (b"avc1", b"h264")
    assert rate == SMALL.rate
    seconds = short.states.times[-1] - short.states.times[0]
    assert len(pictures) == pytest.approx(1 + seconds * SMALL.rate, abs=1)
    assert pictures[0].shape == (SMALL.height, SMALL.width, 3)
    content = filmed.read_bytes()
    # What a browser needs first comes first.
    assert content.index(b"moov") < content.index(b"mdat")


def test_its_pictures_are_those_of_the_states(filmed, short):
    _, _, pictures = frames(filmed)
    times = moments(short, SMALL.rate)
    assert times[0] == short.states.times[0]
    assert times[-1] == short.states.times[-1]
    for number in (0, -1):
        (exact,) = video.pictures(short, times[[number]], SMALL)
        difference = np.abs(pictures[number].astype(int) - exact)
        assert difference.mean() < 6
    moved = np.abs(pictures[0].astype(int) - pictures[-1])
    assert moved.mean() > 2


def test_captions_tell_what_has_happened(short):
    times = short.states.times[[-1]]
    size = {"width": 320, "height": 180}
    (captioned,) = video.pictures(short, times, VideoSettings(**size))
    (plain,) = video.pictures(short, times, VideoSettings(**size, captions=False))
    changed = np.abs(captioned.astype(int) - plain).max(axis=2) > 10
    rows, columns = np.nonzero(changed)
    # Five lines in the upper left corner, and nothing elsewhere.
    assert 100 < rows.max() < 140
    assert 100 < columns.max() < 300


def test_a_film_that_could_not_be_finished_is_not_there(short, tmp_path, monkeypatch):
    def fail(*_):
        raise OSError("disk full")
        yield

    monkeypatch.setattr(video, "pictures", fail)
    with pytest.raises(OSError, match="disk full"):
        film(short, tmp_path / "late.mp4", SMALL)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("script", ["exit 1", "cat > /dev/null; exit 1"])
def test_an_ffmpeg_that_fails_is_one_line(script, short, tmp_path, monkeypatch, capfd):
    """As on a full disk: at once, or when all pictures are there."""
    ffmpeg, films = tmp_path / "ffmpeg", tmp_path / "films"
    ffmpeg.write_text(f"#!/bin/sh\n{script}\n")
    ffmpeg.chmod(0o755)
    films.mkdir()
    monkeypatch.setenv("IMAGEIO_FFMPEG_EXE", str(ffmpeg))
    with pytest.raises(ChildProcessError, match=r"late\.mp4 can't be written: ffmpeg"):
        film(short, films / "late.mp4", SMALL)
    assert capfd.readouterr().err == ""
    assert not list(films.iterdir())


def test_without_ffmpeg_it_says_so_and_leaves_nothing(short, tmp_path, monkeypatch):
    def missing():
        raise RuntimeError("No ffmpeg exe could be found.")

    monkeypatch.setattr(video.imageio_ffmpeg, "get_ffmpeg_exe", missing)
    with pytest.raises(MissingEncoder, match="pip install imageio-ffmpeg"):
        film(short, tmp_path / "late.mp4", SMALL)
    assert not list(tmp_path.iterdir())


def test_an_episode_of_another_model_is_refused_before_ffmpeg_is_asked(
    short, tmp_path, capfd
):
    fewer = States(short.states.times, short.states.rows[:, :7])
    with pytest.raises(EpisodeError, match="recorded with another model"):
        film(replace(short, states=fewer), tmp_path / "film.mp4", SMALL)
    assert capfd.readouterr().err == ""
    assert list(tmp_path.iterdir()) == []
