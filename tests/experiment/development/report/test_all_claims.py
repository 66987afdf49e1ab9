"""Every part that was made makes its claims, and no other."""

from dataclasses import replace

import pytest
import study_by_hand
from study_by_hand import EXTENT, results

from prospect_mj.experiment.development.claims.claim import Claim
from prospect_mj.experiment.development.report.all_claims import all_claims
from prospect_mj.experiment.development.report.answer import answer
from prospect_mj.experiment.development.report.frame import (
    claims_tables,
    closing,
    opening,
)
from prospect_mj.experiment.development.study.settings import Extent
from prospect_mj.experiment.paper.measures.target import Verdict

HOLDS, FAILS, OPEN = Verdict.HOLDS, Verdict.FAILS, Verdict.OPEN
CLAIMING = [part for part in EXTENT.parts if part != "found"]


@pytest.mark.parametrize("part", EXTENT.parts)
def test_a_part_alone_makes_its_own_claims(part):
    made = results(Extent((part,)))
    assert list(all_claims(made)) == ([part] if part in CLAIMING else [])
    text = "\n\n".join(closing(made))
    assert ("## Claims" in text) == (part in CLAIMING)
    assert ("## A prediction" in text) == (part == "learners")


def test_the_command_names_all_parts_that_claims_come_from():
    text = "\n\n".join(closing(results()))
    assert f"Made by `prospect development --parts {' '.join(CLAIMING)} " in text


def test_a_world_that_all_parts_are_in_is_no_world_of_its_own():
    alone = results(Extent(("worlds",), worlds=("standard",)))
    assert all_claims(alone) == {}
    other = results(Extent(("worlds",), worlds=("noisy",)))
    assert {one.verdict for one in all_claims(other)["worlds"]} == {HOLDS}


def test_every_change_is_claimed_of_by_itself():
    made = results()
    found = all_claims(made)["change"]
    for change in made.extent.changes:
        own = [one for one in found if f"(*{change}*)" in one.words]
        # By hand, late corrections only, and all are near-optimal at once.
        assert [(one.of, one.verdict) for one in own] == [
            ("discovery", FAILS),
            ("replay", FAILS),
            ("discovery", OPEN),
        ]


def test_claims_with_the_same_words_are_side_by_side():
    found = [
        Claim("It rains.", HOLDS, "1 mm", "here"),
        Claim("It snows.", HOLDS, "2 mm", "there"),
        Claim("It rains.", HOLDS, "3 mm", "there"),
        Claim("It rains.", OPEN, "-", "elsewhere"),
    ]
    title, holds, other, undecided = claims_tables(found)
    assert (title, other) == ("### What holds", "### What is undecided")
    assert holds.splitlines()[2:] == [
        "| It rains. | here | 1 mm |",
        "| the same | there | 3 mm |",
        "| It snows. | there | 2 mm |",
    ]
    assert undecided.splitlines()[2:] == ["| It rains. | elsewhere | - |"]


@pytest.mark.parametrize(
    ("part", "number", "by_verdict"),
    [
        (
            "worlds",
            0,
            {HOLDS: "corrections are gone", FAILS: "corrections are not gone"},
        ),
        ("change", 0, {HOLDS: "discovers goes", FAILS: "discovers does not go"}),
        ("causal", 0, {HOLDS: "needs both", OPEN: "may need both"}),
    ],
)
def test_the_answer_has_a_sentence_for_what_other_parts_say(part, number, by_verdict):
    claim = all_claims(results())[part][number]
    assert claim.of.startswith("discovery")
    for verdict, words in by_verdict.items():
        said = answer({}, [replace(claim, verdict=verdict)])
        assert said.startswith(f"{answer({})} ")
        added = said.removeprefix(answer({}))
        assert words in added
        assert added.count(".") == 1
    assert answer({}, [replace(claim, of="replay")]) == answer({})


def test_the_answer_says_nothing_of_parts_that_were_left_out():
    learners = study_by_hand.results(Extent(("learners",)))
    assert "every world" not in opening(learners)
    whole = opening(results())
    assert whole.count("every world of pictures") == 1
    assert whole.count("When, after learning, the other end") == 1
