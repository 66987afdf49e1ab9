"""Live grasps, kept in files; and what the fingers feel at a wide lid."""

from pathlib import Path

import numpy as np
import pytest
from felt_by_hand import grasps

from prospect_mj import tables
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.development.haptics import live
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    LID,
    table,
)
from prospect_mj.experiment.development.haptics.live import Share
from prospect_mj.experiment.development.haptics.settings import HapticSettings
from prospect_mj.task.presentation import ORIENTATIONS

JARS = "wide-lid", "narrow-lid"
EIGHT = HapticSettings(grasped=8)


def keep(folder: Path) -> None:
    made = grasps(EIGHT.per_side, np.random.default_rng(0))
    for jar in JARS:
        for side in ORIENTATIONS:
            share = Share(jar, side, EIGHT.per_side, EIGHT.seed)
            own = [grasp for grasp in made if grasp.orientation == side]
            content = tables.parquet(table(own), share.digest)
            (folder / share.file).write_bytes(content)


def test_kept_grasps_are_read_and_not_made_again(tmp_path: Path):
    keep(tmp_path)
    lines: list[str] = []
    found = live.grasps(tmp_path, JARS, EIGHT, 1, lines.append)
    assert list(found) == list(JARS)
    assert [len(each) for each in found.values()] == [16] * len(JARS)
    assert not lines


def test_a_damaged_file_is_told_of_and_left(tmp_path: Path):
    keep(tmp_path)
    path = tmp_path / Share("wide-lid", "left", 2, 0).file
    content = path.read_bytes()[:-40]
    path.write_bytes(content)
    with pytest.raises(RunFolderError, match="is damaged; move it away"):
        live.grasps(tmp_path, JARS, EIGHT, 1, print)
    assert path.read_bytes() == content


def test_no_presentations_are_no_jars(tmp_path: Path):
    none = HapticSettings(grasped=0)
    assert live.grasps(tmp_path / "new", JARS, none, 1, print) == {}


def test_a_share_is_known_by_what_decides_it():
    share = Share("standard", "left", 2, 0)
    others = [
        share._replace(jar="wide-lid"),
        share._replace(orientation="right"),
        share._replace(presentations=3),
        share._replace(seed=1),
    ]
    assert len({one.digest for one in (share, *others)}) == 5


@pytest.mark.gl
def test_a_wide_lid_is_probed_again_and_the_body_is_not():
    """An offset of the hand shows more at a larger radius, and is corrected."""
    made = live.grasped(Share("wide-lid", "left", 1, 0))
    assert [grasp.kind for grasp in made] == 2 * [CRADLE, HAND_OVER]
    assert [grasp.hand for grasp in made] == ["left", "right", "right", "left"]
    for grasp in made:
        assert grasp.samples[-1, 2] == (grasp.end == LID)
    lid, body = (
        [g.samples[0, 0] for g in made if (g.end == LID) == held]
        for held in (True, False)
    )
    assert min(lid) > max(body)
