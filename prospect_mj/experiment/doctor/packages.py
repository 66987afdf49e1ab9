"""Whether the packages that are installed are those that the project asks for."""

import sys
from collections.abc import Sequence
from importlib import metadata

from packaging.requirements import Requirement
from packaging.specifiers import SpecifierSet
from packaging.utils import canonicalize_name

from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.recording.provenance import PACKAGES

PROJECT = "prospect-mj"
_DECIDE = tuple(map(canonicalize_name, PACKAGES))


def look_at_python() -> list[Check]:
    """Python's version against the bounds of the installed distribution."""
    version = ".".join(map(str, sys.version_info[:3]))
    try:
        wanted = SpecifierSet(metadata.metadata(PROJECT)["Requires-Python"] or "")
    except metadata.PackageNotFoundError:
        return [Check("Python", Level.OK, version)]
    if wanted.contains(version, prereleases=True):
        return [Check("Python", Level.OK, f"{version} ({wanted})")]
    remedy = f"make clean, then make PYTHON=... with a Python {wanted}"
    return [Check("Python", Level.FAIL, f"{version}, not {wanted}", remedy)]


def look_at_packages() -> list[Check]:
    """Every required package against its bounds.

    Those that decide outcomes have a line each; of the others only what is wrong is
    told one by one.
    """
    try:
        wanted = _requirements()
    except metadata.PackageNotFoundError:
        found = f"{PROJECT} is not installed: nothing tells which versions it needs"
        remedy = "pip install --editable . in the checkout"
        return [Check("packages", Level.WARN, found, remedy)]
    known = {canonicalize_name(one.name) for one in wanted}
    # What only another package asks for has no bounds of ours.
    wanted += [Requirement(name) for name in _DECIDE if name not in known]
    checks = {canonicalize_name(one.name): _check(one) for one in wanted}
    told = [checks.pop(name) for name in _DECIDE]
    told += [one for one in checks.values() if one.level is not Level.OK]
    n_well = sum(one.level is Level.OK for one in checks.values())
    return [*told, Check("other packages", Level.OK, f"{n_well} within their bounds")]


def requirement_of(name: str) -> Requirement:
    """A package with the bounds that the project sets it, if any."""
    try:
        wanted = _requirements()
    except metadata.PackageNotFoundError:
        wanted = []
    found = (one for one in wanted if one.name == name)
    return next(found, Requirement(name))


def _requirements() -> list[Requirement]:
    """Of the project itself, without its extras."""
    lines: Sequence[str] = metadata.requires(PROJECT) or ()
    found = map(Requirement, lines)
    return [
        one for one in found if one.marker is None or one.marker.evaluate({"extra": ""})
    ]


def _check(wanted: Requirement) -> Check:
    bounds = f" ({wanted.specifier})" if wanted.specifier else ""
    remedy = f"pip install '{wanted.name}{wanted.specifier}'"
    try:
        version = metadata.version(wanted.name)
    except metadata.PackageNotFoundError:
        return Check(wanted.name, Level.FAIL, f"not installed{bounds}", remedy)
    if wanted.specifier.contains(version, prereleases=True):
        return Check(wanted.name, Level.OK, f"{version}{bounds}")
    found = f"{version}, not {wanted.specifier}"
    return Check(wanted.name, Level.FAIL, found, remedy)
