"""Claims on populations made by hand: each holds of one, and fails of another."""

import numpy as np
import pytest
from hand_made_runs import B, E, L, X, population

from prospect_mj.experiment.development.claims.claim import (
    AS_PAPER,
    CONJECTURED,
    Subject,
)
from prospect_mj.experiment.development.claims.claims import (
    asked,
    between_learners,
    claims,
    developing,
)
from prospect_mj.experiment.development.claims.criteria import LIKE_INFANTS, by_share
from prospect_mj.experiment.development.claims.findings import Findings
from prospect_mj.experiment.development.claims.single_runs import ABRUPTLY
from prospect_mj.experiment.paper.measures.target import Verdict

INFANT = [[L] * 5] * 5 + [[E] * 5] * 6 + [[B] * 5] * 20
AT_ONCE = [[B] * 5] * 31
TIME_OUTS = [[X, X, X, X, L]] * 6 + [[E] * 5] * 6 + [[B] * 5] * 19
EARLY_FIRST = [[E] * 5] * 6 + [[L] * 5] * 6 + [[B] * 5] * 19

EACH = "every single learner has that phase"


def late_for(*blocks):
    """Runs with as many blocks of late corrections before early ones."""
    return [[[L] * 5] * n + [[E] * 5] * 6 + [[B] * 5] * (25 - n) for n in blocks]


def findings(*runs, easy=None):
    made = population(runs * 5, None if easy is None else [easy] * 5 * len(runs))
    return Findings.of(made, np.random.default_rng(1), 200)


def verdicts(rows):
    return {claim.words: claim.verdict for claim in claims(rows)}


def said(found, words):
    return next(verdict for text, verdict in found.items() if words in text)


def test_a_population_like_infants_meets_all_criteria():
    row = Subject("table", "suppressed")
    judged = asked({row: findings(INFANT)}, LIKE_INFANTS)[row]
    assert {one.verdict for one in judged.values()} == {Verdict.HOLDS}
    assert "late 50, early 110; 100.0 % of the resamples" in {
        one.words for one in judged.values()
    }
    assert judged["corrections dominate"].words == "110 (110 to 110) trials"


@pytest.mark.parametrize(
    ("runs", "easy", "failing"),
    [
        (TIME_OUTS, None, "late corrections prevail"),
        (EARLY_FIRST, None, "late gone first"),
        (AT_ONCE, None, "corrections dominate"),
        ([[L] * 5] * 8 + [[B] * 5] * 23, None, "early corrections lead"),
        ([[L] * 5] * 5 + [[E] * 5] * 26, None, "optimal in the end"),
        (INFANT, [[B] * 5] * 30 + [[E] * 2 + [B] * 3], "easy trials spared"),
    ],
)
def test_each_criterion_can_fail(runs, easy, failing):
    row = Subject("discovery", "suppressed")
    rows = {row: findings(runs, easy=easy)}
    assert asked(rows, LIKE_INFANTS)[row][failing].verdict is Verdict.FAILS
    assert developing(rows)[row] is Verdict.FAILS


def test_the_conjecture_is_asked_of_discovery_only_where_failures_are_suppressed():
    found = verdicts({CONJECTURED: findings(INFANT)})
    assert said(found, "discovers features as it needs") is Verdict.HOLDS
    found = verdicts({Subject("discovery", "allowed"): findings(INFANT)})
    assert not [words for words in found if "discovers features" in words]


def test_a_control_that_does_the_same_makes_discovery_unnecessary():
    like = Subject("replay", "suppressed")
    found = verdicts({CONJECTURED: findings(INFANT), like: findings(INFANT)})
    assert said(found, "not necessary") is Verdict.HOLDS
    found = verdicts({CONJECTURED: findings(INFANT), like: findings(AT_ONCE)})
    assert said(found, "not necessary") is Verdict.FAILS


def test_the_papers_mismatches_are_denied_by_one_that_develops():
    words = "unlike infants in the two ways"
    assert said(verdicts({AS_PAPER: findings(AT_ONCE)}), words) is Verdict.HOLDS
    assert said(verdicts({AS_PAPER: findings(INFANT)}), words) is Verdict.FAILS


MIXED = [[L, E, L, E, L]] * 12 + [[B] * 5] * 19


def test_single_learners_change_abruptly_or_do_not():
    assert said(verdicts({CONJECTURED: findings(INFANT)}), "abruptly") is Verdict.HOLDS
    assert said(verdicts({CONJECTURED: findings(MIXED)}), "abruptly") is Verdict.FAILS


def test_single_learners_go_the_same_way_or_the_opposite_one():
    words = "In most single learners"
    assert said(verdicts({CONJECTURED: findings(INFANT)}), words) is Verdict.HOLDS
    found = verdicts({CONJECTURED: findings(EARLY_FIRST)})
    assert said(found, words) is Verdict.FAILS
    half = findings(INFANT, EARLY_FIRST)
    assert said(verdicts({CONJECTURED: half}), words) is Verdict.OPEN


