import numpy as np
import pytest
from ideal_grower import grown_tree

from prospect_mj import tables
from prospect_mj.recording.node_table import tabulated, tree_of
from prospect_mj.recording.schema import SCHEMA


def test_a_tree_comes_back_from_its_table_and_grows_on():
    tree = grown_tree(3, "right", 7)
    back = tree_of(tabulated(tree))
    assert back.name == ("right", 7)
    assert back.shown == tree.shown
    assert back.children == tree.children
    assert list(back.open_edges(5)) == list(tree.open_edges(5))
    for node, was in zip(back.nodes, tree.nodes, strict=True):
        assert (node.state is None) == (was.state is None)
        for name in vars(was).keys() - {"state"}:
            assert getattr(node, name) == getattr(was, name)
        if was.state is not None:
            np.testing.assert_array_equal(node.state.physics, was.state.physics)


def test_a_tree_read_back_is_written_in_the_same_bytes(tmp_path):
    first = tables.parquet(tabulated(grown_tree(3)), "origin")
    path = tmp_path / "tree.parquet"
    path.write_bytes(first)
    again = tree_of(tables.read(path, SCHEMA, "origin", "recording"))
    assert tables.parquet(tabulated(again), "origin") == first


def test_a_table_without_states_says_the_same_of_everything_else():
    tree = grown_tree(3)
    whole, packed = tabulated(tree), tabulated(tree, states=False)
    assert whole["state"].null_count < len(tree.nodes)
    assert packed["state"].null_count == len(tree.nodes)
    assert packed.drop_columns(["state"]) == whole.drop_columns(["state"])


@pytest.mark.parametrize("name", ["parent", "action", "result"])
def test_only_a_root_was_led_to_by_nothing(name):
    column = tabulated(grown_tree(2))[name]
    assert column[0].as_py() is None
    assert column.null_count == 1
