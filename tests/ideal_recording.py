"""Small recordings made by hand: each is a table as physics would have written it."""

from collections import deque

import numpy as np
import pyarrow as pa
from ideal_env import counts_per_orientation

from prospect_mj.actions.action import Action
from prospect_mj.recording import arrays
from prospect_mj.recording.config import RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.schema import SCHEMA
from prospect_mj.supervisor.predicates import (
    AT_REST,
    NOTHING_SEEN,
    PRESENTED,
    Jar,
    PredicateState,
    carrying,
)
from prospect_mj.supervisor.supervisor import Supervisor

INSERTED = PredicateState(AT_REST, AT_REST, Jar.INSERTED)
HAND = {0: "left", 1: "right", 2: "left", 3: "right", 4: "left", 5: "right"}
OTHER = {"left": "right", "right": "left"}


def ideal(state, action, lid):
    """Result and next state: what can succeed does, the wrong insertion jams."""
    hand = HAND[action]
    if action <= Action.GRASP_RIGHT:
        return "success", carrying(hand)
    if action <= Action.SWAP_RIGHT_TO_LEFT:
        return "success", carrying(OTHER[hand])
    return ("success", INSERTED) if hand == lid else ("jammed", state)


def clumsy(state, action, lid):
    """No hand can take the jar out of the other."""
    if action in (Action.SWAP_LEFT_TO_RIGHT, Action.SWAP_RIGHT_TO_LEFT):
        return "not_grasped", state
    return ideal(state, action, lid)


def one_handed(state, action, lid):
    """Only the hand opposite to the lid can lift the jar out of the cradle."""
    if action <= Action.GRASP_RIGHT and HAND[action] == lid:
        return "not_grasped", state
    return ideal(state, action, lid)


def unseen(state, action, lid):
    """The look found nothing, and so does every grasp."""
    return "not_seen", state


def recording(depth=10, **outcomes):
    """A recording with the given outcomes, such as `left=(ideal, clumsy)`."""
    rows = []
    rng = np.random.default_rng(5)
    for lid, kinds in outcomes.items():
        for number, outcome in enumerate(kinds):
            jitter = np.abs(1 + 0.1 * rng.standard_normal(100))
            counts = np.rint(1000 * counts_per_orientation()[lid] * jitter)
            if outcome is unseen:
                counts = np.zeros(100)
            rows += tree(lid, number, outcome, counts, depth)
    table = pa.Table.from_pylist(rows, SCHEMA).combine_chunks()
    states, number = arrays.predicate_states(table)
    nodes = arrays.nodes(table, states, number)
    shown = arrays.presentations(table, nodes)
    return Recording(RecordingKey(RecordingConfig(), {}, {}, {}), nodes, shown, states)


def tree(lid, number, outcome, counts, depth):
    """The rows of one presentation's tree, breadth first."""
    state = NOTHING_SEEN if outcome is unseen else PRESENTED
    root = row(lid, number, 0, state, executed=True, depth=0)
    look = {"look": "found", "histogram": counts.astype(int).tolist()}
    root["shown"] = {"position": [0.0, 0.0, 0.0], "yaw": 0.0, "lamp_gain": 1.0, **look}
    rows, queue, supervisor = [root], deque([(0, state)]), Supervisor()
    while queue:
        parent, before = queue.popleft()
        for action in Action:
            deep = rows[parent]["depth"] >= depth
            if deep or not supervisor.may_run(action, before):
                continue
            result, after = outcome(before, action, lid)
            ran = result != "not_seen"
            rows.append(row(lid, number, len(rows), after, executed=ran, result=result))
            edge = {"parent": parent, "depth": rows[parent]["depth"] + ran}
            rows[-1].update(edge, action=int(action))
            if ran and after != INSERTED:
                queue.append((len(rows) - 1, after))
    return rows


def row(lid, number, node, state, **others):
    """One node's row."""
    return {
        "orientation": lid,
        "presentation": number,
        "node": node,
        "sim_seconds": 5.0,
        "inserted": state == INSERTED,
        "left_holds": state.left.holding,
        "left_place": str(state.left.place),
        "right_holds": state.right.holding,
        "right_place": str(state.right.place),
        "jar": str(state.jar),
        "felt": [],
        **others,
    }
