"""Where the model and asset files are, in a checkout and in an installed wheel."""

from pathlib import Path

from prospect_mj.errors import MissingFile

_PACKAGE = Path(__file__).resolve().parent
# The wheel carries models/ and assets/ as prospect_mj/_data (see pyproject.toml).
_ROOT = _PACKAGE / "_data" if (_PACKAGE / "_data").is_dir() else _PACKAGE.parent

MODELS = _ROOT / "models"
ASSETS = _ROOT / "assets"
RECORDINGS = ASSETS / "recordings"
"""Recorded physics that comes with the package: a folder for each world."""


def existing(path: Path) -> Path:
    """Return `path` if it is a file.

    Raises:
        MissingFile: if it is not; the message names the script that writes it.
    """
    if not path.is_file():
        raise MissingFile(
            f"{path} is missing; run scripts/make_torso.py and scripts/make_jar.py"
        )
    return path


def torso_xml() -> Path:
    """Path of the torso's MJCF file."""
    return existing(MODELS / "torso.xml")


def jar_obj() -> Path:
    """Path of the jar's visual mesh."""
    return existing(ASSETS / "jar.obj")


def jar_png() -> Path:
    """Path of the jar's colours."""
    return existing(ASSETS / "jar.png")
