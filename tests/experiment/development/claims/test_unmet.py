"""Which criteria a population made by hand does not meet."""

from dataclasses import replace

import numpy as np
import pytest
from hand_made_runs import B, E, L, X, population

from prospect_mj.experiment.development.claims.criteria import LIKE_INFANTS, develops
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.unmet import SHORT, unmet
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.target import Verdict

INFANT = [[L] * 5] * 5 + [[E] * 5] * 6 + [[B] * 5] * 20
SPOILT = [[B] * 5] * 30 + [[E] * 2 + [B] * 3]


def findings(run, easy=None):
    made = population([run] * 5, None if easy is None else [easy] * 5)
    return Findings.of(made, np.random.default_rng(1), 200)


def test_every_criterion_has_a_word_of_its_own():
    assert list(SHORT) == [one.name for one in LIKE_INFANTS]
    assert len(set(SHORT.values())) == len(SHORT)


@pytest.mark.parametrize(
    ("run", "easy", "words"),
    [
        (INFANT, None, ()),
        (INFANT, SPOILT, ("easy trials",)),
        ([[X, X, X, X, L]] * 6 + INFANT[5:], None, ("late stage",)),
        ([[L] * 5] * 8 + [[B] * 5] * 23, None, ("order", "early lead")),
        ([[L] * 5] * 5 + [[E] * 5] * 26, SPOILT, ("end", "easy trials")),
    ],
)
def test_what_lacks_is_named_and_nothing_else(run, easy, words):
    found = findings(run, easy)
    assert unmet(found) == words
    assert (develops(found) is Verdict.HOLDS) == (not words)


def test_what_is_undecided_is_asked():
    found = findings(INFANT)
    wide = {**found.measured, "easy_worst": Interval(0.8, 0.6, 0.9, 0.0)}
    assert unmet(replace(found, measured=wide)) == ("easy trials?",)
    assert unmet(replace(found, order=0.5)) == ("order?",)
