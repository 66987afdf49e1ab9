"""The optimum by dynamic programming against all sequences, one by one."""

from itertools import product

import numpy as np
import pytest
from ideal_recording import clumsy, ideal, one_handed, recording, unseen

from prospect_mj.errors import RecordingError
from prospect_mj.experiment.populations.kernels.graph import Graph
from prospect_mj.experiment.populations.optimum import (
    BySide,
    fewest_actions,
    optimal_strategy_alone,
    optimum,
)
from prospect_mj.experiment.populations.outcome_graph import recorded_graph
from prospect_mj.recording.recording import Recording
from prospect_mj.supervisor.supervisor import Supervisor


def by_brute_force(graph, node, max_actions):
    """Fewest actions over every sequence of the allowed ones."""
    fewest = max_actions
    for sequence in product(range(6), repeat=max_actions):
        here = node
        for taken, action in enumerate(sequence, 1):
            if not graph.choices[-1, graph.state[here], action]:
                break
            here = graph.situation[graph.child[here, action]]
            if graph.inserted[here]:
                fewest = min(fewest, taken)
                break
    return fewest


def random_graph(rng, n=14):
    """Any node may lead to any; some actions may not be chosen."""
    choices = rng.random((2, 3, 6)) < 0.5
    choices[:, :, 0] = True
    inserted = rng.random(n) < 0.15
    inserted[0] = False
    return Graph(
        child=np.where(rng.random((n, 6)) < 0.3, rng.integers(n, size=(n, 6)), 0),
        situation=np.arange(n),
        inserted=inserted,
        holding=np.zeros(n, np.int64),
        haptic=np.zeros(n, np.int64),
        state=rng.integers(3, size=n),
        choices=choices,
    )


def test_dynamic_programming_finds_what_brute_force_finds():
    rng, found = np.random.default_rng(2), []
    for _ in range(12):
        graph = random_graph(rng)
        fewest = fewest_actions(graph, 4)
        assert fewest[0] == by_brute_force(graph, 0, 4)
        found.append(fewest[0])
    assert {2.0, 4.0} < set(found)


def by_enumeration(graph, node, left, epsilon):
    """The least expected actions of who explores, by trying all that can happen."""
    if graph.inserted[node] or not left:
        return 0.0
    follows = [
        by_enumeration(graph, graph.situation[graph.child[node, a]], left - 1, epsilon)
        for a in np.flatnonzero(graph.choices[-1, graph.state[node]])
    ]
    return 1 + (1 - epsilon) * min(follows) + epsilon * np.mean(follows)


@pytest.mark.parametrize("epsilon", [0.05, 0.6, 1.0])
def test_exploring_costs_what_enumeration_finds(epsilon):
    rng = np.random.default_rng(3)
    for _ in range(6):
        graph = random_graph(rng)
        found = fewest_actions(graph, 4, epsilon=epsilon)[0]
        assert found == pytest.approx(by_enumeration(graph, 0, 4, epsilon))
        assert found >= fewest_actions(graph, 4)[0] - 1e-12


def test_exploring_in_the_ideal_task_by_hand():
    # Two actions left: a grasp by the lid's hand, then the insertion, or neither.
    shown = recording(2, left=(ideal,), right=(ideal,))
    assert optimum(shown, max_actions=2, epsilon=0.6).exploring.mean == 2.0
    # Three: solved by the second with (0.4 + 0.1)^2, as a sixth of all exploring is it.
    shown = recording(3, left=(ideal,), right=(ideal,))
    three = optimum(shown, max_actions=3, epsilon=0.6).exploring.mean
    assert three == pytest.approx(3 - 0.5**2)
    assert optimum(shown, max_actions=3, epsilon=0.0).exploring.mean == 2.0


@pytest.mark.parametrize(
    ("kind", "fewest"),
    # Without a swap only the right first grasp is left; the hand on the lid's side that
    # can't lift the jar is handed it by the other one; a jar that isn't seen stays.
    [(ideal, 2), (clumsy, 2), (one_handed, 3), (unseen, 6)],
)
def test_best_case_of_each_kind_of_presentation(kind, fewest):
    best = optimum(recording(6, left=(kind,), right=(kind,)), max_actions=6)
    assert best.actions == BySide(fewest, fewest)


def test_mean_over_presentations_and_both_sides():
    mixed = recording(6, left=(ideal, ideal, one_handed, one_handed), right=(unseen,))
    best = optimum(mixed, max_actions=6)
    assert best.actions == BySide(left=2.5, right=6.0)
    assert best.actions.mean == 4.25


def test_the_optimal_strategy_is_the_best_where_the_lids_hand_can_do_it_alone():
    # What can't be solved is not solved by it either; where only the other hand can
    # lift the jar, it takes a nonradial grasp and a swap.
    mixed = recording(6, left=(ideal, clumsy, one_handed, unseen), right=(one_handed,))
    best = optimum(mixed, max_actions=6)
    assert best.optimal == BySide(left=0.5, right=0.0)


def test_a_last_action_that_solves_a_trial_is_told_from_none():
    shown = recording(2, left=(ideal, unseen), right=(ideal,))
    best = optimum(shown, max_actions=2)
    assert best.actions == BySide(2.0, 2.0)
    assert best.optimal == BySide(0.5, 1.0)


def test_alone_the_optimal_strategy_begins_with_its_hand_and_never_swaps():
    shown = recording(4, left=(ideal,), right=(ideal,))
    graph = recorded_graph(shown, Supervisor())
    root, lid = shown.presentations.root, shown.presentations.lid
    alone = optimal_strategy_alone(graph, root, lid)
    changed = np.argwhere(alone.child != graph.child)
    first = {(int(node), int(action)) for node, action in changed if node in root}
    assert first == {(int(root[0]), 1), (int(root[1]), 0)}
    later = {int(action) for node, action in changed if node not in root}
    assert later == {2, 3}
    np.testing.assert_array_equal(
        alone.child[changed[:, 0], changed[:, 1]], changed[:, 0]
    )


def test_a_supervisor_can_cost_nothing_where_it_forbids_the_useless_only():
    shown = recording(6, left=(one_handed,), right=(ideal,))
    for mode in ("safe", "productive"):
        assert optimum(shown, Supervisor(mode), 6).actions == BySide(3.0, 2.0)
    # Its shaping counts as lifted.
    shaped = Supervisor("none", ("swap-right-to-left:50",))
    assert optimum(shown, shaped, 6).actions == BySide(3.0, 2.0)


def test_incomplete_presentations_are_left_out():
    shallow = recording(3, left=(ideal,), right=(ideal,))
    assert optimum(shallow, max_actions=3).actions.mean == 2.0
    with pytest.raises(RecordingError, match="complete to 4 executed actions"):
        optimum(shallow, max_actions=4)


def test_what_is_not_known_counts_as_nothing():
    graph = random_graph(np.random.default_rng(0))
    graph.child[0] = -1
    assert fewest_actions(graph, 3)[0] == np.inf


def test_in_real_physics_the_optimal_strategy_always_takes_two_actions():
    best = optimum(Recording.load())
    assert (best.actions, best.optimal) == (BySide(2.0, 2.0), BySide(1.0, 1.0))
    # What exploring costs: 4 % of an action, where every wrong grasp cost one or two.
    assert 2.05 < best.exploring.mean < 2.2
