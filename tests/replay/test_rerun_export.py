"""Episodes as Rerun reads them."""

import resource
import time

import numpy as np
import pytest
from rrd import Recording, rerun
from strategies import STRATEGIES, story_of

from prospect_mj.actions.action import Action
from prospect_mj.episodes.episode import QUANTITIES
from prospect_mj.replay.playback import hand_path, model_of, play
from prospect_mj.replay.rerun_export import Story, export
from prospect_mj.robot.names import SIDES

pytestmark = pytest.mark.gl

TRANSLATION, QUATERNION = "Transform3D:translation", "Transform3D:quaternion"


@pytest.fixture(scope="module")
def recording(exported):
    return Recording(exported["late"])


@pytest.fixture(scope="module")
def played(late):
    model = model_of(late)
    return model, play(late, model)


@pytest.mark.parametrize("name", STRATEGIES)
def test_rerun_finds_nothing_wrong(name, strategies, exported):
    assert strategies[name].inserted == (name != "timed_out")
    verified = rerun("rrd", "verify", exported[name])
    assert verified.returncode == 0, verified.stderr


def test_ten_actions_are_exported_in_a_moment(strategies, tmp_path):
    path, episode = tmp_path / "ten.rrd", strategies["timed_out"]
    assert len(episode.actions) == 10
    # Of processor time, the better of two: other processes are not what is measured.
    seconds = []
    for _ in range(2):
        begun = time.process_time()
        export(episode, story_of("ten", episode), path)
        seconds.append(time.process_time() - begun)
    assert min(seconds) < 3.0
    assert path.stat().st_size < 5_000_000


def test_everything_is_there(recording):
    wanted = {
        "/scene/jar/mesh",
        "/scene/left_palm",
        "/scene/contacts",
        "/scene/contact_forces",
        "/scene/plan/left",
        "/look/images/left_eye",
        "/look/images/right_eye",
        "/look/histogram",
        "/running/action",
        "/running/left_arm",
        "/grasp_residual/right",
        "/forces/wrist/left",
        "/forces/fingertips/right",
        "/forces/insertion/right",
        "/ik_error/position/left",
        "/ik_error/angle/left",
        "/q_values/grasp-left",
        "/log",
    }
    assert wanted - recording.entities == set()
    assert len(recording.entities) < 150


def test_bodies_are_where_mujoco_has_them(recording, played):
    model, frames = played
    for name in ("jar", "left_palm", "right_finger2_distal"):
        body = model.body("jar/" if name == "jar" else name).id
        times, places = recording.column(f"/scene/{name}", TRANSLATION)
        _, turns = recording.column(f"/scene/{name}", QUATERNION)
        np.testing.assert_allclose(times, frames.times, atol=1e-8)
        here = np.squeeze(places)
        np.testing.assert_allclose(here, frames.positions[:, body], atol=1e-6)
        # Rerun has the real part last.
        turned = np.roll(np.squeeze(turns), 1, axis=1)
        np.testing.assert_allclose(turned, frames.quaternions[:, body], atol=1e-6)


def test_what_never_moves_is_logged_once(recording, played):
    model, frames = played
    table = model.body("table/").id
    place = recording.static("/scene/table", TRANSLATION)
    np.testing.assert_allclose(place[0], frames.positions[0, table], atol=1e-6)


def test_curves_are_what_was_measured(recording, late):
    times = late.signals.times - late.states.times[0]
    for arm, side in enumerate(SIDES):
        measured = late.signals.measured[:, arm, QUANTITIES.index("position_error")]
        at, values = recording.column(f"/ik_error/position/{side}", "Scalars:scalars")
        drawn = [(t, v[0]) for t, v in zip(at, values, strict=True) if v]
        there = ~np.isnan(measured)
        np.testing.assert_allclose([t for t, _ in drawn], times[there], atol=1e-8)
        in_mm = 1e3 * measured[there].astype(float)
        np.testing.assert_allclose([v for _, v in drawn], in_mm, rtol=1e-6)
        # A line is not drawn over a gap: an empty row ends each stretch.
        n_stretches = np.count_nonzero(np.diff(np.append(there, False).astype(int)) < 0)
        assert sum(not v for v in values) in (n_stretches, n_stretches - 1)


