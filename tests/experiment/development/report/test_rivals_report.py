"""What the report says of rivals follows from what was measured."""

import pyarrow as pa
import pytest

from prospect_mj.experiment.development.report.rivals import rivals
from prospect_mj.experiment.development.rivals.learning import CURVES, LEARNING
from prospect_mj.experiment.development.rivals.planner.model_errors import ERRORS
from prospect_mj.experiment.development.rivals.planner.prices import PRICES
from prospect_mj.experiment.development.rivals.planner.wrong_physics import WRONG
from prospect_mj.experiment.development.rivals.rivals import RivalResults
from prospect_mj.experiment.development.rivals.settings import (
    LINEAR,
    RivalSettings,
)

RIGHT, LEFT = "grasp-right, insert-right", "grasp-left, insert-left"


def words(*rows, learning=()):
    """The report of searches by error, orientation, plan, and whether it is right."""
    names = "error", "orientation", "plan", "inserted"
    counted = {"actions": 2, "simulated": 4, "sim_seconds": 20, "processor_seconds": 1}
    searched = [dict(zip(names, row, strict=True)) | counted for row in rows]
    learned = pa.Table.from_pylist(list(learning), schema=LEARNING)
    empty = [each.empty_table() for each in (CURVES, PRICES, ERRORS)]
    table = pa.Table.from_pylist(searched, schema=WRONG)
    return "\n".join(rivals(RivalResults(RivalSettings(), learned, *empty, table)))


def test_where_the_plan_breaks_is_what_was_measured():
    said = words(
        (-5, "left", "", False),
        (-5, "right", "", False),
        (4, "left", LEFT, True),
        (4, "right", RIGHT, True),
        (5, "left", LEFT, True),
        (5, "right", LEFT, False),
    )
    assert "- the plan inserts the jar in the world: +4 mm; +5 mm, lid left\n" in said
    assert "searched physics only: +5 mm, lid right\n" in said
    assert "- there is no plan: -5 mm\n" in said


@pytest.mark.parametrize("inserted", [True, False])
def test_another_outcome_is_told_otherwise(inserted):
    said = words((5, "left", LEFT, inserted), (5, "right", LEFT, inserted))
    right, misled = ("+5 mm", "at no error") if inserted else ("at no error", "+5 mm")
    assert f"- the plan inserts the jar in the world: {right}\n" in said
    assert f"searched physics only: {misled}\n" in said
    assert "- there is no plan: at no error\n" in said


def test_an_interval_leaves_out_what_no_trial_takes():
    row = dict.fromkeys(LEARNING.names, 600.0) | {"agent": LINEAR, "runs": 2}
    row |= {"trials": 800, "smoothed_runs": 2, "seconds_per_run": 0.5}
    row |= {"last_actions": 3.5, "last_low": -1.6, "last_high": 12.0}
    assert "| 3.50 (1.00 to 10.00) | 0.5 |" in words(learning=[row])
