"""The digest of sources: words and layout don't count, code does."""

import configparser
from pathlib import Path

import pytest

from prospect_mj import paths
from prospect_mj.recording import provenance
from prospect_mj.recording.provenance import (
    FILES,
    LAYERS,
    code_digest,
    digest_of_sources,
)

ROOT = Path(__file__).resolve().parents[2]

CODE = '''"""Of a module."""
import math

LIMIT = 0.5
"""Of a constant."""


class Arm:
    """Of a class."""

    name = "left"

    def reach(self, goal: float) -> float:
        """Of a function."""
        if goal > LIMIT:
            return math.sin(goal)  # why
        return -goal
'''

WORDS = {
    "comment": ("# why", "# because"),
    "no comment": ("  # why", ""),
    "module's words": ("Of a module.", "Other words."),
    "constant's words": ('"""Of a constant."""\n', ""),
    "class's words": ("Of a class.", "Other words.\n\n    And more.\n    "),
    "function's words": ('        """Of a function."""\n', ""),
    "layout": ("math.sin(goal)", "math.sin(\n                goal,\n            )"),
    "blank lines": ("import math\n", "import math\n\n\n\n"),
    "quotes": ('"left"', "'left'"),
}
CHANGES = {
    "number": ("0.5", "0.6"),
    "sign": ("-goal", "goal"),
    "comparison": ("> LIMIT", ">= LIMIT"),
    "text": ('"left"', '"right"'),
    "name": ("reach", "touch"),
    "import": ("import math", "import math, cmath"),
    "annotation": ("goal: float", "goal: int"),
    "order": ("goal > LIMIT", "LIMIT > goal"),
    "line gone": ('    name = "left"\n', ""),
}


def digest(text, name="control/arm.py"):
    return code_digest([(name, text)])


@pytest.mark.parametrize(("old", "new"), WORDS.values(), ids=WORDS.keys())
def test_words_and_layout_do_not_count(old, new):
    assert CODE.count(old) == 1
    assert digest(CODE.replace(old, new)) == digest(CODE)


@pytest.mark.parametrize(("old", "new"), CHANGES.values(), ids=CHANGES.keys())
def test_any_change_of_code_counts(old, new):
    assert old in CODE
    assert digest(CODE.replace(old, new)) != digest(CODE)


def test_the_file_counts_and_so_does_what_is_in_which():
    assert digest(CODE, "control/hand.py") != digest(CODE)
    two = [("a.py", "x = 1\n"), ("b.py", "y = 2\n")]
    turned = [("a.py", "y = 2\n"), ("b.py", "x = 1\n")]
    assert code_digest(two) != code_digest(turned)
    assert code_digest(two) != code_digest(two[:1])


def layers_below_the_learner():
    """As the import contract has them, from the task down to the simulation."""
    contract = configparser.ConfigParser()
    contract.read(ROOT / ".importlinter")
    rows = contract["importlinter:contract:layers"]["layers"].split("\n")
    rows = [row.split(" | ") for row in rows if row]
    names = [name for row in rows for name in row]
    return names[names.index("task") : names.index("sim") + 1]


def test_every_layer_below_the_learner_is_among_those_that_count():
    assert sorted(provenance.LAYERS) == sorted(layers_below_the_learner())


@pytest.fixture
def package(tmp_path):
    """A package with one module in each layer, of which digests are taken."""
    for layer in ("cli", "experiment", "envs", "recording", "agent", *LAYERS):
        (tmp_path / layer).mkdir()
        (tmp_path / layer / "module.py").write_text("x = 1\n")
    for file in FILES:
        (tmp_path / file).write_text("x = 1\n")
    return tmp_path


@pytest.mark.parametrize("file", [*(f"{la}/module.py" for la in LAYERS), *FILES])
def test_a_change_of_what_decides_an_outcome_counts(package, file):
    before = digest_of_sources(package)
    (package / file).write_text("x = 2\n")
    assert digest_of_sources(package) != before


@pytest.mark.parametrize("layer", ["agent", "envs", "experiment", "recording", "cli"])
def test_a_change_of_what_decides_no_outcome_does_not_count(package, layer):
    before = digest_of_sources(package)
    (package / layer / "module.py").write_text("x = 2\n")
    assert digest_of_sources(package) == before


def test_the_digest_of_the_sources_is_that_of_this_package():
    package = Path(provenance.__file__).parents[1]
    assert provenance.source_digest() == digest_of_sources(package)


def test_model_files_count_by_their_bytes(tmp_path, monkeypatch):
    before = provenance.model_digests()
    changed = tmp_path / "jar.obj"
    changed.write_bytes(paths.jar_obj().read_bytes() + b"\n")
    monkeypatch.setitem(provenance._MODEL_FILES, "assets/jar.obj", lambda: changed)
    after = provenance.model_digests()
    assert {name for name in before if before[name] != after[name]} == {
        "assets/jar.obj"
    }


def test_a_package_that_is_not_there_has_a_version_all_the_same():
    assert provenance.installed_versions(["no-such-package"]) == {
        "no-such-package": "not installed"
    }
