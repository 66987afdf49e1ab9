"""Tables with the right mark and columns that no run has written."""

from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from ideal_env import IdealEnv

from prospect_mj import tables
from prospect_mj.errors import RunFolderError
from prospect_mj.experiment.run import session
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.view.run_view import RunView

FILE = {"orientation": "trials.parquet", "look": "trials.parquet"}


@pytest.fixture
def run(tmp_path):
    session.start(TrainConfig(trials=4), tmp_path / "run", IdealEnv, lambda _: None)
    return RunView.read(tmp_path / "run")


def forge(run, column, change):
    """Write a table once more, with the values of a column as `change` leaves them."""
    name = FILE.get(column, "actions.parquet")
    table = run.trials if column in FILE else run.actions
    values = table[column].to_pylist()
    change(values)
    number = table.schema.get_field_index(column)
    field = table.schema.field(column)
    forged = table.set_column(number, field, pa.array(values, field.type))
    (run.path / name).write_bytes(tables.parquet(forged, run.origin))
    return name


def put(value):
    return lambda values: values.__setitem__(1, value)


@pytest.mark.parametrize(
    ("column", "change", "words"),
    [
        ("q_values", put(None), "q_values is missing in some rows"),
        ("q_values", put([0.0] * 5 + [None]), "q_values is missing in some rows"),
        ("q_values", put([np.nan] * 6), "q_values is no finite number"),
        ("sim_seconds", put(np.inf), "sim_seconds is no finite number"),
        ("orientation", put("up"), "orientation is 'up'; valid: left, right"),
        ("holding", put("both"), "holding is 'both'; valid: none, left, right"),
        ("look", put(None), "look is missing in some rows"),
        ("action", put(6), "action is not always from 0 to 5"),
        ("step", list.reverse, "its steps are out of order"),
        ("step", put(-1), "its steps are out of order"),
        ("trial", list.reverse, "its steps are out of order"),
    ],
)
def test_what_cant_be_is_one_line(run, column, change, words):
    name = forge(run, column, change)
    with pytest.raises(RunFolderError) as refused:
        RunView.read(run.path)
    assert str(refused.value).startswith(f"{Path(run.path) / name} is damaged: {words}")


def test_actions_of_each_trial_are_as_many_as_it_counts(run):
    counts = run.trials["n_actions"].to_pylist()
    other = [counts[0] + 1, counts[1] - 1, *counts[2:]]
    number = run.trials.schema.get_field_index("n_actions")
    field = run.trials.schema.field(number)
    forged = run.trials.set_column(number, field, pa.array(other, field.type))
    content = tables.parquet(forged, run.origin)
    (run.path / "trials.parquet").write_bytes(content)
    with pytest.raises(RunFolderError, match="don't fit together"):
        RunView.read(run.path)
