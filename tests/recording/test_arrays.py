"""Trees as arrays, and trials on them."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from ideal_grower import INSERTED, INSERTIONS, grown_tree, key

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.errors import RecordingError
from prospect_mj.recording import soundness
from prospect_mj.recording.arrays import UNKNOWN
from prospect_mj.recording.node_table import tabulated
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.task import RecordedTask
from prospect_mj.recording.tree import usual_actions
from prospect_mj.supervisor.supervisor import Supervisor

TREES = (("left", 0), ("left", 3), ("right", 1))


def table(depth=3):
    trees = [grown_tree(depth, *name) for name in TREES]
    return pa.concat_tables([tabulated(t, states=False) for t in trees])


def recording(nodes_table):
    return Recording.of(key(), nodes_table)


def changed(nodes_table, row, **values):
    rows = nodes_table.to_pylist()
    rows[row] |= values
    return pa.Table.from_pylist(rows, nodes_table.schema)


def test_presentations_are_the_roots_in_their_order():
    shown = recording(table()).presentations
    size = usual_actions(3) + 1
    assert shown.root.tolist() == [0, size, 2 * size]
    assert shown.lid.tolist() == [LEFT, LEFT, RIGHT]
    assert shown.number.tolist() == [0, 3, 1]
    assert shown.histogram.tolist() == [list(range(100))] * 3
    assert shown.depth.tolist() == [3, 3, 3]


def test_every_edge_leads_where_the_tree_says():
    """Also in trees that are not the first."""
    made, first = recording(table()), 0
    for name in TREES:
        tree = grown_tree(3, *name)
        for (parent, action), node in tree.children.items():
            assert made.nodes.child[first + parent, action] == first + node
        for number, node in enumerate(tree.nodes):
            row = first + number
            assert made.predicates.states[made.nodes.predicates[row]] == node.predicates
            assert made.nodes.inserted[row] == (node.predicates == INSERTED)
            assert made.nodes.depth[row] == node.depth
        first += len(tree.nodes)


def test_what_a_grasp_felt_is_padded_to_the_longest():
    """Also across trees; what was no grasp felt nothing."""
    felt, first = recording(table()).nodes.felt, 0
    assert felt.dtype == np.float32
    assert felt.shape == (len(TREES) * (usual_actions(3) + 1), 3, 2)
    for name in TREES:
        nodes = grown_tree(3, *name).nodes
        assert {len(node.felt) for node in nodes} == {0, 1, 2, 3}
        for row, node in zip(felt[first:], nodes, strict=False):
            n = len(node.felt)
            assert row[:n].tolist() == [list(sample) for sample in node.felt]
            assert np.isnan(row[n:]).all()
            assert (n == 0) == (node.action in (None, *INSERTIONS))
        first += len(nodes)


def test_a_recording_without_any_grasp_has_no_samples():
    roots = pa.concat_tables([tabulated(grown_tree(0, *name)) for name in TREES])
    assert recording(roots).nodes.felt.shape == (len(TREES), 0, 2)


def test_what_may_not_run_leads_nowhere_and_what_is_not_known_is_unknown():
    nodes = recording(table(1)).nodes
    root, left = nodes.child[0], int(nodes.child[0, Action.GRASP_LEFT])
    assert root[2:].tolist() == [0, 0, 0, 0]
    assert nodes.holding[[0, left]].tolist() == [NONE, LEFT]
    expected = [left, left, UNKNOWN, left, UNKNOWN, left]
    assert nodes.child[left].tolist() == expected


def test_a_tree_is_complete_up_to_its_first_gap():
    nodes_table = table(3)
    deepest = len(grown_tree(3).nodes) - 1
    without_last = pa.concat_tables(
        [nodes_table.slice(0, deepest), nodes_table.slice(deepest + 1)]
    )
    shown = recording(without_last).presentations
    assert shown.depth.tolist() == [2, 3, 3]
    assert recording(without_last).complete(2).tolist() == [0, 1, 2]
    assert recording(without_last).complete(3).tolist() == [1, 2]


def test_a_side_without_a_complete_tree_is_refused():
    with pytest.raises(RecordingError, match=r"lid to the left .* complete to 4"):
        recording(table(3)).complete(4)


def test_the_longest_trials_that_both_sides_have_are_named():
    parts = [
        tabulated(grown_tree(d, *n)) for d, n in zip((3, 1, 2), TREES, strict=True)
    ]
    made = recording(pa.concat_tables(parts))
    with pytest.raises(RecordingError, match="complete to 2: max_actions=2 steps it"):
        made.complete(3)
    assert made.complete(2).tolist() == [0, 2]
    lone = recording(tabulated(grown_tree(3)))
    with pytest.raises(RecordingError, match="let it grow until both sides have one"):
        lone.complete(1)


def test_an_action_that_finds_nothing_to_do_leaves_the_trial_where_it_is():
    """A jar that was lost is not seen again, however often a hand grasps for it."""
    lost = {"result": "lost", "left_holds": False, "left_place": "at rest"}
    lost |= {"jar": "unknown", "depth": 1}
    nodes_table = changed(table(1), 1, **lost)
    rows = nodes_table.to_pylist()
    again = {**rows[1], "node": 3, "parent": 1, "executed": False}
    rows.insert(3, {**again, "action": 1, "result": "not_seen", "sim_seconds": 0.0})
    found = pa.Table.from_pylist(rows, nodes_table.schema)
    soundness.check(found, Path("lost.parquet"))
    made = recording(found)
    assert made.nodes.situation.tolist()[:4] == [0, 1, 2, 1]
    task = RecordedTask(made, Supervisor(), 1)
    task.begin(1)
    outcome = task.execute(Action.GRASP_RIGHT)
    assert (outcome.executed, outcome.result) == (False, ActionResult.NOT_SEEN)
    assert task.node == 1


def test_a_trial_that_leaves_the_recording_is_told_so():
    task = RecordedTask(recording(table(2)), Supervisor(), 2)
    with pytest.raises(RecordingError, match="call reset"):
        task.execute(Action.GRASP_LEFT)
    task.reset("right", np.random.default_rng(0))
    task.execute(Action.GRASP_LEFT)
    task.execute(Action.INSERT_LEFT)
    with pytest.raises(RecordingError, match="insert-left from here was not recorded"):
        task.execute(Action.INSERT_LEFT)
