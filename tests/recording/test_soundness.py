"""Tables that are whole and make no sense are refused, each for its own reason."""

from pathlib import Path

import pyarrow as pa
import pytest
from ideal_grower import grown_tree

from prospect_mj.errors import RecordingError
from prospect_mj.recording import soundness
from prospect_mj.recording.node_table import tabulated

TREES = (("left", 0), ("left", 3), ("right", 1))
PATH = Path("some.parquet")
FIRST, NODE, LAST = 0, 2, 12
"""Rows: a root, the node that a grasp with the right hand led to, and one where nothing
follows: that hand has tried to insert the wrong way round, twice."""


def table():
    trees = [grown_tree(3, *name) for name in TREES]
    parts = [tabulated(tree, states=False) for tree in trees]
    return pa.concat_tables(parts).drop_columns(["state"])


def changed(row, **values):
    whole = table()
    rows = whole.to_pylist()
    rows[row] |= values
    return pa.Table.from_pylist(rows, whole.schema)


def shown(**values):
    return table()["shown"][FIRST].as_py() | values


def felt(**values):
    """What a grasp felt, with one sample changed."""
    samples = table()["felt"][NODE].as_py()
    return [*samples, samples[0] | values]


def test_what_was_recorded_is_sound():
    soundness.check(table(), PATH)
    for depth in (0, 3):
        soundness.check(tabulated(grown_tree(depth)), PATH)


@pytest.mark.parametrize(
    "name", [name for name in table().column_names if name != "shown"]
)
def test_a_missing_value_is_noticed(name):
    with pytest.raises(RecordingError, match=f"{name} is missing"):
        soundness.check(changed(NODE, **{name: None}), PATH)


@pytest.mark.parametrize(
    ("row", "values", "words"),
    [
        (FIRST, {"shown": None}, "shown is missing, or where it can't be"),
        (FIRST, {"parent": 0}, "parent is missing, or where it can't be"),
        (NODE, {"shown": shown()}, "shown is missing, or where it can't be"),
        (NODE, {"jar": "nowhere"}, "jar is 'nowhere'"),
        (NODE, {"left_place": ""}, "left_place is ''"),
        (NODE, {"result": "flew"}, "result is 'flew'"),
        (FIRST, {"orientation": "up"}, "orientation is 'up'"),
        (NODE, {"action": 6}, "action is out of its range"),
        (NODE, {"action": -1}, "action is out of its range"),
        (NODE, {"parent": -5}, "parent is out of its range"),
        (NODE, {"depth": -1}, "depth is out of its range"),
        (NODE, {"sim_seconds": float("nan")}, "sim_seconds is out of its range"),
        (NODE, {"sim_seconds": float("inf")}, "sim_seconds is out of its range"),
        (NODE, {"sim_seconds": -1.0}, "sim_seconds is out of its range"),
        (NODE, {"orientation": "right"}, "orientation changes within a tree"),
        (NODE, {"presentation": 9}, "presentation changes within a tree"),
        (NODE, {"action": 0}, "an action leads from a node to two others"),
        (FIRST, {"executed": False}, "a root is more than a presentation"),
        (FIRST, {"inserted": True}, "a root is more than a presentation"),
        (FIRST, {"depth": 1}, "a root is more than a presentation"),
        (FIRST, {"sim_seconds": 1.0}, "a root is more than a presentation"),
        (FIRST, {"left_place": "astray"}, "no trial begins with left empty astray"),
        (FIRST, {"shown": shown(look=None)}, "look is 'None'"),
        (FIRST, {"shown": shown(look="glimpsed")}, "look is 'glimpsed'"),
        (FIRST, {"shown": shown(yaw=None)}, "a presentation is not whole"),
        (FIRST, {"shown": shown(position=None)}, "a presentation is not whole"),
        (FIRST, {"shown": shown(lamp_gain=float("nan"))}, "a presentation is not"),
        (NODE, {"node": 4}, "a tree is not whole"),
        (NODE, {"parent": 2}, "a tree is not whole"),
        (NODE, {"depth": 2}, "a depth does not fit"),
        (NODE, {"inserted": True}, "a node follows one where nothing grows"),
        (LAST, {"executed": False, "depth": 2}, "executed does not fit the result"),
        (LAST, {"result": "not_seen"}, "executed does not fit the result"),
        (LAST, {"inserted": True}, "a jar is inserted and held"),
        (LAST, {"result": "lost"}, "insert-right can't end in lost: "),
        (LAST, {"right_place": "at rest"}, "insert-right can't end in jammed: "),
        (NODE, {"action": 5}, "insert-right may not run from: left empty at rest"),
        (NODE, {"felt": [None]}, "a grasp's trajectory is not whole"),
        (NODE, {"felt": felt(seconds=None)}, "a grasp's trajectory is not one of"),
        (NODE, {"felt": felt(residual=None)}, "a grasp's trajectory is not one of"),
        (NODE, {"felt": felt(seconds=-0.1)}, "a grasp's trajectory is not one of"),
        (NODE, {"felt": felt(residual=-0.1)}, "a grasp's trajectory is not one of"),
        (NODE, {"felt": felt(residual=float("nan"))}, "a grasp's trajectory is not"),
        (FIRST, {"shown": shown(histogram=[1] * 99)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[-1] * 100)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[])}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[None] * 100)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=None)}, "a histogram is not whole"),
    ],
)
def test_nonsense_is_noticed(row, values, words):
    with pytest.raises(RecordingError, match=f"some.parquet is damaged: {words}"):
        soundness.check(changed(row, **values), PATH)


def test_a_tree_that_is_there_twice_is_noticed():
    with pytest.raises(RecordingError, match="a presentation is there twice"):
        soundness.check(pa.concat_tables([table(), table()]), PATH)


def test_a_table_without_a_root_is_noticed():
    with pytest.raises(RecordingError, match="its first node is no root"):
        soundness.check(table().slice(1), PATH)
