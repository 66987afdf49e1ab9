"""Grasps and outcomes made by hand, of which each end feels as it is told to."""

from types import SimpleNamespace

import numpy as np

from prospect_mj.actions.action import Action
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.experiment.development.haptics.grasp import (
    CRADLE,
    HAND_OVER,
    LID,
    Grasp,
)
from prospect_mj.recording.hands import GRASPS, SWAPS
from prospect_mj.recording.recording import Recording
from prospect_mj.robot.names import SIDES, other

SECONDS = np.array([0.30, 0.32, 0.34])
BODY_FEELS, LID_FEELS = 0.006, 0.013


def felt(residual: float, later: float = 0.0) -> np.ndarray:
    """(3, 2): a residual that stays; `later` is the hand's closing time [s]."""
    return np.column_stack([SECONDS + later, np.full(3, residual)]).astype(np.float32)


def grasps(
    per_side: int,
    rng: np.random.Generator,
    lid: float = LID_FEELS,
    deviation: float = 2e-4,
) -> list[Grasp]:
    """Both hands' grasps and hand-overs; the lid feels by the residual given."""
    made = []
    for side in SIDES:
        for number in range(per_side):
            for hand in SIDES:
                for kind, holder in ((CRADLE, hand), (HAND_OVER, other(hand))):
                    grasp = Grasp(side, number, holder, kind, felt(0.0))
                    at_lid = grasp.end == LID
                    residual = rng.normal(lid if at_lid else BODY_FEELS, deviation)
                    path = felt(residual, 0.0 if at_lid else 0.08)
                    made.append(grasp._replace(felt=path))
    return made


def recording() -> Recording:
    """Two presentations, lid left and lid right, with all that can follow a grasp.

    Each tree: 0 root; 1 left hand grasps; 2 right hand grasps; 3 the left hand's
    insertion; 4 hand-over of that to the right; 5 a hand-over that failed, after 3; 6
    hand-over back, after 4; 7 the grasp that found no jar, at the root.
    """
    trees = [_tree(lid) for lid in (LEFT, RIGHT)]
    n = len(trees[0].holding)
    child = np.concatenate(
        [
            np.where(tree.child < 0, -1, tree.child + n * i)
            for i, tree in enumerate(trees)
        ]
    )
    names = "holding", "depth", "result", "felt"
    parts = {name: np.concatenate([vars(t)[name] for t in trees]) for name in names}
    shown = SimpleNamespace(
        root=np.array([0, n], np.int32),
        lid=np.array([LEFT, RIGHT], np.int8),
        number=np.zeros(2, np.int32),
    )
    nodes = SimpleNamespace(child=child, **parts)
    return Recording(None, nodes, shown, None)


def _tree(lid: int) -> SimpleNamespace:
    child = np.full((8, len(Action)), -1, np.int32)
    child[0, [GRASPS[LEFT], GRASPS[RIGHT], SWAPS[LEFT]]] = 1, 2, 7
    child[1, [Action.INSERT_LEFT, SWAPS[RIGHT]]] = 3, 1
    child[3, [SWAPS[LEFT], SWAPS[RIGHT]]] = 4, 5
    child[4, SWAPS[RIGHT]] = 6
    holding = np.array([NONE, LEFT, RIGHT, LEFT, RIGHT, LEFT, LEFT, NONE], np.int8)
    results = ["", *2 * ["success"], "jammed", "success", "not_grasped", "success"]
    path = np.full((8, 3, 2), np.nan, np.float32)
    for node in (1, 2, 4, 6):
        path[node] = felt(LID_FEELS if holding[node] == lid else BODY_FEELS)
    # What the taker felt in vain: the giver still holds the jar as before.
    path[5] = felt(0.03)
    return SimpleNamespace(
        child=child,
        holding=holding,
        depth=np.array([0, 1, 1, 2, 2, 3, 3, 0], np.int8),
        result=np.array([*results, "not_seen"]),
        felt=path,
    )
