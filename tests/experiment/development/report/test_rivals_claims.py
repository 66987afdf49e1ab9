"""What is claimed of rivals follows from their tables."""

from math import inf

import pyarrow as pa
import pytest

from prospect_mj.experiment.development.report.rivals_claims import rival_claims
from prospect_mj.experiment.development.rivals.learning import CURVES, LEARNING
from prospect_mj.experiment.development.rivals.planner.model_errors import (
    ERRORS,
    FLIP,
    LID,
    WIDTH,
)
from prospect_mj.experiment.development.rivals.planner.prices import PRICES
from prospect_mj.experiment.development.rivals.planner.wrong_physics import WRONG
from prospect_mj.experiment.development.rivals.rivals import RivalResults
from prospect_mj.experiment.development.rivals.settings import (
    DQN_ANNEALED,
    LINEAR,
    LINEAR_MASKED,
    MASKABLE_PPO,
    RivalSettings,
)
from prospect_mj.experiment.paper.measures.target import Verdict

HOLDS, FAILS, OPEN = Verdict.HOLDS, Verdict.FAILS, Verdict.OPEN
SOON, LATER, NEVER = (500, 450, 550), (650, 600, 700), (inf, inf, inf)
WIDE = (600, 500, inf)
"""Overlaps with all but the last."""


def claims(learning=(), errors=()):
    empty = CURVES.empty_table(), PRICES.empty_table(), WRONG.empty_table()
    curves, prices, wrong = empty
    learned = pa.Table.from_pylist(list(learning), schema=LEARNING)
    believed = pa.Table.from_pylist(list(errors), schema=ERRORS)
    made = RivalResults(RivalSettings(), learned, curves, prices, believed, wrong)
    return rival_claims(made)


def learner(agent, smoothed, single_run):
    found = {"smoothed": smoothed, "single_run": single_run}
    names = ("{}", "{}_low", "{}_high")
    return {"agent": agent} | {
        name.format(measure): value
        for measure, values in found.items()
        for name, value in zip(names, values, strict=True)
    }


@pytest.mark.parametrize(
    ("smoothed", "single_run", "verdict"),
    [
        (LATER, LATER, HOLDS),
        (NEVER, NEVER, HOLDS),
        (LATER, WIDE, OPEN),
        (WIDE, WIDE, OPEN),
        ((300, 250, 350), LATER, FAILS),
    ],
)
def test_fewer_trials_are_so_by_both_measures(smoothed, single_run, verdict):
    rows = learner(LINEAR, SOON, SOON), learner(DQN_ANNEALED, smoothed, single_run)
    (claim,) = claims(rows)
    assert (claim.verdict, claim.of) == (verdict, "beside DQN, annealed ε")
    assert "smoothed: *linear* 500 (450 to 550), *DQN, annealed ε* " in claim.evidence


def test_a_masked_rival_is_held_against_a_masked_learner():
    rows = [
        learner(LINEAR, LATER, LATER),
        learner(LINEAR_MASKED, SOON, SOON),
        learner(MASKABLE_PPO, LATER, LATER),
    ]
    (claim,) = claims(rows)
    assert claim.verdict is HOLDS
    assert "*linear, masked* 500 (450 to 550)" in claim.evidence
    assert claims([rows[0], rows[2]]) == []


def believed(kind, rule, failures, trials=100):
    """Rows by error [mm]."""
    return [
        {
            "kind": kind,
            "error": error,
            "failed_actions": rule,
            "trials": trials,
            "actions": 2.0,
            "failures": share,
        }
        for error, share in failures.items()
    ]


@pytest.mark.parametrize(
    ("failures", "verdict", "told"),
    [
        (
            {-5: 1.0, -4: 0.0, 0: 0.0, 5: 0.46},
            HOLDS,
            "unsolved 100 (96 to 100) % at -5",
        ),
        ({-5: 0.0, 0: 0.0, 5: 0.0}, FAILS, "unsolved 0 (0 to 4) % at -5 to +5 mm"),
        ({-5: 0.0, 0: 0.0, 5: 0.12}, OPEN, "; 12 (7 to 20) % at +5 mm"),
        # What goes wrong without an error is none of the error's doing.
        ({-5: 0.0, 0: 1.0, 5: 0.0}, FAILS, "100 (96 to 100) % at +0 mm"),
    ],
)
def test_a_plan_breaks_at_one_error_at_least(failures, verdict, told):
    (claim,) = claims(errors=believed(LID, "allowed", failures))
    assert claim.verdict is verdict
    assert told in claim.evidence
    assert "at most 5 mm wrong" in claim.words
    assert claim.of == "radius of the lid, failed actions allowed"


def test_few_trials_leave_it_open():
    (claim,) = claims(errors=believed(WIDTH, "allowed", {-5: 0.0, 5: 0.5}, 4))
    assert claim.verdict is HOLDS
    (claim,) = claims(errors=believed(WIDTH, "allowed", {-5: 0.0, 5: 0.0}, 4))
    assert claim.verdict is OPEN


def test_sizes_and_rules_are_claimed_apart_and_a_mistaken_side_is_no_size():
    rows = [
        *believed(WIDTH, "allowed", {5: 1.0}),
        *believed(WIDTH, "suppressed", {5: 0.0}),
        *believed(FLIP, "allowed", {0.5: 0.5}),
    ]
    found = {one.of: one.verdict for one in claims(errors=rows)}
    assert found == {
        "half width of the receptacle, failed actions allowed": HOLDS,
        "half width of the receptacle, failed actions suppressed": FAILS,
    }
