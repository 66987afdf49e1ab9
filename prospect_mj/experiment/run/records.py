"""What a run remembers of each action and each trial, and the tables of it."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass

import pyarrow as pa

from prospect_mj.actions.action import Action

ACTION_NAMES = tuple(action.label for action in Action)


@dataclass(frozen=True)
class ActionRecord:
    """One action of one trial: a row of actions.parquet."""

    trial: int
    """Number of the trial in the run, from 0."""
    step: int
    """Number of the action in the trial, from 0."""
    action: int
    """Index of the action."""
    action_name: str
    """Its name."""
    explored: bool
    """Whether the choice was a random one."""
    holding: str
    """Which hand held the jar when the action was chosen: none, left or right."""
    q_values: tuple[float, ...]
    """(6,) [actions], the learner's estimates when the action was chosen."""
    executed: bool
    """Whether the supervisor let the action run."""
    result: str
    """The environment's word for what came of it."""
    next_holding: str
    """Which hand holds the jar afterwards."""
    reward: float
    """[actions]."""
    sim_seconds: float
    """Simulated duration [s]."""
    inserted: bool
    """Whether the jar stands in the well, base first, afterwards."""


@dataclass(frozen=True)
class TrialRecord:
    """One trial: a row of trials.parquet."""

    trial: int
    """Number of the trial in the run, from 0."""
    orientation: str
    """Side on which the lid lay: left or right."""
    pretraining: bool
    """Whether the trial belongs to the pretraining."""
    look: str
    """The environment's word for what the first look gave."""
    n_actions: int
    """Actions taken."""
    solved: bool
    """Whether the jar was inserted."""
    sim_seconds: float
    """Simulated duration of its actions [s]."""


# "element" is Parquet's name, so that a table read back is written in the same bytes.
_Q_VALUES = pa.list_(pa.field("element", pa.float64()), len(ACTION_NAMES))

ACTION_SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "step": pa.int16(),
        "action": pa.int8(),
        "action_name": pa.string(),
        "explored": pa.bool_(),
        "holding": pa.string(),
        "q_values": _Q_VALUES,
        "executed": pa.bool_(),
        "result": pa.string(),
        "next_holding": pa.string(),
        "reward": pa.float64(),
        "sim_seconds": pa.float64(),
        "inserted": pa.bool_(),
    }
)

TRIAL_SCHEMA = pa.schema(
    {
        "trial": pa.int32(),
        "orientation": pa.string(),
        "pretraining": pa.bool_(),
        "look": pa.string(),
        "n_actions": pa.int16(),
        "solved": pa.bool_(),
        "sim_seconds": pa.float64(),
    }
)


def action_table(records: Sequence[ActionRecord]) -> pa.Table:
    """Tabulate actions under `ACTION_SCHEMA`."""
    return pa.Table.from_pylist(
        [asdict(record) for record in records], schema=ACTION_SCHEMA
    )


def trial_table(records: Sequence[TrialRecord]) -> pa.Table:
    """Tabulate trials under `TRIAL_SCHEMA`."""
    return pa.Table.from_pylist(
        [asdict(record) for record in records], schema=TRIAL_SCHEMA
    )
