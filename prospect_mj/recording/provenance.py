"""What decides an outcome besides settings: sources, model files, packages."""

import ast
import contextlib
import hashlib
import platform
from collections.abc import Iterable
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from prospect_mj import paths

PACKAGES = (
    "mujoco",
    "dm-control",
    "mink",
    "daqp",
    "qpsolvers",
    "numpy",
    "numba",
    "scipy",
    "opencv-python-headless",
    "lxml",
    "networkx",
    "PyOpenGL",
)
"""Outcomes are bit-identical only within one version of each of these."""

LAYERS = (
    "sim",
    "robot",
    "planning",
    "control",
    "vision",
    "actions",
    "supervisor",
    "task",
)
"""Folders of the package below the learner."""
FILES = ("recording/grower.py", "recording/state_codec.py")
"""Beside them, what decides on presentations, and where a recording goes on from."""

_MODEL_FILES = {
    "models/torso.xml": paths.torso_xml,
    "assets/jar.obj": paths.jar_obj,
    "assets/jar.png": paths.jar_png,
}


def sha256(content: bytes) -> str:
    """Hexadecimal digest."""
    return hashlib.sha256(content).hexdigest()


def installed_versions(packages: Iterable[str] = PACKAGES) -> dict[str, str]:
    """Version of each package, by name."""
    return {package: _version(package) for package in packages}


def model_digests() -> dict[str, str]:
    """SHA-256 of each model file, by name.

    Raises:
        MissingFile: if one is missing.
    """
    return {name: sha256(path().read_bytes()) for name, path in _MODEL_FILES.items()}


@cache
def source_digest() -> str:
    """SHA-256 of the code of this package that decides an outcome."""
    return digest_of_sources(Path(paths.__file__).parent)


def digest_of_sources(package: Path) -> str:
    """SHA-256 of a package's code that decides an outcome.

    Comments, docstrings and layout don't count.
    """
    found = [path for layer in LAYERS for path in (package / layer).rglob("*.py")]
    found = sorted([*found, *(package / file for file in FILES)])
    return code_digest(
        (path.relative_to(package).as_posix(), path.read_text("utf-8"))
        for path in found
    )


def code_digest(sources: Iterable[tuple[str, str]]) -> str:
    """SHA-256 of the code of named Python sources."""
    plain = "".join(f"# {name}\n{_code(text)}\n" for name, text in sources)
    return sha256(plain.encode())


def machine() -> dict[str, str]:
    """What the numbers were made on."""
    return {
        "python": platform.python_version(),
        "machine": platform.machine(),
        "processor": _processor(),
        "system": platform.system(),
    }


def _processor() -> str:
    """The processor's name, as far as the operating system tells."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text("utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor()


@cache
def _code(text: str) -> str:
    """A source as its syntax tree says it, without the docstrings.

    Kept, as every run and every population asks for that of the same files.
    """
    return repr(_plain(ast.parse(text)))


def _plain(part: object) -> object:
    """A syntax tree as nested lists, the same in every version of Python."""
    if isinstance(part, list):
        return [_plain(item) for item in part if not _is_words(item)]
    if not isinstance(part, ast.AST):
        return part
    # Newer versions know more fields, which older code leaves empty.
    fields = [(n, v) for n, v in ast.iter_fields(part) if v is not None and v != []]
    return [type(part).__name__, *((name, _plain(value)) for name, value in fields)]


def _is_words(statement: object) -> bool:
    return (
        isinstance(statement, ast.Expr)
        and isinstance(statement.value, ast.Constant)
        and isinstance(statement.value.value, str)
    )


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
