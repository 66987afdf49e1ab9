"""The page on the supervisor has the tables of the code, word for word."""

from pathlib import Path

import pytest

from prospect_mj.supervisor.constraints import CONSTRAINTS
from prospect_mj.supervisor.effects import GRASP, INSERT, SWAP, Table
from prospect_mj.supervisor.plant import plant, supervision

PAGE = Path(__file__).resolve().parents[2] / "docs" / "supervisor.md"


def markdown(table: Table, hand: str, opposite: str) -> str:
    """A table of effects as the page has it."""
    lines = [f"| ends in | when | {hand} | {opposite} | jar |", "|---|---|---|---|---|"]
    for e in table:
        row = (f"`{e.result}`", e.when, e.hand, e.opposite, e.jar)
        lines.append(f"| {' | '.join(row)} |")
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("table", "roles"),
    [
        (GRASP, ("the hand", "the other hand")),
        (SWAP, ("the giver", "the taker")),
        (INSERT, ("the hand", "the other hand")),
    ],
    ids=["grasp", "swap", "insert"],
)
def test_effects(table, roles):
    assert markdown(table, *roles) in PAGE.read_text("utf-8")


def test_constraints_and_numbers():
    page = PAGE.read_text("utf-8")
    for name in CONSTRAINTS:
        assert name in page
    reached = supervision().automaton.reachable()
    idle = [situation for situation in reached if situation.running is None]
    transitions = sum(len(row) for row in plant().transitions.values())
    n_states, n_kept = len(plant().states), len(supervision().kept)
    for number in (n_states, transitions, n_kept, len(idle)):
        assert f" {number} " in page.replace("\n", " "), number


if __name__ == "__main__":
    print(markdown(GRASP, "the hand", "the other hand"), end="\n\n")
    print(markdown(SWAP, "the giver", "the taker"), end="\n\n")
    print(markdown(INSERT, "the hand", "the other hand"))
