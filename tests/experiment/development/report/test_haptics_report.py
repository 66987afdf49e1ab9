"""What is said of haptic categories follows from what was measured."""

from dataclasses import replace
from itertools import product
from math import inf, nan

import pyarrow as pa
import pytest
import study_by_hand

from prospect_mj.experiment.development.haptics import ends
from prospect_mj.experiment.development.haptics.touch import CATEGORY, END
from prospect_mj.experiment.development.measures.measures import (
    early_gone,
    late_gone,
    late_most,
)
from prospect_mj.experiment.development.report.haptics import haptics
from prospect_mj.experiment.development.report.haptics_answer import answer
from prospect_mj.experiment.development.report.haptics_claims import (
    haptic_claims,
    separations,
)
from prospect_mj.experiment.development.report.haptics_compared import (
    Compared,
    tellings,
)
from prospect_mj.experiment.development.study.haptic_rows import FEELING
from prospect_mj.experiment.development.study.settings import FELT_WORLDS, Extent
from prospect_mj.experiment.paper.measures.bootstrap import Interval
from prospect_mj.experiment.paper.measures.target import Verdict
from prospect_mj.recording.worlds import STANDARD

SOON, LONG, NOTHING = Interval(50, 40, 70), Interval(90, 80, 110), Interval(*3 * [nan])


@pytest.fixture(scope="module")
def results():
    return study_by_hand.results(Extent(("haptics",)))


def told(results, low, share=0.9):
    """The same table, with these bounds for the category."""
    rows = results.haptics.told.to_pylist()
    for row in rows:
        if row["by"] == ends.CATEGORY:
            row |= {"told": share, "low": low, "high": 0.95}
    return pa.Table.from_pylist(rows, ends.TOLD)


@pytest.mark.parametrize(
    ("usual", "more", "less", "words"),
    [
        (LONG, SOON, Verdict.HOLDS, "gone sooner, 50 trials in place of 90 trials"),
        (SOON, LONG, Verdict.FAILS, "gone later, 90 trials in place of 50 trials"),
        (LONG, Interval(50, 40, 80), Verdict.OPEN, "gone neither clearly sooner nor"),
        (LONG, NOTHING, Verdict.HOLDS, "sooner, never above 10 % in place of 90"),
        (LONG, Interval(inf, 120, inf), Verdict.FAILS, "gone later, never in place of"),
        # Half of the resamples are never above the level: it may be gone at once.
        (SOON, Interval(90, 80, 110, 0.5), Verdict.OPEN, "gone neither clearly"),
        (NOTHING, NOTHING, Verdict.OPEN, "never above 10 %"),
    ],
)
def test_what_is_sooner_is_so_by_whole_intervals(usual, more, less, words):
    found = Compared(late_gone, usual, more)
    assert found.less is less
    assert words in found.brief
    assert found.there == (words != "never above 10 %")


def test_shares_are_rarer_or_more_frequent():
    found = Compared(late_most, Interval(0.9, 0.8, 1.0), Interval(0.2, 0.1, 0.3))
    assert found.words == (
        "rarer at their most, 20.0 % (10.0 % to 30.0 %) in place of 90.0 % (80.0 % to "
        "100.0 %)"
    )


def test_every_learner_is_compared_with_itself_told_the_hand(results):
    found = [(one.jar, one.learner, one.touch) for one in tellings(results.touches)]
    assert found == list(product(FELT_WORLDS, FEELING, (CATEGORY, END)))
    for one in tellings(results.touches):
        late = one.compared(late_gone)
        # By hand: late corrections for 60 trials, for 100 told the category.
        assert late.usual.estimate == 60
        assert late.there
        assert (late.told.estimate == 100) == (one.touch == CATEGORY)


