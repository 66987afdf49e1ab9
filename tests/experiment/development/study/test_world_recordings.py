"""Recordings of worlds: refused in one line where one isn't what it must be."""

from dataclasses import replace

import numpy as np
import pytest
import small_study
from ideal_recording import recording, unseen

from prospect_mj import paths
from prospect_mj.errors import RecordingError
from prospect_mj.experiment.development.study.recordings import Recordings


def of(**worlds):
    return Recordings({name.replace("_", "-"): one for name, one in worlds.items()})


@pytest.fixture(scope="module")
def made():
    return small_study.recordings().by_world


def test_worlds_made_by_hand_are_fit(made):
    checked = Recordings(made).checked()
    assert checked.by_world is made
    assert checked.standard is made["standard"]


def test_equal_recordings_lack_the_variation(made):
    message = "worlds standard and noisy are the same: the variation .* is not in them"
    with pytest.raises(RecordingError, match=message):
        of(standard=made["standard"], noisy=made["standard"]).checked()


def test_the_lid_must_go_down_in_the_world_with_the_post_only(made):
    message = "world post lacks the variation .* the jar's lid doesn't go down"
    with pytest.raises(RecordingError, match=message):
        of(standard=made["standard"], post=made["noisy"]).checked()
    message = "world noisy lacks .* the jar's body doesn't go down"
    with pytest.raises(RecordingError, match=message):
        of(standard=made["standard"], noisy=made["post"]).checked()


def test_a_recording_that_is_not_deep_enough_is_refused():
    shallow = recording(depth=3, left=(small_study.ideal,), right=(small_study.ideal,))
    with pytest.raises(RecordingError):
        of(standard=shallow).checked()


def test_one_without_an_orientation_is_refused():
    lame = recording(left=(unseen,), right=(small_study.ideal,))
    shown = lame.presentations
    lame = replace(lame, presentations=replace(shown, lid=np.full_like(shown.lid, 0)))
    with pytest.raises(RecordingError):
        of(standard=lame).checked()


def test_a_missing_recording_is_named_with_what_to_do(tmp_path):
    message = f"{tmp_path} has no recording of world noisy; .* --world noisy makes it"
    with pytest.raises(RecordingError, match=message):
        Recordings.load(("standard", "noisy"), None, tmp_path)


def test_a_recording_of_another_world_is_not_taken_for_it(tmp_path):
    shipped = paths.RECORDINGS / "standard"
    (tmp_path / "noisy").symlink_to(shipped)
    with pytest.raises(RecordingError, match="holds a recording of world standard"):
        Recordings.load(("standard", "noisy"), None, tmp_path)
    read = Recordings.load(("standard",), shipped, tmp_path)
    assert list(read.by_world) == ["standard"]
    assert (read.path, read.folder) == (shipped, tmp_path)


def test_what_is_no_recording_is_told(tmp_path):
    (tmp_path / "noisy").mkdir()
    with pytest.raises(RecordingError, match="not a recording"):
        Recordings.load(("standard", "noisy"), None, tmp_path)
