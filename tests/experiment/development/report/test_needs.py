"""What the order of the stages needs, told by rows that are made by hand."""

from dataclasses import replace
from itertools import product

import pytest
from study_by_hand import findings

from prospect_mj.experiment.development.report import needs as needs_module
from prospect_mj.experiment.development.report.needs import needs
from prospect_mj.experiment.development.study.causal import (
    ORDERS,
    SHARED,
    VALUES,
    forced_name,
)
from prospect_mj.experiment.paper.measures.target import Verdict

KEEPS = "new values of grasps"
BOTH = "both at once", "stored"


def rows(like, shared=True):
    """Rows at the usual rate, of which some orders with some values are as infants."""
    made = {
        forced_name(*kind, 0.005): findings("infant" if kind in like else "late")
        for kind in product(ORDERS, VALUES)
    }
    return made | {SHARED: findings("infant" if shared else "late")}


FIRST = [("insertion first", "examples"), ("insertion first", "stored")]


def test_both_are_needed_where_all_that_lack_one_do_otherwise():
    claim = needs(rows(FIRST))
    assert claim.verdict is Verdict.HOLDS
    assert "least rate 0.005" in claim.words
    assert "grasp first, stored: does not hold" in claim.evidence
    assert KEEPS in claim.evidence


@pytest.mark.parametrize("lacking", [("insertion first", "inherit"), BOTH])
def test_one_that_lacks_something_and_does_it_denies_the_claim(lacking):
    assert needs(rows([*FIRST, lacking])).verdict is Verdict.FAILS


@pytest.mark.parametrize("like", [[], FIRST[:1]])
def test_one_that_has_both_and_does_not_do_it_denies_the_claim(like):
    assert needs(rows(like)).verdict is Verdict.FAILS


@pytest.mark.parametrize("undecided", [FIRST[0], BOTH])
def test_one_that_is_undecided_leaves_the_claim_so(undecided, monkeypatch):
    made = rows(FIRST)
    one = made[forced_name(*undecided, 0.005)] = replace(made[SHARED])
    verdict = needs_module.develops
    monkeypatch.setattr(
        needs_module,
        "develops",
        lambda found: Verdict.OPEN if found is one else verdict(found),
    )
    assert needs(made).verdict is Verdict.OPEN


def test_a_split_of_the_grasp_that_changes_nothing_else_is_told_as_it_came_out():
    claim = needs(rows(FIRST, shared=False))
    assert claim.verdict is Verdict.HOLDS
    assert f"*{SHARED}*): does not hold" in claim.evidence
    assert KEEPS not in claim.evidence