@pytest.mark.parametrize(
    ("low", "words"),
    [
        (0.91, "in nine grasps of ten at least"),
        (0.85, "in three of four at least"),
        (0.60, "better than by chance"),
        (0.45, "not better than by chance, as far as so few presentations show"),
    ],
)
def test_how_well_an_end_is_told_is_said_by_the_lower_bound(results, low, words):
    lines = answer(told(results, low), results.touches).splitlines()
    of_ends = [line for line in lines if "standard, hand-over" in line]
    bounds = f"90 ({100 * low:.0f} to 95) %"
    assert len(of_ends) == 1
    assert of_ends[0].startswith(f"- {words}: ")
    assert of_ends[0].count(bounds) == 2 * len(FELT_WORLDS)


def test_the_answer_says_what_was_measured(results):
    words = answer(results.haptics.told, results.touches)
    assert (
        "*linear*, standard jar, told the category: late corrections are gone later, "
        "100 trials in place of 60 trials" in words
    )
    assert (
        "*discovery*, wide-lid jar, told the very end: late corrections are gone "
        "sooner, never above 10 % in place of 60 trials" in words
    )
    assert (
        "*discovery*, wide-lid jar, as infants by all criteria: the hand, holds; the "
        "category, does not hold; the very end, does not hold" in words
    )


@pytest.mark.parametrize(
    ("low", "verdict"), [(0.6, Verdict.HOLDS), (0.4, Verdict.OPEN)]
)
def test_the_category_tells_the_end_if_all_of_the_interval_does(results, low, verdict):
    claim, _ = separations(told(results, low))
    assert claim.verdict is verdict
    assert claim.of == "jar: standard"
    assert "out of the cradle 90 " in claim.evidence
    assert "by the two bits 50 %" in claim.evidence


def test_claims_follow_the_learners(results):
    by_end = {"late corrections that are rarer, and gone sooner": Verdict.HOLDS}
    by_category = {"is through sooner than told": Verdict.FAILS}
    for claim in haptic_claims(results)[len(FELT_WORLDS) :]:
        expected = {**by_end, **by_category}
        (verdict,) = (said for words, said in expected.items() if words in claim.words)
        assert claim.verdict is verdict
    told_of = [claim.of for claim in haptic_claims(results)[len(FELT_WORLDS) :]]
    of = product(FELT_WORLDS, FEELING, by_end | by_category)
    assert told_of == [f"{name}, jar: {jar}" for jar, name, _ in of]


def test_a_claim_on_what_never_was_there_is_undecided(results):
    rows = []
    for one in results.touches:
        numbers = dict(one.measured.measured)
        numbers |= {late_gone.name: NOTHING, early_gone.name: NOTHING}
        rows.append(one._replace(measured=one.measured._replace(measured=numbers)))
    found = haptic_claims(replace(results, touches=rows))[len(FELT_WORLDS) :]
    of_category = [one for one in found if "Told the category" in one.words]
    assert {one.verdict for one in of_category} == {Verdict.OPEN}


def test_a_part_that_was_left_out_claims_nothing():
    assert haptic_claims(study_by_hand.results(Extent(("learners",)))) == []


def test_the_report_says_which_grasps_were_live(results):
    assert "Grasps are those of the recordings.\n" in "\n".join(haptics(results))
    found = results.haptics
    made = {**found.grasps, "narrow-lid": found.grasps[STANDARD]}
    more = replace(results, haptics=replace(found, grasps=made))
    assert "the recordings; live ones: narrow-lid.\n" in "\n".join(haptics(more))


def test_the_section_has_every_row(results):
    text = "\n\n".join(haptics(results))
    for one in results.touches:
        verdict = "holds" if one.row.touch == "two bits" else "does not hold"
        of = f"{one.row.world} | {one.row.name}"
        line = f"\n| {of} | {one.row.touch} | {verdict} | - | - | 4 | "
        assert line in text
    by_number = [line for line in text.splitlines() if line.startswith("| wide-lid | ")]
    numbers = [line.split(" | ")[1:3] for line in by_number[-3:]]
    assert numbers == [["2", "holds"], ["3", "does not hold"], ["5", "holds"]]
    assert "| standard | hand-over | 12 | 24 | 50 (25 to 75) | 100" in text
