"""A state goes through a file bit by bit, whatever is in it."""

import mink
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.recording.schema import STATE
from prospect_mj.recording.state_codec import state_of_row, state_row
from prospect_mj.supervisor.predicates import PRESENTED
from prospect_mj.task.trial_state import TrialState

# A NaN with a payload, a negative zero, the smallest and the largest number.
ODD = np.array([np.nan, -0.0, 5e-324, np.finfo(float).max, -np.inf, 0.1])
ODD.view(np.uint64)[0] |= 0xBEEF

SEEN = SeenJar(np.array([0.1, -0.0, 1 / 3]), np.array([0.0, 1.0, 5e-324]))
POSE = mink.SE3(np.array([1.0, 1e-17, -0.0, 0.0, 0.1, 0.2, 0.3]))
OTHER_POSE = mink.SE3(np.array([0.6, 0.8, 0.0, 0.0, -1.0, 2.0, 1 / 7]))

BELIEFS = {
    "nothing": Belief(),
    "seen": Belief(seen=SEEN),
    "left holds": Belief(cradle=SEEN, held={"left": POSE}),
    "right holds": Belief(cradle=SEEN, held={"right": OTHER_POSE}),
    "both hold": Belief(cradle=SEEN, held={"left": POSE, "right": OTHER_POSE}),
    "inserted": Belief(cradle=SEEN, inserted=POSE),
    "lost": Belief(cradle=SEEN),
}


def through_parquet(row):
    stream = pa.BufferOutputStream()
    pq.write_table(pa.table({"state": pa.array([row], STATE)}), stream)
    return pq.read_table(stream.getvalue())["state"].to_pylist()[0]


def bits(array):
    return None if array is None else np.asarray(array, float).tobytes()


def plain(belief):
    """All that is in a belief, as bytes."""
    seen = [
        jar and (bits(jar.position), bits(jar.axis))
        for jar in (belief.seen, belief.cradle)
    ]
    held = {side: bits(pose.wxyz_xyz) for side, pose in belief.held.items()}
    return seen, belief.inserted and bits(belief.inserted.wxyz_xyz), held


@pytest.mark.parametrize("belief", BELIEFS.values(), ids=BELIEFS.keys())
def test_every_bit_comes_back(belief):
    state = TrialState(ODD, belief, PRESENTED)
    back = state_of_row(through_parquet(state_row(state)), PRESENTED)
    assert bits(back.physics) == bits(ODD)
    assert plain(back.belief) == plain(belief)
    assert back.predicates == PRESENTED


def test_beliefs_that_differ_have_rows_that_differ():
    rows = {repr(state_row(TrialState(ODD, b, PRESENTED))) for b in BELIEFS.values()}
    assert len(rows) == len(BELIEFS)
