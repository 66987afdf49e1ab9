"""An installed wheel works outside of the checkout, and the project's papers agree."""

import ast
import os
import re
import subprocess
import sys
import tomllib
import zipfile
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from prospect_mj.sim.gl import DEBIAN_PACKAGES

ROOT = Path(__file__).resolve().parent.parent
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
SMOKE = """
import mujoco
from prospect_mj import paths
model = mujoco.MjModel.from_xml_path(str(paths.torso_xml()))
print(paths.torso_xml(), paths.jar_obj(), model.nu, sep="\\n")
"""


def pip(*arguments: str | Path) -> None:
    """Run pip; its output is in the test's report when it fails."""
    subprocess.run([sys.executable, "-m", "pip", "--quiet", *arguments], check=True)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    # Without the build backend here, pip fetches it into an environment of its own.
    isolation = ["--no-build-isolation"] if find_spec("hatchling") else []
    pip("wheel", "--no-deps", *isolation, "--wheel-dir", folder, ROOT)
    (built,) = folder.glob("prospect_mj-*.whl")
    return built


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    pip("install", "--no-deps", "--target", folder, wheel)
    return folder


def test_wheel_carries_the_data_files(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {
        "prospect_mj/_data/models/torso.xml",
        "prospect_mj/_data/assets/jar.obj",
        "prospect_mj/_data/assets/recording/recording.yaml",
        "prospect_mj/_data/assets/recording/trees.parquet",
        "prospect_mj/py.typed",
    } <= names
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_wheel_carries_every_module_and_nothing_else(wheel):
    packed = {n for n in zipfile.ZipFile(wheel).namelist() if n.endswith(".py")}
    modules = (ROOT / "prospect_mj").rglob("*.py")
    assert packed == {module.relative_to(ROOT).as_posix() for module in modules}


def test_installed_package_finds_and_loads_the_torso(installed, tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", SMOKE],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(installed)},
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    torso, jar, n_actuators = done.stdout.split("\n")[:3]
    assert Path(torso).is_relative_to(installed)
    assert Path(jar).is_relative_to(installed)
    assert int(n_actuators) >= 14


def pins() -> dict[str, str]:
    """Version by canonical name, of every line of the constraints file."""
    lines = (ROOT / "constraints.txt").read_text("utf-8").splitlines()
    pinned = [line for line in lines if line and not line.startswith("#")]
    found = [re.fullmatch(r"([A-Za-z0-9._-]+)==([A-Za-z0-9.+!]+)", p) for p in pinned]
    assert all(found), [p for p, match in zip(pinned, found, strict=True) if not match]
    return {canonicalize_name(match[1]): match[2] for match in found}


def test_constraints_pin_every_requirement_within_its_bounds():
    required = (
        PYPROJECT["project"]["dependencies"] + PYPROJECT["dependency-groups"]["dev"]
    )
    pinned = pins()
    for requirement in map(Requirement, required):
        version = pinned[canonicalize_name(requirement.name)]
        assert requirement.specifier.contains(version), (requirement, version)


def test_constraints_name_no_local_project():
    assert canonicalize_name(PYPROJECT["project"]["name"]) not in pins()


def test_citation_has_the_projects_version_and_licence():
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    project = PYPROJECT["project"]
    assert f"\nversion: {project['version']}\n" in citation
    assert f"\nlicense: {project['license']}\n" in citation


@pytest.mark.parametrize("paper", [".ci/run", "README.md"])
def test_opengl_packages_are_the_same_everywhere(paper):
    assert " ".join(DEBIAN_PACKAGES) in (ROOT / paper).read_text("utf-8")


def third_party_imports():
    """(file, top-level package) of every import that is neither ours nor Python's."""
    for file in sorted((ROOT / "prospect_mj").rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Import):
                names = [name.name for name in node.names]
            elif isinstance(node, ast.ImportFrom) and node.level == 0:
                names = [node.module]
            else:
                continue
            for name in names:
                root = name.partition(".")[0]
                if root not in sys.stdlib_module_names and root != "prospect_mj":
                    yield file.name, root


def test_whatever_is_imported_is_declared():
    """What another package happens to bring along may be gone with its next version."""
    project = PYPROJECT["project"]
    lines = [*project["dependencies"], *project["optional-dependencies"]["cluster"]]
    declared = {canonicalize_name(Requirement(line).name) for line in lines}
    owners = metadata.packages_distributions()
    missing = {
        (file, root)
        for file, root in third_party_imports()
        if not declared & {canonicalize_name(n) for n in owners.get(root, [root])}
    }
    assert not missing
