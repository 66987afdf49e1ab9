"""Why numbers differ from the abstract task's, told by the rows with changes."""

from math import isnan, nan

import pytest
from small_study import SETTINGS

from prospect_mj.experiment.development.report.abstract import abstract
from prospect_mj.experiment.development.study import (
    abstract_rows,
    causal,
    learners,
    population,
)
from prospect_mj.experiment.development.study.abstract_besides import (
    besides,
    besides_table,
)
from prospect_mj.experiment.development.study.abstract_compared import COMPARED
from prospect_mj.experiment.development.study.abstract_told import TOLD
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.measured import Measured, MeasuredCurves
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Extent
from prospect_mj.experiment.paper.measures.bootstrap import Interval

REPLAY = "learners", "replay", "suppressed"
DISCOVERY = "learners", "discovery", "allowed"
INHERITED = "causal", "values inherited", "suppressed"
PICTURES, READING, BOTH, FORGETS = abstract_rows.CHANGES
EARLY = "*early gone* of *replay, suppressed*."
PARTS = {"learners": learners, "causal": causal, "population": population}


def early(number, low=None, high=None):
    low, high = (number if one is None else one for one in (low, high))
    return {"early_gone": Interval(number, low, high)}


def measured(row, key, numbers):
    """A row that has the abstract numbers, but for some; .5 where none is told."""
    said = {each.name: each.said(TOLD[key]) for each in COMPARED}
    known = {
        name: 0.5 if isnan(one) and not name.endswith("gone") else one
        for name, one in said.items()
    }
    sharp = {name: Interval(one, one, one) for name, one in known.items()}
    return Measured(row, 20, sharp | numbers, numbers.get("order", known["order"]))


def results(recorded, changed, unlike=0, parts=tuple(PARTS)):
    """A study.

    Args:
        recorded: numbers that are unlike the abstract ones, by key of the row.
        changed: the same, by key and name of the change; else as recorded.
        unlike: outcomes of 500.
        parts: that it has.
    """
    made = Results(SETTINGS, Extent(parts))
    made.outcomes = IdealOutcomes(500, unlike)
    for part in filter(PARTS.get, parts):
        for row in PARTS[part].rows(SETTINGS):
            key = row.part, row.name, row.rule
            if key not in TOLD:
                continue
            usual = recorded.get(key, {})
            one = measured(row, key, usual)
            among = getattr(made, part)
            among.append(one if part == "causal" else MeasuredCurves(one, None))
            # Changes that come to the same for a row are one, by the first's name.
            names = {
                change.of(row): name
                for name, change in reversed(abstract_rows.CHANGES.items())
            }
            for change, name in names.items():
                if change != abstract_rows.NOTHING:
                    numbers = changed.get((key, name), usual)
                    other = abstract_rows.changed(row, change, SETTINGS)
                    made.towards_abstract.append(measured(other, key, numbers))
    return made


def told(*given, **more):
    return "\n\n".join(abstract(results(*given, **more)))


def replay(pictures, reading, both, recorded=None):
    recorded = early(150) if recorded is None else recorded
    found = zip((PICTURES, READING, BOTH), (pictures, reading, both), strict=True)
    return told({REPLAY: recorded}, {(REPLAY, name): one for name, one in found})


def test_where_nothing_differs_nothing_is_explained():
    text = told({}, {})
    assert text.endswith("No number differs.")
    assert "| 0 | 0 |  |  |  |" in text


def test_nothing_is_told_without_rows_that_both_tasks_have():
    assert told({}, {}, parts=("worlds",)) == ""


def test_numbers_that_differ_and_those_outside_are_counted_apart():
    recorded = {REPLAY: early(110), DISCOVERY: early(300)}
    text = told(recorded, {})
    assert "| replay, suppressed | 12 | 1 | 0 | 50 / 50 | *100 / 110* |" in text
    assert "| discovery, allowed | 11 | 1 | 1 | 60 / 60 | **160 / 300** |" in text
    counted = besides_table(besides(results(recorded, {}))).to_pylist()
    assert sum(one["outside"] for one in counted) == 2
    assert sum(one["differs"] for one in counted) == 1
    assert text.count(f"| all | {len(counted)} | 2 | 1 |") == 1


