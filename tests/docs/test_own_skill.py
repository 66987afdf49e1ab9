"""The page on own skills: its code is the example's, and its recipe works."""

import ast
import json
import os
import shutil
import subprocess
import sys

import pytest
from pages import DOCS, ROOT, blocks

PAGE = DOCS / "own_skill.md"
EXAMPLE = ROOT / "examples" / "seventh_skill.py"
MOVED = ("ABOVE", "FALL", "put_back", "_lower", "_abandon")
"""What the page says is moved into the package, and is written over its modules."""

ASK = """
import json
from prospect_mj.actions.action import Action
from prospect_mj.agent import LinearQ
from prospect_mj.supervisor.plant import plant, supervision
from prospect_mj.supervisor.predicates import PRESENTED, carrying
from prospect_mj.supervisor.supervisor import Supervisor
def may(mode, state):
    mask = Supervisor(mode).choice_set(state)
    return [action.label for action in Action if mask[action]]
print(json.dumps({
    "states": [len(plant().states), len(supervision().kept)],
    "presented": may("productive", PRESENTED),
    "right": may("productive", carrying("right")),
    "values": len(LinearQ().weights),
}))
"""


def answers(folder) -> dict:
    done = subprocess.run(
        [sys.executable, "-c", ASK],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(folder)},
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def skill_as_a_module() -> str:
    """The example's imports of the package and its skill, without its script."""
    text = EXAMPLE.read_text("utf-8")
    kept = []
    for node in ast.parse(text).body:
        names = {getattr(node, "name", None)}
        if isinstance(node, ast.Assign):
            names = {target.id for target in node.targets}
        needed = isinstance(node, ast.Import | ast.ImportFrom) and any(
            word in ast.unparse(node)
            for word in ("mink", "actions", "control", "robot")
        )
        if needed or names & {*MOVED}:
            kept.append(ast.get_source_segment(text, node))
    return "\n\n".join(kept)


@pytest.fixture(scope="module")
def changed(tmp_path_factory):
    """A copy of the package, changed as the page says."""
    folder = tmp_path_factory.mktemp("changed")
    ignored = shutil.ignore_patterns("__pycache__", "_data")
    shutil.copytree(ROOT / "prospect_mj", folder / "prospect_mj", ignore=ignored)
    for name in ("models", "assets"):
        (folder / name).symlink_to(ROOT / name)
    module = folder / "prospect_mj" / "actions" / "put_back.py"
    module.write_text(skill_as_a_module(), "utf-8")
    patches = [block.text for block in blocks(PAGE) if block.language == "diff"]
    assert len(patches) == 4
    for patch in patches:
        command = ["git", "apply", "--unidiff-zero", "-"]
        subprocess.run(command, cwd=folder, input=patch, text=True, check=True)
    return folder


def test_the_skill_on_the_page_is_the_examples():
    shown = [block.text for block in blocks(PAGE) if "def put_back" in block.text]
    assert len(shown) == 1
    assert shown[0] in EXAMPLE.read_text("utf-8")


def test_the_recipe_makes_it_an_action_of_the_learner(changed):
    page, now = PAGE.read_text("utf-8"), answers(changed)
    was = answers(ROOT)
    assert now["presented"] == was["presented"] == ["grasp-left", "grasp-right"]
    assert was["right"] == ["swap-right-to-left", "insert-right"]
    assert now["right"] == [*was["right"], "put-back-right"]
    assert now["values"] == 8
    (states, kept), (more, more_kept) = was["states"], now["states"]
    words = " ".join(page.split())
    assert f"from {states} states to {more}" in words
    assert f"from {kept} to {more_kept}" in words


def test_the_recipe_runs_the_skill(changed):
    """The runner has a plan for every action, the new ones among them."""
    check = (
        "from prospect_mj.actions.runner import _PLANS; "
        "from prospect_mj.actions.action import Action; "
        "from prospect_mj.supervisor.effects import EFFECTS; "
        "assert set(_PLANS) == set(EFFECTS) == set(Action) and len(Action) == 8"
    )
    environment = os.environ | {"PYTHONPATH": str(changed)}
    command = [sys.executable, "-c", check]
    subprocess.run(command, cwd=changed, env=environment, check=True)
