"""Episodes as Rerun reads them."""

import subprocess
from pathlib import Path

import numpy as np
import pytest
import rerun_cli

from prospect_mj.actions.action import Action
from prospect_mj.replay.rerun_export import Decision, Story, export

pytestmark = pytest.mark.gl


# The program itself: the Python one in front of it keeps its exit code to itself.
RERUN = Path(rerun_cli.__file__).parent / "rerun"


def rerun(*arguments):
    return subprocess.run(
        [RERUN, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def story(late):
    values = np.linspace(-5, -1, len(Action))
    return Story("late correction", [Decision(values, False) for _ in late.actions])


@pytest.fixture(scope="module")
def exported(late, story, tmp_path_factory):
    path = tmp_path_factory.mktemp("replay") / "late.rrd"
    export(late, story, path)
    return path


def test_rerun_finds_nothing_wrong(exported):
    verified = rerun("rrd", "verify", exported)
    assert verified.returncode == 0, verified.stderr
    assert exported.stat().st_size < 4_000_000


def test_everything_is_there(exported, late):
    printed = rerun("rrd", "print", exported).stdout
    wanted = [
        "/scene/jar/mesh",
        "/scene/left_palm",
        "/scene/contacts",
        "/scene/plan/left",
        "/look/images/left_eye",
        "/look/histogram",
        "/running/action",
        "/running/controller/left",
        "/grasp_residual/right",
        "/forces/wrist/left",
        "/forces/fingertips/right",
        "/errors/position/left",
        "/q_values/grasp-left",
        "/log",
    ]
    assert [path for path in wanted if path not in printed] == []


def test_two_exports_of_the_same_are_the_same(late, story, exported, tmp_path):
    again = tmp_path / "again.rrd"
    export(late, story, again)
    assert rerun("rrd", "compare", exported, again).returncode == 0
    other = tmp_path / "other.rrd"
    export(late, Story(story.title), other)
    assert rerun("rrd", "compare", exported, other).returncode != 0
