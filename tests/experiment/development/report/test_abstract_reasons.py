"""Why numbers differ from the abstract task's, told by the rows with changes."""

from math import isnan, nan

import pytest
from small_study import SETTINGS

from prospect_mj.experiment.development.report.abstract_numbers import (
    ABSTRACT,
    COMPARED,
)
from prospect_mj.experiment.development.report.abstract_reasons import reasons
from prospect_mj.experiment.development.study import abstract_rows, learners
from prospect_mj.experiment.development.study.ideal_outcomes import IdealOutcomes
from prospect_mj.experiment.development.study.measured import Measured, MeasuredCurves
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Extent
from prospect_mj.experiment.paper.measures.bootstrap import Interval

REPLAY, DISCOVERY = ("replay", "suppressed"), ("discovery", "allowed")
PICTURES, READING, BOTH = abstract_rows.CHANGES.values()
COMES = "it comes to the abstract number"
NONE = f"with none of these {COMES}"


def sharp(number):
    return Interval(number, number, number)


def measured(row, key, numbers):
    """A row that has the abstract numbers, but for some."""
    said = {each.name: sharp(each.said(key)) for each in COMPARED}
    return Measured(row, 20, said | numbers, ABSTRACT[key].order)


def told(recorded, changed, unlike=0):
    """The section.

    Args:
        recorded: by learner and rule, numbers that are unlike the abstract ones.
        changed: the same, by learner, rule and change.
        unlike: outcomes of 500.
    """
    made = Results(SETTINGS, Extent(("learners",)))
    made.outcomes = IdealOutcomes(500, unlike)
    for row in learners.rows(SETTINGS):
        key = row.name, row.rule
        if key in ABSTRACT:
            one = measured(row, key, recorded.get(key, {}))
            made.learners.append(MeasuredCurves(one, None))
    changed = {
        abstract_rows.key(*key, change): n for (key, change), n in changed.items()
    }
    for row in abstract_rows.rows(SETTINGS):
        key = row.settings.learner.name, row.rule
        if key in ABSTRACT:
            numbers = changed.get(
                (row.name, row.rule, row.world), recorded.get(key, {})
            )
            made.towards_abstract.append(measured(row, key, numbers))
    compared = {(one.row.name, one.row.rule): one.measured for one in made.learners}
    return "\n\n".join(reasons(made, compared))


def early(number, low=None, high=None):
    low, high = (number if one is None else one for one in (low, high))
    return {"early_gone": Interval(number, low, high)}


def reason(text):
    (line,) = [line for line in text.splitlines() if line.startswith("- ")]
    return line


def replay(pictures, reading, both, recorded=None):
    recorded = early(120) if recorded is None else recorded
    found = zip((PICTURES, READING, BOTH), (pictures, reading, both), strict=True)
    return told({REPLAY: recorded}, {(REPLAY, change): n for change, n in found})


def test_where_nothing_differs_nothing_is_explained():
    assert told({}, {}) == "No number differs."


def test_the_change_that_brings_a_number_is_the_reason():
    text = replay(early(140), early(110, 100, 110), early(100))
    assert reason(text) == (
        f"- *early gone* of *replay, suppressed*: with the other reading {COMES}."
    )
    cells = "100 | 120 (120 to 120) | 140 (140 to 140) | **110 (100 to 110)** | **100"
    assert f"| early gone | replay | suppressed | {cells}" in text


def test_a_learner_that_reads_no_features_has_its_pictures():
    text = told({DISCOVERY: early(140)}, {(DISCOVERY, PICTURES): early(160)})
    assert reason(text) == (
        f"- *early gone* of *discovery, allowed*: with made-up pictures {COMES}."
    )
    assert "160 | 140 (140 to 140) | **160 (160 to 160)** | - | **160" in text


@pytest.mark.parametrize(
    ("found", "words"),
    [
        (
            (130, 120, 140),
            NONE,
        ),
        ((130, 120, 100), f"with both {COMES}."),
        ((100, 100, 100), f"with made-up pictures or with the other reading {COMES}."),
        ((100, 120, 120), f"with made-up pictures {COMES}, though not with both"),
        ((40, 60, 70), NONE),
    ],
)
def test_changes_alone_are_told_from_both_together(found, words):
    assert words in reason(replay(*map(early, found)))


def test_a_wider_interval_alone_is_no_reason():
    wide = early(120, 90, 140)
    assert NONE in reason(replay(wide, wide, wide))
    inside = early(125, 100, 140)
    recorded = early(130, 120, 140)
    assert NONE in reason(replay(inside, inside, inside, recorded))


def test_what_is_not_there_is_brought_by_being_there():
    lacking = {"early_gone": Interval(nan, nan, nan, 1.0)}
    text = replay(early(100), lacking, lacking, recorded=lacking)
    assert f"with made-up pictures {COMES}" in reason(text)
    assert "| 100 | none | **100 (100 to 100)** | none | none |" in text


def test_a_table_sees_neither_and_of_controls_nothing_was_asked():
    for name, words in (
        ("table", "neither of pictures nor of features"),
        ("table, copied habit", "not asked"),
    ):
        text = told({(name, "suppressed"): {"late_gone": sharp(300)}}, {})
        assert words in reason(text)
        assert text.count("| 300 (300 to 300) | - | - | - |") == 1


def test_it_is_told_what_a_change_does_to_the_other_numbers():
    others = early(100) | {"dominance": sharp(300), "easy_worst": sharp(0.3)}
    text = replay(others, early(100), early(100))
    assert "| replay | suppressed | 1 | 2 | 0 | 0 |" in text
    assert "| replay | allowed | 0 | 0 | 0 | 0 |" in text
    counted = text.partition("of 6 for each learner")[2]
    assert "| table |" not in counted


def test_a_change_that_takes_others_away_is_spoken_against():
    key = "linear", "suppressed"
    wrong = {"easy_worst": sharp(0.4)}
    found = {(REPLAY, READING): early(100), (key, READING): wrong}
    words = (
        f"with the other reading {COMES}, though not with both; against the other "
        "reading speaks that numbers of *linear, suppressed* then differ"
    )
    assert words in reason(told({REPLAY: early(120)}, found))
    # One that differs as recorded already is not taken away by the change.
    text = told({REPLAY: early(120), key: wrong}, found)
    (line,) = [one for one in text.splitlines() if one.startswith("- *early gone*")]
    assert "speaks" not in line


@pytest.mark.parametrize(
    ("unlike", "words", "left"),
    [
        (0, "none differ", "what is left is what of the abstract"),
        (7, "500 in the recording 7 differ", "what is left is the outcomes, and what"),
    ],
)
def test_outcomes_are_a_reason_only_where_some_differ(unlike, words, left):
    text = told({REPLAY: early(120)}, {}, unlike)
    assert words in text
    assert ("no reason" in text) == (unlike == 0)
    assert left in reason(text)


def test_what_the_abstract_task_does_not_tell_never_differs():
    key = "table, copied habit, known correction", "suppressed"
    row = next(row for row in learners.rows(SETTINGS) if (row.name, row.rule) == key)
    (dominance,) = [each for each in COMPARED if each.name == "dominance"]
    assert isnan(dominance.said(key))
    assert not dominance.differs(key, measured(row, key, {"dominance": sharp(9)}))
    assert dominance.said_words(key) == "-"