def test_q_values_stay_until_the_next_choice(recording, late):
    story = story_of("late", late)
    at, values = recording.column("/q_values/insert-left", "Scalars:scalars")
    wanted = [d.q_values[Action.INSERT_LEFT] for d in story.decisions]
    np.testing.assert_allclose(np.ravel(values), [*wanted, wanted[-1]])
    starts = [span.start - late.states.times[0] for span in late.actions]
    np.testing.assert_allclose(at[:-1], starts, atol=1e-8)


def test_plans_are_shown_while_they_are_followed(recording, late, played):
    model, _ = played
    at, strips = recording.column("/scene/plan/left", "LineStrips3D:strips")
    path = next(p for span in late.actions for p in span.paths if p.side == "left")
    row = np.searchsorted(at, path.start - late.states.times[0] - 1e-6)
    np.testing.assert_allclose(strips[row][0], hand_path(model, path), atol=1e-6)
    assert strips[-1] == []


def test_lanes_tell_what_ran_and_what_failed(recording, late):
    at, states = recording.column("/running/action", "StateChange:state")
    assert [state[0] for state in states] == [
        "1. grasp-right",
        "2. insert-right: jammed",
        "3. swap-right-to-left",
        "4. insert-left",
        "",
    ]
    ends = [span.end - late.states.times[0] for span in late.actions]
    np.testing.assert_allclose(at, [0.0, *ends], atol=1e-8)
    at, controllers = recording.column("/running/right_arm", "StateChange:state")
    assert ["insertion: stalled"] in controllers
    # The hand begins together with the reach, and is open at once.
    shown = controllers[np.searchsorted(at, 0.2) - 1]
    assert shown == ["reach"]


def test_words_tell_the_result_of_each_action(recording):
    _, words = recording.column("/log", "TextLog:text")
    _, levels = recording.column("/log", "TextLog:level")
    told = [word[0] for word in words]
    assert told[0] == "look: jar found; the lid lies to the left"
    assert told[1].startswith("1. grasp-right: success, 4.")
    assert told[2].startswith("2. insert-right (a random choice): jammed")
    assert "(supported" in told[2]
    assert told[-1] == "inserted"
    assert [level[0] for level in levels] == ["INFO", "INFO", "WARN", *["INFO"] * 3]


def test_an_action_that_may_not_run_is_told_and_takes_no_time(exported, strategies):
    recording = Recording(exported["timed_out"])
    _, words = recording.column("/log", "TextLog:text")
    assert words[1][0] == "1. swap-left-to-right: not_allowed, 0.0 s"
    assert words[-1][0] == "not inserted"
    _, states = recording.column("/running/action", "StateChange:state")
    assert states[0][0] == "2. grasp-right"


def test_two_exports_of_the_same_are_the_same(late, exported, tmp_path):
    again, other = tmp_path / "again.rrd", tmp_path / "other.rrd"
    export(late, story_of("late", late), again)
    assert rerun("rrd", "compare", exported["late"], again).returncode == 0
    export(late, Story("late"), other)
    assert rerun("rrd", "compare", exported["late"], other).returncode != 0
    assert "/q_values/grasp-left" not in Recording(other).entities


def test_a_file_that_could_not_be_finished_is_not_there(late, tmp_path, monkeypatch):
    def fail(*_):
        raise OSError("disk full")

    monkeypatch.setattr("prospect_mj.replay.rerun_story.log_look", fail)
    with pytest.raises(OSError, match="disk full"):
        export(late, Story("late"), tmp_path / "late.rrd")
    assert list(tmp_path.iterdir()) == []


def test_where_nothing_can_be_written_it_is_an_error_of_the_machine(late, tmp_path):
    with pytest.raises(FileNotFoundError):
        export(late, Story("late"), tmp_path / "none" / "late.rrd")


@pytest.fixture
def little_room():
    """No file may be longer than this process is allowed, as on a disk that is full."""
    least, most = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, most))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, (least, most))


@pytest.mark.timeout(60)
def test_on_a_full_disk_it_ends_and_leaves_nothing(late, tmp_path, little_room):
    with pytest.raises(OSError, match="too large"):
        export(late, Story("late"), tmp_path / "late.rrd")
    assert not list(tmp_path.iterdir())
