"""The architecture holds: layers, confined libraries, seeded randomness, one stepper.

Each rule is run on the project, and on planted violations, which show that it can fail.
"""

import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from source_rules import (
    STEPPER,
    Source,
    libraries_are_confined,
    modules_and_functions_are_short,
    only_the_simulation_steps,
    randomness_is_seeded,
    the_learner_needs_only_numpy,
)

ROOT = Path(__file__).resolve().parent.parent

RULES = {
    randomness_is_seeded: ("prospect_mj", "scripts", "examples", "tests"),
    only_the_simulation_steps: ("prospect_mj",),
    libraries_are_confined: ("prospect_mj", "scripts"),
    the_learner_needs_only_numpy: ("prospect_mj",),
    modules_and_functions_are_short: ("prospect_mj", "scripts", "examples"),
}
"""Rule: the folders it is held against."""

PLANTED = [
    (randomness_is_seeded, "a.py", "import random"),
    (randomness_is_seeded, "a.py", "from random import choice"),
    (randomness_is_seeded, "a.py", "import numpy as np\nnp.random.seed(1)"),
    (randomness_is_seeded, "a.py", "from numpy.random import rand"),
    (randomness_is_seeded, "a.py", "import numpy.random as r\nr.normal()"),
    (randomness_is_seeded, "a.py", "import numpy as np\nnp.random.default_rng()"),
    (randomness_is_seeded, "a.py", "import numpy\nnumpy.random.default_rng(None)"),
    (
        randomness_is_seeded,
        "a.py",
        "from numpy.random import SeedSequence as S\nS(entropy=None)",
    ),
    (
        only_the_simulation_steps,
        "prospect_mj/control/a.py",
        "import mujoco\nmujoco.mj_step(m, d)",
    ),
    (
        only_the_simulation_steps,
        "prospect_mj/sim/camera.py",
        "import mujoco as mj\nmj.mj_forward(m, d)",
    ),
    (
        only_the_simulation_steps,
        "prospect_mj/task/a.py",
        "from mujoco import mj_resetDataKeyframe",
    ),
    (only_the_simulation_steps, "prospect_mj/a.py", "from mujoco import rollout"),
    (
        only_the_simulation_steps,
        "prospect_mj/a.py",
        "import mujoco\ndef f(m):\n d = mujoco.MjData(m)\n mujoco.mj_step(m, d)",
    ),
    (
        only_the_simulation_steps,
        "prospect_mj/a.py",
        "import mujoco\ndef f(m):\n d = mujoco.MjData(m)\n"
        "def g(m, d):\n mujoco.mj_forward(m, d)",
    ),
    (libraries_are_confined, "prospect_mj/robot/a.py", "from dm_control import mjcf"),
    (libraries_are_confined, "prospect_mj/envs/a.py", "import matplotlib.pyplot as p"),
    (libraries_are_confined, "prospect_mj/agent/a.py", "import gymnasium"),
    (libraries_are_confined, "prospect_mj/control/a.py", "from numba import njit"),
    (libraries_are_confined, "prospect_mj/a.py", "def f():\n    import rerun as rr"),
    (the_learner_needs_only_numpy, "prospect_mj/agent/a.py", "import scipy.linalg"),
    (the_learner_needs_only_numpy, "prospect_mj/agent/a.py", "from ..sim import gl"),
    (
        the_learner_needs_only_numpy,
        "prospect_mj/agent/a.py",
        "from prospect_mj import sim",
    ),
    (modules_and_functions_are_short, "a.py", "x = 1\n" * 251),
    (
        modules_and_functions_are_short,
        "a.py",
        "class A:\n def f(self):\n" + "  x = 1\n" * 60,
    ),
]

ALLOWED = [
    (randomness_is_seeded, "a.py", "import numpy as np\nnp.random.default_rng(7)"),
    (
        randomness_is_seeded,
        "a.py",
        "import numpy as np\ndef f(r: np.random.Generator):\n return r.random()",
    ),
    (only_the_simulation_steps, STEPPER, "import mujoco\nmujoco.mj_step(m, d)"),
    (only_the_simulation_steps, "prospect_mj/a.py", "import mujoco\nmujoco.MjData(m)"),
    (
        only_the_simulation_steps,
        "prospect_mj/a.py",
        "import mujoco\ndef f(m):\n d = mujoco.MjData(m)\n mujoco.mj_forward(m, d)",
    ),
    (libraries_are_confined, "prospect_mj/sim/scene.py", "from dm_control import mjcf"),
    (libraries_are_confined, "prospect_mj/envs/a.py", "import gymnasium as gym"),
    (libraries_are_confined, "prospect_mj/planning/a.py", "from numba import njit"),
    (
        the_learner_needs_only_numpy,
        "prospect_mj/agent/a.py",
        "import os.path\nimport numpy as np\nfrom prospect_mj.errors import X",
    ),
    (modules_and_functions_are_short, "a.py", "x = 1\n" * 250),
]


@pytest.fixture(scope="module")
def source():
    """A file, read and parsed once for all rules, and forgotten after them."""

    def read(file: Path) -> Source:
        return Source(file.relative_to(ROOT).as_posix(), file.read_text("utf-8"))

    return cache(read)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_project_keeps(rule, source):
    files = [file for one in RULES[rule] for file in (ROOT / one).rglob("*.py")]
    checked = [source(file) for file in sorted(files)]
    assert len(checked) > 10
    broken = {f"{s.path}:{line}: {why}" for s in checked for line, why in rule(s)}
    assert not broken, "\n".join(sorted(broken))


@pytest.mark.parametrize(("rule", "path", "text"), PLANTED)
def test_rule_finds_a_planted_violation(rule, path, text):
    assert list(rule(Source(path, text)))


@pytest.mark.parametrize(("rule", "path", "text"), ALLOWED)
def test_rule_lets_good_code_pass(rule, path, text):
    assert not list(rule(Source(path, text)))


def lint_imports(folder: Path) -> subprocess.CompletedProcess[str]:
    command = shutil.which("lint-imports", path=str(Path(sys.executable).parent))
    return subprocess.run(
        [command, "--no-cache"], cwd=folder, capture_output=True, text=True, check=False
    )


def test_import_contracts_are_kept():
    done = lint_imports(ROOT)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(
    ("importer", "imported", "contract"),
    [
        ("robot", "control.planted", "a layer imports lower layers only"),
        ("vision", "control.planted", "a layer imports lower layers only"),
        ("paths_planted", "errors", "a layer imports lower layers only"),
        ("agent", "sim.planted", "the learner knows nothing of the robot"),
        ("actions", "agent.features", "the robot knows nothing of the learner"),
        ("envs", "agent", "not its weights"),
        ("task", "agent.linear_q", "not its weights"),
    ],
)
def test_import_contracts_can_break(tmp_path, importer, imported, contract):
    shutil.copy(ROOT / ".importlinter", tmp_path)
    package = tmp_path / "prospect_mj"
    ignored = shutil.ignore_patterns("__pycache__", "_data")
    shutil.copytree(ROOT / "prospect_mj", package, ignore=ignored)
    for folder in ("control", "sim", importer):
        (package / folder).mkdir(exist_ok=True)
        (package / folder / "__init__.py").touch()
        (package / folder / "planted.py").touch()
    (package / importer / "planted.py").write_text(f"import prospect_mj.{imported}\n")
    done = lint_imports(tmp_path)
    assert done.returncode == 1, done.stdout + done.stderr
    assert contract in done.stdout.replace("\n", " ")
