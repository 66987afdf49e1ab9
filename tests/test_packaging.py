"""An installed wheel works outside of the checkout, and the project's papers agree."""

import ast
import itertools
import os
import re
import subprocess
import sys
import tarfile
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
NOT_PACKED = {".pre-commit-config.yaml"}
"""Of use in a repository only."""
SMOKE = ROOT / "tests" / "smoke.py"
# Without the build backend here, pip fetches it into an environment of its own.
ISOLATION = ["--no-build-isolation"] if find_spec("hatchling") else []
MAKE_WHEEL = ["wheel", "--no-deps", *ISOLATION]


def pip(*arguments: str | Path) -> None:
    """Run pip; its output is in the test's report when it fails."""
    subprocess.run([sys.executable, "-m", "pip", "--quiet", *arguments], check=True)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("wheel")
    pip(*MAKE_WHEEL, "--wheel-dir", folder, ROOT)
    (built,) = folder.glob("prospect_mj-*.whl")
    return built


@pytest.fixture(scope="module")
def sdist(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("sdist")
    build = ["-m", "hatchling", "build", "--target", "sdist", "--directory", folder]
    subprocess.run([sys.executable, *build], cwd=ROOT, check=True, capture_output=True)
    (built,) = folder.glob("prospect_mj-*.tar.gz")
    return built


def test_wheel_carries_the_data_files(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    assert {
        "prospect_mj/_data/models/torso.xml",
        "prospect_mj/_data/assets/jar.obj",
        "prospect_mj/_data/assets/recordings/standard/recording.yaml",
        "prospect_mj/_data/assets/recordings/standard/trees.parquet",
        "prospect_mj/py.typed",
    } <= names
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_wheel_carries_every_module_and_nothing_else(wheel):
    packed = {n for n in zipfile.ZipFile(wheel).namelist() if n.endswith(".py")}
    modules = (ROOT / "prospect_mj").rglob("*.py")
    assert packed == {module.relative_to(ROOT).as_posix() for module in modules}


def test_sdist_carries_all_that_the_repository_does(sdist):
    tracked = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.split()
    with tarfile.open(sdist) as archive:
        packed = {name.partition("/")[2] for name in archive.getnames()}
    assert set(tracked) - packed <= NOT_PACKED


def test_the_sdist_makes_the_same_wheel(sdist, wheel, tmp_path):
    pip(*MAKE_WHEEL, "--wheel-dir", tmp_path, sdist)
    (built,) = tmp_path.glob("prospect_mj-*.whl")
    contents = [
        {name: archive.read(name) for name in archive.namelist()}
        for archive in (zipfile.ZipFile(wheel), zipfile.ZipFile(built))
    ]
    assert contents[0] == contents[1]


@pytest.fixture(scope="module")
def installed(wheel, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("installed")
    pip("install", "--no-deps", "--target", folder, wheel)
    return folder


@pytest.mark.gl
@pytest.mark.smoke
@pytest.mark.parametrize("physics", ["recorded", "live"])
def test_an_installed_package_works_outside_of_the_checkout(
    physics, installed, tmp_path
):
    """Live trials, whose planner is compiled anew for the copy, are slow."""
    kept = {"NUMBA_CACHE_DIR": str(tmp_path / "cache")}
    done = subprocess.run(
        [sys.executable, SMOKE, installed, physics],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(installed)} | kept,
        capture_output=True,
        text=True,
        timeout=400,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr


def pins() -> dict[str, str]:
    """Version by canonical name, of every line of the constraints file."""
    lines = (ROOT / "constraints.txt").read_text("utf-8").splitlines()
    pinned = [line for line in lines if line and not line.startswith("#")]
    found = [re.fullmatch(r"([A-Za-z0-9._-]+)==([A-Za-z0-9.+!]+)", p) for p in pinned]
    assert all(found), [p for p, match in zip(pinned, found, strict=True) if not match]
    return {canonicalize_name(match[1]): match[2] for match in found}


def test_constraints_pin_every_requirement_within_its_bounds():
    groups = PYPROJECT["dependency-groups"].values()
    required = [*PYPROJECT["project"]["dependencies"], *itertools.chain(*groups)]
    pinned = pins()
    for requirement in map(Requirement, required):
        version = pinned[canonicalize_name(requirement.name)]
        assert requirement.specifier.contains(version), (requirement, version)


def test_an_extra_has_the_bounds_of_the_group_that_tests_it():
    groups, extras = (
        {name: {*lines} for name, lines in found.items()}
        for found in (
            PYPROJECT["dependency-groups"],
            PYPROJECT["project"]["optional-dependencies"],
        )
    )
    assert extras["rivals"] < groups["agents"]
    assert extras["cluster"] < groups["dev"]


def test_constraints_name_no_local_project():
    assert canonicalize_name(PYPROJECT["project"]["name"]) not in pins()


def test_citation_has_the_projects_version_and_licence():
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    project = PYPROJECT["project"]
    assert f"\nversion: {project['version']}\n" in citation
    assert f"\nlicense: {project['license']}\n" in citation


@pytest.mark.parametrize(
    "paper", [".ci/run", "README.md", "docs/tutorial.md", "docs/troubleshooting.md"]
)
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
    extras = itertools.chain(*project["optional-dependencies"].values())
    lines = [*project["dependencies"], *extras]
    declared = {canonicalize_name(Requirement(line).name) for line in lines}
    owners = metadata.packages_distributions()
    missing = {
        (file, root)
        for file, root in third_party_imports()
        if not declared & {canonicalize_name(n) for n in owners.get(root, [root])}
    }
    assert not missing
