"""Rules on source code: each maps a Python file to its violations.

`test_architecture.py` holds the project against them.
"""

import ast
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

MAX_MODULE_LINES = 250
MAX_FUNCTION_LINES = 40

CONFINED = {
    "dm_control": ("prospect_mj/sim/scene.py",),
    "dm_env": ("prospect_mj/envs/dm_face.py",),
    "imageio_ffmpeg": ("prospect_mj/replay/video.py",),
    "gymnasium": ("prospect_mj/envs/",),
    "matplotlib": (
        "prospect_mj/experiment/development/figures/",
        "prospect_mj/experiment/pictures/automaton_plot.py",
        "prospect_mj/experiment/pictures/field_plot.py",
        "prospect_mj/experiment/paper/figures/direct_labels.py",
        "prospect_mj/experiment/paper/figures/figure_frame.py",
        "prospect_mj/experiment/paper/figures/actions_figure.py",
        "prospect_mj/experiment/paper/figures/strategy_figure.py",
        "prospect_mj/experiment/run/plots.py",
        "prospect_mj/experiment/seeds/curves_figure.py",
        "prospect_mj/experiment/portraits/grasp_picture.py",
        "prospect_mj/experiment/portraits/run_frame.py",
        "prospect_mj/experiment/portraits/start_value_picture.py",
        "prospect_mj/experiment/portraits/strategy_picture.py",
        "prospect_mj/experiment/portraits/value_tables.py",
        "prospect_mj/experiment/portraits/weights_picture.py",
        "prospect_mj/experiment/studies/vision_plots.py",
    ),
    "networkx": (
        "prospect_mj/experiment/pictures/automaton_graph.py",
        "prospect_mj/supervisor/automaton.py",
    ),
    # Compiled code on disk grows stale unseen where what it calls is in another file,
    # but for these: see `planning.kernel_cache` and `kernels.cache`.
    "numba": (
        "prospect_mj/experiment/populations/kernels/",
        "prospect_mj/planning/",
    ),
    "ray": ("prospect_mj/recording/ray_cluster.py",),
    "rerun": ("prospect_mj/replay/",),
    "sb3_contrib": ("prospect_mj/experiment/development/rivals/deep/",),
    "stable_baselines3": ("prospect_mj/experiment/development/rivals/deep/",),
    "torch": ("prospect_mj/experiment/development/rivals/deep/",),
}
"""Library: the only places that may import it (those of a later issue: nowhere)."""

LEARNER_IMPORTS = {
    "numpy",
    "prospect_mj.agent",
    "prospect_mj.checks",
    "prospect_mj.errors",
    "prospect_mj.storage",
}

SEEDED = {"default_rng", "SeedSequence", "PCG64", "PCG64DXSM", "Philox", "SFC64"}
GENERATORS = SEEDED | {"Generator", "BitGenerator"}

STEPPER = "prospect_mj/sim/simulation.py"
STEPS = re.compile(
    r"mujoco\.(mj_(step|Euler|RungeKutta|implicit)\w*|(rollout|batch)(\.\w+)*)"
)
OVERWRITES = re.compile(
    r"mujoco\.mj_(forward|fwd|inverse|kinematics|resetData|setState|setKeyframe)\w*"
)

Violations = Iterator[tuple[int, str]]


@dataclass(frozen=True)
class Source:
    """A Python file; `path` is relative to the project, with forward slashes."""

    path: str
    text: str

    @cached_property
    def nodes(self) -> list[ast.AST]:
        return list(ast.walk(ast.parse(self.text, self.path)))

    @cached_property
    def imports(self) -> list[tuple[int, str | None, str]]:
        """Line, name bound here, full dotted name of all that is imported."""
        found = []
        for node in self.nodes:
            if isinstance(node, ast.Import):
                for name in node.names:
                    found.append((node.lineno, name.asname, name.name))
                    root = name.name.partition(".")[0]
                    found.append((node.lineno, root, root))
            elif isinstance(node, ast.ImportFrom) and node.level == 0:
                for name in node.names:
                    full = f"{node.module}.{name.name}"
                    found.append((node.lineno, name.asname or name.name, full))
        return found

    def resolve(self, node: ast.AST) -> str | None:
        """The full dotted name behind an expression, if an import is its root."""
        if isinstance(node, ast.Name):
            bound = {here: full for _, here, full in self.imports if here}
            return bound.get(node.id)
        if isinstance(node, ast.Attribute) and (base := self.resolve(node.value)):
            return f"{base}.{node.attr}"
        return None

    @cached_property
    def mentions(self) -> list[tuple[int, str]]:
        """Line and full dotted name of everything imported or used of an import."""
        used = [(node, self.resolve(node)) for node in self.nodes]
        return [(line, full) for line, _, full in self.imports] + [
            (node.lineno, full) for node, full in used if full
        ]