def test_learners_that_differ_are_mixed_in_their_mean_alone():
    differing = findings(*late_for(*range(2, 12)))
    mixed, alike = findings(MIXED), findings(INFANT)
    for found, expected in (
        (differing, Verdict.HOLDS),
        (mixed, Verdict.FAILS),
        (alike, Verdict.FAILS),
    ):
        assert between_learners({"discovery": found}, {}).verdict is expected
    claim = between_learners({"discovery": mixed, "replay": differing}, {})
    assert claim.verdict is Verdict.FAILS
    assert claim.evidence.endswith("of others it holds for replay")


def test_learners_that_differ_are_more_mixed_than_equal_ones():
    def runs(changes):
        stages = ([L] * 5, [E] * 5, [B] * 5)
        return [
            [s for s, n in zip(stages, (c, 6, 25 - c), strict=True) for _ in range(n)]
            for c in changes
        ]

    differing = {"discovery": findings(*runs(range(2, 12)))}
    little = {"discovery": findings(*runs([6] * 9 + [7]))}
    assert between_learners(differing, little).verdict is Verdict.HOLDS
    assert between_learners(differing, differing).verdict is Verdict.OPEN
    more = {"discovery": findings(*runs([2] * 5 + [15] * 5))}
    claim = between_learners(differing, more)
    assert claim.verdict is Verdict.FAILS
    assert claim.evidence.endswith(" of equal learners")


def test_a_phase_of_late_ones_alone_must_come_first():
    assert said(verdicts({CONJECTURED: findings(INFANT)}), "alone") is Verdict.HOLDS
    found = verdicts({CONJECTURED: findings(EARLY_FIRST)})
    assert said(found, "alone") is Verdict.FAILS


def test_each_learner_has_a_phase_of_late_ones_or_only_their_mean_has():
    all_, most = findings(*late_for(*range(2, 12))), findings(*late_for(1, 6, 7, 8))
    assert said(verdicts({CONJECTURED: all_}), EACH) is Verdict.HOLDS
    found = verdicts({CONJECTURED: most})
    assert said(found, EACH) is Verdict.FAILS
    assert said(found, "mixture of late and early") is Verdict.HOLDS


def test_no_prediction_comes_of_learners_a_third_of_which_have_no_such_phase():
    some = findings(*late_for(*[1] * 5, *range(2, 12)))
    claim = between_learners({"discovery": some}, {})
    assert ABRUPTLY.judge(some).verdict is Verdict.HOLDS
    assert claim.verdict is Verdict.FAILS
    assert "late ones alone at first, 67 (" in claim.evidence


def test_nothing_is_said_of_others_where_there_are_none():
    found = verdicts({CONJECTURED: findings(INFANT)})
    assert not [words for words in found if "not necessary" in words]
    assert claims({}) == []


def test_many_others_are_counted_and_few_are_named():
    others = [Subject(name, "allowed") for name in ("a", "b", "c", "d")]
    rows = dict.fromkeys([CONJECTURED, *others], findings(INFANT))
    (claim,) = (one for one in claims(rows) if "abruptly" in one.words)
    assert claim.evidence.endswith("; of others it holds for 4 of 4")
    rows[others[3]] = findings(MIXED)
    (claim,) = (one for one in claims(rows) if "abruptly" in one.words)
    assert claim.evidence.endswith("holds for a, allowed; b, allowed; c, allowed")


def test_single_runs_of_all_learners_are_asked_the_same():
    like, unlike = Subject("replay", "suppressed"), Subject("linear", "suppressed")
    rows = {CONJECTURED: findings(INFANT), like: findings(INFANT)}
    rows[unlike] = findings(MIXED)
    (claim,) = (one for one in claims(rows) if "abruptly" in one.words)
    assert claim.evidence.endswith("of others it holds for replay, suppressed")
    judged = {row: ABRUPTLY.judge(found) for row, found in rows.items()}
    assert judged[like] == judged[CONJECTURED]
    assert judged[unlike].verdict is Verdict.FAILS


def test_time_outs_with_some_late_corrections_are_no_phase_of_late_ones():
    found = verdicts({CONJECTURED: findings(TIME_OUTS)})
    assert said(found, "alone") is Verdict.FAILS
    assert said(found, "as infants do") is Verdict.FAILS


def test_runs_without_corrections_change_from_nothing_to_nothing():
    found = findings(AT_ONCE)
    assert found.changes.n_runs == 0
    assert found.late_first.estimate == 0.0
    assert said(verdicts({CONJECTURED: found}), "abruptly") is Verdict.OPEN


def test_a_share_of_resamples_decides_where_nearly_all_agree():
    assert by_share(0.95) is Verdict.HOLDS
    assert by_share(0.05) is Verdict.FAILS
    assert by_share(0.5) is Verdict.OPEN