def test_what_is_not_told_is_not_counted():
    key = "learners", "table, copied habit, known correction", "suppressed"
    (one,) = [
        one
        for one in besides(results({}, {}))
        if (one.row.part, one.row.name, one.row.rule) == key
    ]
    assert "dominance" not in [each.name for each in one.compared()]
    assert "- |" in told({}, {}).split("causal: guard .05")[1].splitlines()[0]


def test_the_change_that_brings_a_number_is_the_reason():
    text = replay(early(170), early(110, 100, 110), early(100))
    assert f"- It comes with the other reading: {EARLY}" in text
    cells = "100 | 150 | 170 | **110 (100 to 110)** | **100** | 150 |"
    assert f"| early gone | replay, suppressed | {cells}" in text
    assert "Of 1 numbers that differ, 1 come" in text


@pytest.mark.parametrize(
    ("found", "words"),
    [
        ((170, 150, 100), f"It comes with both: {EARLY}"),
        ((100, 100, 100), "It comes with made-up pictures or with the other reading:"),
        ((100, 150, 150), "It comes with made-up pictures, though not with both:"),
        ((150, 130, 150), f"Not settled, nearer with the other reading: {EARLY}"),
        ((150, 160, 170), "Not settled, not with made-up pictures nor with the"),
    ],
)
def test_changes_alone_are_told_from_both_together(found, words):
    assert words in replay(*map(early, found))


def test_replays_that_forget_are_a_reason():
    text = told({REPLAY: early(150)}, {(REPLAY, FORGETS): early(100)})
    assert f"- It comes with replays that forget: {EARLY}" in text


def test_a_row_that_knows_of_no_change_is_not_settled():
    key = "learners", "table", "suppressed"
    text = told({key: early(300)}, {})
    assert "- Not settled, as the row knows of no change: *early gone* of *tab" in text
    assert "| early gone | table, suppressed | 100 | 300 | - | - | - | - |" in text


def test_rows_with_the_same_reason_are_told_together():
    lacking = {"early_gone": Interval(nan, nan, nan, 1.0)}
    recorded = {DISCOVERY: early(300), INHERITED: early(300)}
    changed = {(DISCOVERY, PICTURES): early(160), (INHERITED, PICTURES): lacking}
    text = told(recorded, changed)
    assert (
        "- It comes with made-up pictures: *early gone* of *discovery, allowed*; "
        "*early gone* of *causal: values inherited*." in text
    )
    assert "| early gone | causal: values inherited | none | 300 | **none** |" in text
    assert "| 28 causal rows together | 1 | 0 | - | - | - |" in text


def test_a_change_that_takes_others_away_is_spoken_against():
    key, wrong = (
        ("learners", "linear", "suppressed"),
        {"easy_worst": Interval(*[0.4] * 3)},
    )
    found = {(REPLAY, READING): early(100), (key, READING): wrong}
    words = (
        "with the other reading, though not with both (against the other reading "
        "speaks that numbers of *linear, suppressed* then differ"
    )
    assert words in told({REPLAY: early(150)}, found)
    # One that differs as recorded already is not taken away by the change.
    assert "speaks" not in told({REPLAY: early(150), key: wrong}, found)
    # Nor one that has other made-up pictures.
    changed = {(DISCOVERY, PICTURES): early(160), (key, PICTURES): wrong}
    assert "speaks" not in told({DISCOVERY: early(300)}, changed)


@pytest.mark.parametrize(
    ("unlike", "words"), [(0, "none differ"), (7, "500 in the recording 7 differ")]
)
def test_outcomes_are_a_reason_only_where_some_differ(unlike, words):
    text = told({REPLAY: early(150)}, {}, unlike)
    assert words in text
    assert ("no reason" in text) == (unlike == 0)
