"""Searches in live physics: kept by all that decides on them."""

from dataclasses import replace

import pytest

from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.development.rivals.planner import live, prices
from prospect_mj.experiment.development.rivals.planner.live import LiveSearches
from prospect_mj.experiment.development.rivals.planner.wrong_physics import WRONG
from prospect_mj.experiment.development.rivals.settings import RivalSettings
from prospect_mj.recording.recording import Recording


@pytest.fixture(scope="module")
def recording():
    return Recording.load()


@pytest.fixture
def made(monkeypatch):
    """The searches that are made, without physics."""
    done = []

    def priced(recording, settings):
        done.append(settings.live_presentations)
        rows = [{"method": prices.BLIND_LIVE, "trials": settings.live_presentations}]
        return prices.pa.Table.from_pylist(rows, schema=prices.PRICES)

    def searched(recording, settings, max_actions):
        done.append(settings.live_errors)
        rows = [{"error": error} for error in settings.live_errors]
        return prices.pa.Table.from_pylist(rows, schema=WRONG)

    monkeypatch.setattr(live, "live_prices", priced)
    monkeypatch.setattr(live, "searched", searched)
    return done


def searches(folder, recording, lines=None, **settings):
    tell = [].append if lines is None else lines.append
    return LiveSearches(
        folder / "rivals", recording, RivalSettings(**settings), 10, tell
    )


def test_what_was_searched_is_not_searched_again(made, recording, tmp_path):
    lines = []
    for _ in range(2):
        both = searches(tmp_path, recording, lines)
        assert both.prices()["trials"].to_pylist() == [2]
        assert both.wrong()["error"].to_pylist() == [-5, -4, 4, 5]
    assert made == [2, (-5, -4, 4, 5)]
    assert len(lines) == 2


def test_another_search_is_another(made, recording, tmp_path):
    searches(tmp_path, recording).wrong()
    searches(tmp_path, recording, live_errors=(3,)).wrong()
    searches(tmp_path, recording, depth=2).wrong()
    shown = recording.presentations
    fewer = replace(recording, presentations=replace(shown, lid=3 - shown.lid))
    searches(tmp_path, fewer).wrong()
    assert len(made) == 4


def test_without_live_physics_nothing_is_kept(made, recording, tmp_path):
    none = searches(tmp_path, recording, live_presentations=0, live_errors=())
    assert none.prices().num_rows == none.wrong().num_rows == 0
    assert made == list(tmp_path.iterdir()) == []


def test_a_damaged_search_is_one_line_and_stays(made, recording, tmp_path):
    searches(tmp_path, recording).wrong()
    (path,) = (tmp_path / "rivals").iterdir()
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(RunFolderError, match="damaged; move it away and run again"):
        searches(tmp_path, recording).wrong()
    assert path.exists()
