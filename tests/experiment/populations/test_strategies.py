"""Hand-written trials and what they are."""

import numpy as np
import pytest

from prospect_mj.agent.haptics import LEFT, NONE, RIGHT
from prospect_mj.experiment.populations.strategies import (
    Grip,
    Strategy,
    classify,
    easy,
    first_grip,
    first_hand,
)

# As if the lid lay to the left: "good" is the left hand. A swap is named for its giver.
ACTIONS = {
    "grasp good": 0,
    "grasp bad": 1,
    "swap good": 2,
    "swap bad": 3,
    "insert good": 4,
    "insert bad": 5,
}
MIRRORED = [1, 0, 3, 2, 5, 4]

TRIALS = [
    # (what is done, what it is); in brackets = not run, ! = the jar is inserted.
    ("grasp good, insert good!", "OPTIMAL"),
    ("grasp bad, swap bad, insert good!", "EARLY"),
    ("grasp bad, insert bad, swap bad, insert good!", "LATE"),
    # A right first grasp without a swap is optimal, whatever else was tried.
    ("grasp good, insert good, insert good!", "OPTIMAL"),
    # What is not run doesn't count.
    ("[swap bad], [insert bad], [insert good], grasp good, insert good!", "OPTIMAL"),
    ("grasp good, [grasp bad], [swap bad], [insert bad], insert good!", "OPTIMAL"),
    ("grasp bad, [insert good], [grasp good], swap bad, insert good!", "EARLY"),
    ("[grasp good], grasp bad, swap bad, insert good!", "EARLY"),
    (
        "[insert bad], grasp bad, [swap good], insert bad, swap bad, insert good!",
        "LATE",
    ),
    # Several corrections.
    ("grasp bad, insert bad, insert bad, swap bad, insert good!", "LATE"),
    ("grasp bad, swap bad, swap good, swap bad, insert good!", "EARLY"),
    ("grasp bad, swap bad, swap good, insert bad, swap bad, insert good!", "LATE"),
    ("grasp bad, swap bad, insert good, insert good!", "LATE"),
    # The first grasp was wrong, even if it took hold of nothing.
    ("grasp bad, grasp good, insert good!", "EARLY"),
    # A right first grasp and a swap are neither.
    ("grasp good, swap good, swap bad, insert good!", "OTHER"),
    ("grasp good, swap good, insert bad, swap bad, insert good!", "OTHER"),
    # Unsolved.
    ("grasp good" + ", [grasp good]" * 9, "OTHER"),
    ("grasp bad, insert bad" + ", [insert good]" * 8, "OTHER"),
    ("grasp bad, swap bad" + ", [swap bad]" * 8, "OTHER"),
    ("[insert good]" + ", [insert bad]" * 9, "OTHER"),
    ("grasp bad" + ", insert bad" * 8 + ", swap bad", "OTHER"),
    # Solved by the last action.
    ("grasp bad" + ", insert bad" * 7 + ", swap bad, insert good!", "LATE"),
    ("grasp bad" + ", [grasp bad]" * 7 + ", swap bad, insert good!", "EARLY"),
]


def arrays(text, cap=10):
    """(cap,) actions, executed, inserted."""
    actions = np.full(cap, -1, np.int8)
    executed, inserted = np.zeros((2, cap), bool)
    for step, word in enumerate(text.split(", ")):
        actions[step] = ACTIONS[word.strip("[]!")]
        executed[step] = not word.startswith("[")
        inserted[step] = word.endswith("!")
    return actions, executed, inserted


@pytest.mark.parametrize(("text", "strategy"), TRIALS)
def test_strategy_of_a_trial_and_of_its_mirror_image(text, strategy):
    actions, executed, inserted = arrays(text)
    assert classify(np.int8(LEFT), actions, executed, inserted) == Strategy[strategy]
    mirrored = np.where(actions < 0, -1, np.array(MIRRORED)[actions])
    assert classify(np.int8(RIGHT), mirrored, executed, inserted) == Strategy[strategy]


def test_many_trials_at_once_are_as_each_alone():
    actions, executed, inserted = (
        np.stack(part).reshape(1, len(TRIALS), 10)
        for part in zip(*(arrays(text) for text, _ in TRIALS), strict=True)
    )
    lid = np.full((1, len(TRIALS)), LEFT, np.int8)
    found = classify(lid, actions, executed, inserted)
    assert found.dtype == np.int8
    assert found.tolist() == [[Strategy[name] for _, name in TRIALS]]


def test_the_other_lid_makes_an_optimal_trial_something_else():
    actions, executed, inserted = arrays("grasp good, insert good!")
    assert classify(np.int8(RIGHT), actions, executed, inserted) == Strategy.EARLY


def test_easy_is_the_lid_on_the_dominant_side():
    lid = np.array([[LEFT, RIGHT, RIGHT]])
    assert easy(lid, "right").tolist() == [[False, True, True]]
    assert easy(lid, "left").tolist() == [[True, False, False]]


@pytest.mark.parametrize(
    ("text", "hand"),
    [
        ("grasp good, insert good!", LEFT),
        ("[grasp good], grasp bad, swap bad, insert good!", RIGHT),
        ("grasp bad, grasp good, insert good!", RIGHT),
        ("[grasp bad]" + ", [insert good]" * 9, NONE),
    ],
)
def test_the_first_hand_is_that_of_the_first_grasp_that_was_run(text, hand):
    actions, executed, _ = arrays(text)
    assert first_hand(actions, executed) == hand


def test_a_radial_grip_is_by_the_hand_on_the_lids_side():
    lid = np.array([LEFT, LEFT, RIGHT, RIGHT, RIGHT], np.int8)
    hand = np.array([LEFT, RIGHT, LEFT, RIGHT, NONE], np.int8)
    radial, nonradial = Grip
    grip = first_grip(lid, hand)
    assert grip.tolist() == [radial, nonradial, nonradial, radial, -1]
