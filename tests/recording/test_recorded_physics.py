"""What is recorded is what live physics does, however the recording grew."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from ideal_grower import content

from prospect_mj.actions.action import Action
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.grower import presentation_rng, task_settings
from prospect_mj.recording.growing import GrowingRecording
from prospect_mj.recording.growth import Growth
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.workers import Workers
from prospect_mj.task.pick_place import PickPlaceTask

pytestmark = pytest.mark.gl

ROOT = Path(__file__).resolve().parents[2]
CONFIG = RecordingConfig(seed=4)
EXTENT = Extent(presentations=1, depth=2)
OPTIONS = ("--seed", "4", "--presentations", "1", "--depth", "2")


@pytest.fixture(scope="module")
def grown(tmp_path_factory):
    """A recording with one presentation of each orientation."""
    path = tmp_path_factory.mktemp("grown") / "recording"
    with GrowingRecording.open(path, RecordingKey.present(CONFIG)) as recording:
        for _ in Growth(recording, EXTENT).run(Workers(jobs=1)):
            pass
    return path


@pytest.fixture(scope="module")
def trees(grown):
    with GrowingRecording.open(grown, RecordingKey.present(CONFIG)) as recording:
        return {lid: recording.tree(lid, 0) for lid in ("left", "right")}


@pytest.fixture(scope="module")
def task():
    with PickPlaceTask(task_settings(CONFIG)) as task:
        yield task


def path_to(tree, number):
    """Numbers of the nodes from below the root to a node."""
    parent = tree.nodes[number].parent
    return [] if parent is None else [*path_to(tree, parent), number]


@pytest.mark.parametrize(("lid", "number"), [("left", 4), ("right", 4)])
def test_a_trial_that_is_never_left_has_the_recorded_outcomes(task, trees, lid, number):
    """The way to a node, live in one go; in the tree each action was run on its own."""
    tree = trees[lid]
    look = task.reset(lid, presentation_rng(CONFIG, lid, 0))
    assert tuple(look.histogram.tolist()) == tree.shown.histogram
    assert str(look.status) == tree.shown.look
    path = path_to(tree, number)
    assert len(path) == 2
    for node in (tree.nodes[n] for n in path):
        outcome = task.execute(node.action)
        assert (outcome.executed, outcome.result) == (node.executed, node.result)
        assert outcome.sim_seconds == node.sim_seconds
        assert task.predicates == node.predicates
        assert task.holder == next(iter(node.predicates.holders), None)
        assert task.inserted == node.inserted


def test_an_action_that_is_no_edge_changes_nothing(task, trees):
    held = next(n for n in trees["left"].nodes if n.depth == 2 and n.state)
    task.restore(held.state)
    before = task.save().physics.tobytes()
    no_edges = [a for a in Action if not task.supervisor.may_run(a, task.predicates)]
    assert len(no_edges) == 4
    for action in no_edges:
        assert not task.execute(action).executed
        assert task.save().physics.tobytes() == before


def test_each_orientation_has_its_own_presentations(trees):
    shown = {tree.shown.position for tree in trees.values()}
    shown |= {tree.shown.histogram for tree in trees.values()}
    assert len(shown) == 4


def record(out, *options):
    """The command, in a process group of its own."""
    script = ROOT / "scripts" / "record.py"
    return subprocess.Popen(
        [sys.executable, script, "--out", out, *OPTIONS, *options],
        start_new_session=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.smoke
def test_killed_and_gone_on_with_it_has_the_same_bytes(grown, tmp_path):
    """SIGKILL to all its processes, as soon as something is kept."""
    out = tmp_path / "killed"
    process = record(out, "--jobs", "1")
    until = time.monotonic() + 120
    try:
        while not list(out.glob("*-*.parquet")):
            assert process.poll() is None, process.stderr.read()
            assert time.monotonic() < until
            time.sleep(0.02)
    finally:
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    n_left = 6 * (2 - len(list(out.glob("*-*.parquet"))))
    assert n_left > 0
    process = record(out, "--jobs", "2")
    try:
        said, complained = process.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        raise
    assert process.returncode == 0, complained
    assert said == f"{out}: {n_left} actions recorded\n"
    mine, theirs = content(out), content(grown)
    for name in ("left-0000.parquet", "right-0000.parquet"):
        assert mine[name] == theirs[name]
