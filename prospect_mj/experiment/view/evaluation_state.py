"""What the finished trials of an evaluation have left in its folder.

The table of actions is written first and that of trials last: the trials that are in
the second are finished, and all of their actions are in the first.
"""

from pathlib import Path

import pyarrow as pa

from prospect_mj.agent import Learner, checkpoint
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run.records import ACTION_SCHEMA, TRIAL_SCHEMA
from prospect_mj.experiment.run.run_files import (
    ACTIONS,
    TRIALS,
    WEIGHTS,
    RunState,
    read_learner,
    read_table,
)
from prospect_mj.storage import replace_file
from prospect_mj.tables import parquet


def begin(folder: Path, learner: Learner, origin: str) -> RunState:
    """Write the state before the first trial, marked with the evaluation's digest."""
    checkpoint.write(folder / WEIGHTS, learner, origin)
    return _nothing(learner)


def write_tables(folder: Path, state: RunState, origin: str) -> None:
    """Make finished trials permanent, marked with the evaluation's digest."""
    for name, table in ((ACTIONS, state.actions), (TRIALS, state.trials)):
        replace_file(folder / name, parquet(table, origin))


def read_state(folder: Path, origin: str, learner: str) -> RunState:
    """Read the finished trials, which another process may add to.

    Args:
        folder: of the evaluation.
        origin: what marks its files.
        learner: name of its learner.

    Raises:
        RunFolderError: if a file is missing, damaged or of another evaluation.
    """
    learned = read_learner(folder, origin, learner)
    if not (folder / TRIALS).exists():
        return _nothing(learned)
    trials = read_table(folder, TRIALS, origin)
    n_actions = int(trials["n_actions"].to_numpy().sum())
    actions = read_table(folder, ACTIONS, origin).slice(0, n_actions)
    _check_together(folder, actions, trials)
    return RunState(learned, actions, trials)


def _nothing(learner: Learner) -> RunState:
    return RunState(learner, ACTION_SCHEMA.empty_table(), TRIAL_SCHEMA.empty_table())


def _check_together(folder: Path, actions: pa.Table, trials: pa.Table) -> None:
    taken = actions["trial"].value_counts().to_pylist()
    counted = {row["values"]: row["counts"] for row in taken}
    if counted != dict(enumerate(trials["n_actions"].to_pylist())):
        raise RunFolderError(f"{folder} is damaged: its tables don't fit together")
