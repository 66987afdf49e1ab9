"""A grasp of the study: who grasped what, and what it felt like."""

from collections.abc import Iterable
from typing import Literal, NamedTuple, get_args

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from prospect_mj.haptics import phase_samples
from prospect_mj.robot.names import Side
from prospect_mj.task.presentation import Orientation

Kind = Literal["out of the cradle", "hand-over"]
KINDS = CRADLE, HAND_OVER = get_args(Kind)

BODY, LID = 0, 1
"""The end of the jar that is held."""

SCHEMA = pa.schema(
    {
        "orientation": pa.string(),
        "presentation": pa.int32(),
        "hand": pa.string(),
        "kind": pa.string(),
        "seconds": pa.list_(pa.float32()),
        "residual": pa.list_(pa.float32()),
    }
)
"""A grasp; time since the hand closes [s] and residual [1] of its samples."""


class Grasp(NamedTuple):
    """A grasp that held."""

    orientation: Orientation
    """Side of the lid."""
    presentation: int
    """Number among those of the same side."""
    hand: Side
    kind: Kind
    felt: NDArray[np.float32]
    """(m, 2): time since the hand closes [s] and residual [1] of its samples."""

    @property
    def end(self) -> int:
        """Which end the hand holds, BODY or LID: a hand holds the end at its side."""
        return LID if self.hand == self.orientation else BODY

    @property
    def samples(self) -> NDArray[np.float64]:
        """(m, 3): residual [1], rate [1/s] and number of the probe."""
        return phase_samples(self.felt)


def table(grasps: Iterable[Grasp]) -> pa.Table:
    """Grasps as a table under `SCHEMA`."""
    rows = []
    for grasp in grasps:
        seconds, residual = grasp.felt.T.tolist()
        row = grasp._asdict() | {"seconds": seconds, "residual": residual}
        rows.append({name: row[name] for name in SCHEMA.names})
    return pa.Table.from_pylist(rows, schema=SCHEMA)


def of_table(rows: pa.Table) -> list[Grasp]:
    """The grasps of a table under `SCHEMA`."""
    return [
        Grasp(
            row["orientation"],
            row["presentation"],
            row["hand"],
            row["kind"],
            np.column_stack([row["seconds"], row["residual"]]).astype(np.float32),
        )
        for row in rows.to_pylist()
    ]