def randomness_is_seeded(source: Source) -> Violations:
    """No global generator, and no generator seeded by the operating system."""
    for line, full in source.mentions:
        parts = full.split(".")
        numpys = parts[:2] == ["numpy", "random"] and len(parts) > 2
        if parts[0] == "random" or (numpys and parts[2] not in GENERATORS):
            yield line, f"{full} is a global generator"
    for node in source.nodes:
        name = (isinstance(node, ast.Call) and source.resolve(node.func)) or ""
        if name.startswith("numpy.random.") and name.split(".")[2] in SEEDED:
            seeds = [*node.args, *(keyword.value for keyword in node.keywords)]
            if not seeds or ast.unparse(seeds[0]) == "None":
                yield node.lineno, f"{name} has no seed"


def only_the_simulation_steps(source: Source) -> Violations:
    """One module moves the physics; others compute on data they make for themselves."""
    if source.path == STEPPER:
        return
    own = calls_on_own_data(source)
    for line, full in source.mentions:
        if STEPS.fullmatch(full):
            yield line, f"{full} is for {STEPPER} alone"
        elif OVERWRITES.fullmatch(full) and (line, full) not in own:
            yield line, f"{full} on data that this function has not made"


def calls_on_own_data(source: Source) -> set[tuple[int, str]]:
    """Line and name of calls that get an `MjData` made in the same function."""
    calls = set()
    for function in source.nodes:
        if not isinstance(function, ast.FunctionDef):
            continue
        inside = list(ast.walk(function))
        made = {
            ast.unparse(target)
            for node in inside
            if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call)
            if source.resolve(node.value.func) == "mujoco.MjData"
            for target in node.targets
            if isinstance(target, ast.Name)
        }
        for node in inside:
            if isinstance(node, ast.Call) and made & {*map(ast.unparse, node.args)}:
                calls.add((node.lineno, source.resolve(node.func) or ""))
    return calls


def libraries_are_confined(source: Source) -> Violations:
    """A library that is confined to a module is imported there only."""
    for line, _, full in source.imports:
        places = CONFINED.get(full.partition(".")[0])
        if places is not None and not source.path.startswith(places):
            yield line, f"{full} is confined to {places or 'no module yet'}"


def the_learner_needs_only_numpy(source: Source) -> Violations:
    """The learner imports the standard library, numpy and the project's errors."""
    if not source.path.startswith("prospect_mj/agent/"):
        return
    allowed = LEARNER_IMPORTS | sys.stdlib_module_names
    for node in source.nodes:
        modules = []
        if isinstance(node, ast.Import):
            modules = [name.name for name in node.names]
        elif isinstance(node, ast.ImportFrom):
            modules = ["." * node.level + (node.module or "")]
        for module in modules:
            if not any(f"{module}.".startswith(f"{name}.") for name in allowed):
                yield node.lineno, f"the learner imports {module}"


def modules_and_functions_are_short(source: Source) -> Violations:
    """A module and a function fit into a reader's head."""
    n_lines = len(source.text.splitlines())
    if n_lines > MAX_MODULE_LINES:
        yield 1, f"{n_lines} lines; at most {MAX_MODULE_LINES}"
    for node in source.nodes:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            length = node.end_lineno - node.lineno + 1
            if length > MAX_FUNCTION_LINES:
                yield node.lineno, f"{node.name} has {length} lines"
