"""Outcome trees: how many edges they have, and in which order they grow."""

from collections import Counter

import pytest
from ideal_grower import INSERTED, IdealGrower, grown_tree

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording.tree import Edge, Node, usual_actions
from prospect_mj.supervisor.predicates import PRESENTED


@pytest.mark.parametrize("depth", range(1, 11))
def test_the_usual_tree_has_as_many_edges_as_fibonacci_says(depth):
    fibonacci = [0, 1]
    while len(fibonacci) < 14:
        fibonacci.append(sum(fibonacci[-2:]))
    n_edges = grown_tree(depth).n_actions
    assert n_edges == 2 * fibonacci[depth + 3] - 4
    assert n_edges == usual_actions(depth)


def test_a_trial_of_ten_actions_has_462():
    assert grown_tree(10).n_actions == 462


def test_nothing_grows_where_the_jar_is_inserted():
    tree = grown_tree(5)
    ends = {n for n, node in enumerate(tree.nodes) if node.predicates == INSERTED}
    assert ends
    assert not ends & {node.parent for node in tree.nodes}


def test_shallow_edges_come_first_and_actions_in_order():
    tree = grown_tree(6)
    depths = [node.depth for node in tree.nodes]
    assert depths == sorted(depths)
    edges = [(node.parent, node.action) for node in tree.nodes[1:]]
    assert edges == sorted(edges)


def test_open_edges_are_those_that_are_missing():
    grower = IdealGrower()
    tree = grower.plant("left", 0)
    first = [Edge(0, Action.GRASP_LEFT), Edge(0, Action.GRASP_RIGHT)]
    assert list(tree.open_edges(1)) == first
    grower.extend(tree, first[1])
    assert list(tree.open_edges(1)) == first[:1]
    assert [edge.node for edge in tree.open_edges(2)] == [0, 1, 1]
    assert not tree.is_complete(1)
    grower.extend(tree, first[0])
    assert tree.is_complete(1)
    assert not tree.is_complete(2)
    assert tree.children == {(0, Action.GRASP_RIGHT): 1, (0, Action.GRASP_LEFT): 2}


def test_only_where_something_can_grow_is_a_state_kept():
    tree = grown_tree(4)
    kept = {node.depth for node in tree.nodes if node.state is not None}
    assert kept == {4}
    assert Counter(node.state is None for node in tree.nodes if node.depth == 4) == {
        False: 8,
        True: 2,
    }


def test_an_action_that_found_nothing_to_do_is_an_edge_to_nowhere():
    """It was started, so it is recorded; the trial is where it was."""
    tree = IdealGrower().plant("left", 0)
    nothing = Node(
        parent=0,
        action=Action.GRASP_LEFT,
        executed=False,
        result=ActionResult.NOT_SEEN,
        sim_seconds=0.0,
        predicates=PRESENTED,
        inserted=False,
        depth=0,
        state=None,
    )
    tree.add(nothing)
    assert list(tree.open_edges(3)) == [Edge(0, Action.GRASP_RIGHT)]
    assert tree.nodes[0].state is not None
