"""What the finished trials of an evaluation have left in its folder.

The table of actions is written first and that of trials last: the trials that are in
the second are finished, and all of their actions are in the first.
"""

from pathlib import Path

import pyarrow as pa

from prospect_mj.agent import LinearQ
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


def begin(folder: Path, learner: LinearQ) -> RunState:
    """Write the state before the first trial; the learner's origin marks the files."""
    learner.save(folder / WEIGHTS)
    return _nothing(learner)


def write_tables(folder: Path, state: RunState) -> None:
    """Make finished trials permanent."""
    for name, table in ((ACTIONS, state.actions), (TRIALS, state.trials)):
        replace_file(folder / name, parquet(table, state.learner.origin))


def read_state(folder: Path, origin: str) -> RunState:
    """Read the finished trials, which another process may add to.

    Args:
        folder: of the evaluation.
        origin: what marks its files.

    Raises:
        RunFolderError: if a file is missing, damaged or of another evaluation.
    """
    learner = read_learner(folder, origin)
    if not (folder / TRIALS).exists():
        return _nothing(learner)
    trials = read_table(folder, TRIALS, origin)
    n_actions = int(trials["n_actions"].to_numpy().sum())
    actions = read_table(folder, ACTIONS, origin).slice(0, n_actions)
    _check_together(folder, actions, trials)
    return RunState(learner, actions, trials)


def _nothing(learner: LinearQ) -> RunState:
    return RunState(learner, ACTION_SCHEMA.empty_table(), TRIAL_SCHEMA.empty_table())


def _check_together(folder: Path, actions: pa.Table, trials: pa.Table) -> None:
    taken = actions["trial"].value_counts().to_pylist()
    counted = {row["values"]: row["counts"] for row in taken}
    if counted != dict(enumerate(trials["n_actions"].to_pylist())):
        raise RunFolderError(f"{folder} is damaged: its tables don't fit together")
