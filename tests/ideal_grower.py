"""Trees of a jar that every action does what it is named for to, without physics."""

import functools
from pathlib import Path

import numpy as np
import pytest

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.recording import growth
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.live_physics import LivePhysics
from prospect_mj.recording.tree import Edge, Node, OutcomeTree, Shown
from prospect_mj.robot.names import other
from prospect_mj.supervisor.predicates import (
    AT_REST,
    PRESENTED,
    Jar,
    PredicateState,
    carrying,
)
from prospect_mj.task.trial_state import TrialState

INSERTED = PredicateState(AT_REST, AT_REST, Jar.INSERTED)
SECONDS = 5.5
FELT = ((0.25, 2.0), (0.5, 0.125), (0.75, 0.0625))
"""Of a grasp; exact in single precision."""
INSERTIONS = (Action.INSERT_LEFT, Action.INSERT_RIGHT)


def key(**settings) -> RecordingKey:
    digests = {"models/torso.xml": "ab", "sources": "cd", "world": "ef"}
    versions = {"mujoco": "3.17.0", "numpy": "2.4.6"}
    return RecordingKey(RecordingConfig(**settings), digests, versions, {})


def trial_state(physics: np.ndarray, predicates: PredicateState) -> TrialState:
    seen = SeenJar(physics[:3], physics[3:6])
    return TrialState(physics, Belief(seen=seen), predicates)


class IdealTask:
    def save(self) -> TrialState:
        return trial_state(np.zeros(8), PRESENTED)


class IdealGrower:
    """Like `grower.Grower`; outcomes follow from the restored state."""

    n_run = 0
    n_made = 0

    def __init__(self, config: RecordingConfig | None = None) -> None:
        IdealGrower.n_made += 1
        self.task = IdealTask()

    def close(self) -> None:
        self.task = None

    def plant(self, orientation, number) -> OutcomeTree:
        physics = np.sin(np.arange(8.0) + number)
        state = trial_state(physics, PRESENTED)
        root = Node(None, None, True, None, 0.0, PRESENTED, False, 0, state)
        shown = Shown((0.1, 0.2, 0.3), 0.1, 1.0, "found", tuple(range(100)))
        return OutcomeTree(orientation, number, shown, [root])

    def extend(self, tree: OutcomeTree, edge: Edge) -> None:
        IdealGrower.n_run += 1
        start = tree.nodes[edge.node]
        physics = np.sin(7.0 * start.state.physics + edge.action)
        result, predicates = self.led_to(tree, start, edge.action)
        inserted = predicates == INSERTED
        state = None if inserted else trial_state(physics, predicates)
        depth = start.depth + 1
        tree.add(
            Node(
                edge.node,
                edge.action,
                True,
                result,
                SECONDS,
                predicates,
                inserted,
                depth,
                state,
                felt=() if edge.action in INSERTIONS else FELT[: 1 + depth % 3],
            )
        )

    def led_to(self, tree, start, action) -> tuple[ActionResult, PredicateState]:
        hand = "left" if action.name.endswith("LEFT") else "right"
        if action in INSERTIONS:
            if hand == tree.orientation:
                return ActionResult.SUCCESS, INSERTED
            return ActionResult.JAMMED, start.predicates
        if action in (Action.SWAP_LEFT_TO_RIGHT, Action.SWAP_RIGHT_TO_LEFT):
            assert start.predicates.holders == (other(hand),)
        return ActionResult.SUCCESS, carrying(hand)


def grown_tree(depth: int, orientation="left", number=0) -> OutcomeTree:
    grower = IdealGrower()
    tree = grower.plant(orientation, number)
    for edge in tree.open_edges(depth):
        grower.extend(tree, edge)
    return tree


def grow_ideally(monkeypatch: pytest.MonkeyPatch) -> type[IdealGrower]:
    """Let trees grow without physics, in this process; counts the actions run."""
    grow_with(monkeypatch, IdealGrower)
    monkeypatch.setattr(IdealGrower, "n_run", 0)
    monkeypatch.setattr(IdealGrower, "n_made", 0)
    return IdealGrower


def grow_with(monkeypatch: pytest.MonkeyPatch, make: type[IdealGrower]) -> None:
    """Let trees grow on something else than physics, in this process."""
    physics = functools.cache(lambda key: LivePhysics(key.config, make))
    monkeypatch.setattr(growth, "_physics", physics)


def content(folder: Path) -> dict[str, bytes | None]:
    """The bytes of every file below a folder, by path; None for a folder."""
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        if path.is_file()
        else None
        for path in folder.rglob("*")
    }
