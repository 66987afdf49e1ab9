"""The picture of the automaton shows what the synthesis found, legibly."""

import io
import subprocess
import sys
from itertools import combinations
from pathlib import Path

import matplotlib.image
import pytest

from prospect_mj.actions.action import Action
from prospect_mj.experiment.pictures import automaton_plot
from prospect_mj.experiment.pictures.automaton_graph import (
    Attempt,
    Forbidden,
    Group,
    summary,
)
from prospect_mj.experiment.pictures.automaton_layout import HEIGHT, WIDTH, place
from prospect_mj.supervisor.constraints import CONSTRAINTS

ROOT = Path(__file__).resolve().parents[3]
DISABLED = {
    Attempt(group, action)
    for group in (Group.LEFT, Group.RIGHT)
    for action in (Action.GRASP_LEFT, Action.GRASP_RIGHT)
}
ENABLED = {
    Attempt(Group.SEEN, Action.GRASP_LEFT),
    Attempt(Group.SEEN, Action.GRASP_RIGHT),
    Attempt(Group.LEFT, Action.SWAP_LEFT_TO_RIGHT),
    Attempt(Group.RIGHT, Action.SWAP_RIGHT_TO_LEFT),
    Attempt(Group.LEFT, Action.INSERT_LEFT),
    Attempt(Group.RIGHT, Action.INSERT_RIGHT),
}


@pytest.fixture(scope="module")
def graph():
    return summary()


def test_the_graph_has_what_can_happen(graph):
    attempts = {
        n: told["disabled"] for n, told in graph.nodes.items() if "disabled" in told
    }
    assert attempts == dict.fromkeys(ENABLED, False) | dict.fromkeys(DISABLED, True)
    marked = {n for n, told in graph.nodes.items() if told.get("marked")}
    assert marked == {Group.INSERTED, Group.UNKNOWN}
    forbidden = {n for n in graph if isinstance(n, Forbidden)}
    assert {node.constraint for node in forbidden} == set(CONSTRAINTS)


def test_edges_carry_their_results(graph):
    jam = graph.edges[Attempt(Group.LEFT, Action.INSERT_LEFT), Group.LEFT]["results"]
    assert set(jam) == {"jammed", "not_reached"}
    swap = Attempt(Group.RIGHT, Action.SWAP_RIGHT_TO_LEFT)
    assert set(graph.edges[swap, Group.UNKNOWN]["results"]) == {"lost"}
    assert set(graph.edges[swap, Group.LEFT]["results"]) == {"success", "not_reached"}


def test_only_disabled_attempts_lead_to_forbidden_states(graph):
    for attempt in DISABLED:
        assert all(isinstance(end, Forbidden) for end in graph[attempt])
    for attempt in ENABLED:
        assert all(isinstance(end, Group) for end in graph[attempt])


def test_the_layout_is_mirrored_and_has_a_place_for_every_node(graph):
    places = {node: place(node) for node in graph}
    assert len(set(places.values())) == len(places)
    outer = {p for node, p in places.items() if not isinstance(node, Group)}
    for x, y in outer:
        assert abs(x) < WIDTH / 2
        assert 0 < y < HEIGHT
        assert x == 0 or (-x, y) in outer


def test_no_words_lie_on_others():
    figure = automaton_plot.drawing()
    figure.draw_without_rendering()
    (axes,) = figure.axes
    texts = [text for text in axes.texts if text.get_text()]
    assert len(texts) > 50
    extents = {text: text.get_window_extent() for text in texts}
    for first, second in combinations(texts, 2):
        overlapping = extents[first].overlaps(extents[second])
        assert not overlapping, (first.get_text(), second.get_text())


def test_the_picture_in_the_docs_is_of_this_automaton():
    """Of the same words at the same places; pixels may differ between machines."""
    shown = matplotlib.image.imread(ROOT / "docs/images/automaton.png")
    drawn = matplotlib.image.imread(io.BytesIO(automaton_plot.automaton()))
    assert shown.shape == drawn.shape
    assert abs(shown - drawn).mean() < 0.005
    assert drawn[..., :3].std() > 0.05


def test_the_script_writes_it(tmp_path):
    out = tmp_path / "new" / "a.png"
    script = ROOT / "scripts" / "draw_automaton.py"
    subprocess.run([sys.executable, script, "--out", out], check=True)
    assert out.read_bytes().startswith(b"\x89PNG")
