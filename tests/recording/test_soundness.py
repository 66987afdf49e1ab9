"""Tables that are whole and make no sense are refused, each for its own reason."""

import pyarrow as pa
import pytest
from ideal_grower import grown_tree

from prospect_mj.errors import RecordingError
from prospect_mj.recording import soundness
from prospect_mj.recording.node_table import tabulated

TREES = (("left", 0), ("left", 3), ("right", 1))
FIRST, NODE = 0, 2
"""Rows: a root, and a node that an action led to."""


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


def test_what_was_recorded_is_sound():
    soundness.check(table())


@pytest.mark.parametrize(
    "name", [name for name in table().column_names if name != "shown"]
)
def test_a_missing_value_is_noticed(name):
    with pytest.raises(RecordingError, match=f"{name} is missing|first node"):
        soundness.check(changed(NODE, **{name: None}))


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
        (FIRST, {"shown": shown(histogram=[1] * 99)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[-1] * 100)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[])}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=[None] * 100)}, "a histogram is not whole"),
        (FIRST, {"shown": shown(histogram=None)}, "a histogram is not whole"),
    ],
)
def test_nonsense_is_noticed(row, values, words):
    with pytest.raises(RecordingError, match=f"damaged: {words}"):
        soundness.check(changed(row, **values))


def test_a_tree_that_is_there_twice_is_noticed():
    with pytest.raises(RecordingError, match="a presentation is there twice"):
        soundness.check(pa.concat_tables([table(), table()]))


def test_a_table_without_a_root_is_noticed():
    with pytest.raises(RecordingError, match="its first node is no root"):
        soundness.check(table().slice(1))
