"""Playing actions live: which ones, at which pace, and what it takes to end."""

import numpy as np
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.cli import view
from prospect_mj.errors import InvalidChoice, InvalidValue, NoDisplay
from prospect_mj.experiment.watching import live_view
from prospect_mj.experiment.watching.shown import Shown
from prospect_mj.task.pick_place import PickPlaceTask

EARLY = (Action.GRASP_RIGHT, Action.SWAP_RIGHT_TO_LEFT, Action.INSERT_LEFT)


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "there.mp4").touch()


@pytest.mark.parametrize(
    "words",
    [
        ["grasp-right,swap-right-left,insert-left"],
        ["grasp-right", "swap-right-left", "insert-left"],
        ["grasp-right,", "swap-right-to-left,insert-left"],
    ],
)
def test_actions_stand_with_commas_or_blanks_in_both_forms(words):
    assert view.actions_named(words) == EARLY
    assert view.ViewOptions(tuple(words)).shown().actions == EARLY


def test_every_action_has_a_name_to_be_played_by():
    for action in Action:
        assert view.actions_named([action.label]) == (action,)
    with pytest.raises(InvalidChoice, match=r"grasp-both.*swap-left-right"):
        view.actions_named(["grasp-left,grasp-both"])


BAD = {
    "--actions push-left": "push-left",
    "--actions grasp-left swap-left": "swap-left",
    "--actions": "one or more",
    "--actions ,": "one or more",
    "--lid top": "top",
    "--world moon": "'moon'; valid: standard, post",
    "--lid": "--lid",
    "--seed -1": "-1",
    "--seed 1.5": "1.5",
    "--speed 0": "0.0",
    "--speed -1": "-1",
    "--speed nan": "nan",
    "--speed 1e9": "1000000000",
    "--video film.avi": "film.avi",
    "--video there.mp4": "there.mp4",
    "--video nowhere/film.mp4": "nowhere",
    "--video film.mp4 --speed 2": "beside --video",
    "grasp-left": "grasp-left",
    "--sped 2": "--sped",
}


@pytest.mark.parametrize(("options", "named"), BAD.items(), ids=BAD.keys())
def test_bad_input_is_one_line_and_writes_nothing(options, named, refused):
    assert named in refused(lambda: view.main(options.split()))


def test_without_a_display_it_names_the_video(monkeypatch, refused):
    def refuse(instead):
        raise NoDisplay(f"no window; {instead}")

    monkeypatch.setattr(view, "require_display", refuse)
    line = refused(lambda: view.main([]))
    assert line.startswith("error: no window; --video FILE.mp4")


def test_what_takes_seconds_is_told_before_the_window_opens(monkeypatch, capsys):
    def opened(shown):
        assert capsys.readouterr().err == "loading the scene ...\n"
        return []

    monkeypatch.setattr(view, "require_display", lambda instead: None)
    monkeypatch.setattr(live_view, "in_window", opened)
    assert view.main(["--actions", "grasp-left"]) == 0
    assert capsys.readouterr() == ("", "")


def test_settings_are_checked_where_they_are_made():
    with pytest.raises(InvalidValue, match="speed"):
        Shown("left", EARLY, speed=0.0)
    with pytest.raises(InvalidValue, match="one or more"):
        Shown("left", ())


class PaperWindow:
    """A window that only counts; the user closes it after so many pictures."""

    def __init__(self, closed_after):
        self.captions, self.times = [], []
        self._closed_after = closed_after

    def __call__(self, model, data):
        self._data = data
        return self

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.closed = True

    @property
    def is_open(self):
        return len(self.times) < self._closed_after

    def caption(self, words):
        self.captions.append(words)

    def sync(self):
        self.times.append(self._data.time)


@pytest.fixture
def window(monkeypatch):
    """Put one in the place of MuJoCo's, with a clock that runs as one sleeps."""
    now = [100.0]

    def sleep(seconds):
        now[0] += seconds

    monkeypatch.setattr(live_view.time, "sleep", sleep)
    monkeypatch.setattr(live_view.time, "monotonic", lambda: now[0])

    def opened(closed_after):
        paper = PaperWindow(closed_after)
        monkeypatch.setattr(live_view, "Viewer", paper)
        paper.now = now
        return paper

    return opened


@pytest.mark.gl
def test_it_plays_at_its_speed_and_stays_until_it_is_closed(window):
    paper = window(closed_after=400)
    shown = Shown("left", (Action.GRASP_LEFT,), seed=1, speed=2.0)
    outcome, done = live_view.in_window(shown)
    assert (outcome.action, outcome.result, done) == (0, "success", None)
    assert paper.captions == ["1. grasp-left", "done"]
    assert paper.closed
    playing = np.array([t for t in paper.times if t < paper.times[-1]])
    rate = live_view.FRAME_RATE / shown.speed
    np.testing.assert_allclose(np.diff(playing), 1 / rate, atol=2.1e-3)
    at_rest = len(paper.times) - len(playing)
    assert at_rest > 100
    # One second of waiting shows two of the physics; at rest it waits for pictures.
    waited = paper.now[0] - 100.0 - at_rest / live_view.FRAME_RATE
    assert waited == pytest.approx(outcome.sim_seconds / shown.speed, abs=0.1)


@pytest.mark.gl
def test_closing_early_ends_it_in_the_middle_of_an_action(window):
    paper = window(closed_after=20)
    assert list(live_view.in_window(Shown("left", EARLY))) == []
    assert len(paper.times) == 20
    assert paper.captions == ["1. grasp-right"]
    assert paper.closed


@pytest.mark.gl
def test_the_clock_makes_up_for_no_delay(window):
    """What was late is shown at the wanted speed all the same."""
    paper = window(closed_after=10**9)
    pace = live_view.Pace(paper, 1.0)
    with PickPlaceTask() as task:
        data = task.simulation.data
        paper(None, data)
        for data.time in np.arange(0.0, 1.0, 0.02):
            pace(data)
        assert paper.now[0] == pytest.approx(100.98, abs=0.03)
        paper.now[0] += 5.0
        for data.time in np.arange(1.0, 2.0, 0.02):
            pace(data)
        assert paper.now[0] == pytest.approx(106.96, abs=0.05)


@pytest.mark.gl
def test_a_film_is_that_of_the_episode(monkeypatch, tmp_path):
    filmed = []
    monkeypatch.setattr(live_view, "film", lambda *given: filmed.append(given))
    shown = Shown("right", (Action.GRASP_LEFT, Action.INSERT_LEFT), seed=2)
    outcomes = list(live_view.in_film(shown, tmp_path / "a.mp4"))
    assert [outcome.result for outcome in outcomes] == ["success", "jammed"]
    ((episode, path),) = filmed
    assert path == tmp_path / "a.mp4"
    assert episode.presentation.orientation == "right"
    told = [(span.outcome.action, span.outcome.result) for span in episode.actions]
    assert told == [(outcome.action, outcome.result) for outcome in outcomes]
