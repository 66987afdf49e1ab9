"""The columns of a recording's tables: one row per node of a tree."""

import pyarrow as pa

from prospect_mj.robot.names import SIDES

# "element" is Parquet's name, so that a table read back is written in the same bytes.
_NUMBERS = pa.list_(pa.field("element", pa.float64()))

STATE = pa.struct(
    {
        "physics": _NUMBERS,
        "seen": _NUMBERS,
        "cradle": _NUMBERS,
        "inserted": _NUMBERS,
        **{f"held_{side}": _NUMBERS for side in SIDES},
    }
)
"""MuJoCo's integration state (n,); position and axis (6,) of a jar that was seen;
quaternion wxyz and position (7,) of a jar that was inserted or is held. All but the
first are null where the robot believes no such thing."""

_SHOWN = pa.struct(
    {
        "position": pa.list_(pa.field("element", pa.float64()), 3),
        "yaw": pa.float64(),
        "lamp_gain": pa.float64(),
        "look": pa.string(),
        "histogram": pa.list_(pa.field("element", pa.int32())),
    }
)

FELT = pa.list_(
    pa.field("element", pa.struct({"seconds": pa.float32(), "residual": pa.float32()}))
)
"""What a grasp's contacts were like in every control period in which all three
fingertips touched: time since the hand closes [s], and how far from balance [1]."""

SCHEMA = pa.schema(
    {
        "orientation": pa.string(),
        "presentation": pa.int32(),
        "node": pa.int32(),
        "parent": pa.int32(),
        "action": pa.int8(),
        "executed": pa.bool_(),
        "result": pa.string(),
        "sim_seconds": pa.float64(),
        "inserted": pa.bool_(),
        "depth": pa.int8(),
        "left_holds": pa.bool_(),
        "left_place": pa.string(),
        "right_holds": pa.bool_(),
        "right_place": pa.string(),
        "jar": pa.string(),
        "shown": _SHOWN,
        "felt": FELT,
        "state": STATE,
    }
)
"""`state` is null where nothing grows on, or where it was left out."""
OUTCOMES = tuple(name for name in SCHEMA.names if name != "state")
"""All columns but the states."""
NOT_AT_ROOTS = ("parent", "action", "result")
"""Columns that are null at a root, and nowhere else."""
ROOTS_ONLY = ("shown",)
"""Columns that are null everywhere else."""
