"""The command that makes the numbers of a part."""

import shlex
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import fields
from types import MappingProxyType

from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import (
    Extent,
    Part,
    StudySettings,
)

_OF_PART: Mapping[str, str] = MappingProxyType(
    {"worlds": "worlds", "change": "changes"}
)
"""Settings of the extent that a part has of its own."""


def command(results: Results, *parts: Part) -> str:
    """How to make what was just told, in a folder of one's own or in the same one.

    Args:
        results: of the study.
        parts: that it is from.
    """
    made = [part for part in parts if part in results.extent.parts]
    sizes = [field.name for field in fields(StudySettings)]
    own = [_OF_PART[part] for part in made if part in _OF_PART]
    given = [
        *_unusual(results.settings, StudySettings(), sizes),
        *_unusual(results.extent, Extent(), own),
    ]
    given += _unusual(results, Results, ("recording", "recordings"))
    words = shlex.join(["prospect", "development", "--parts", *made, *given])
    return f"Made by `{words}`."


def _unusual(one: object, usual: object, names: Iterable[str]) -> Iterator[str]:
    """Options that are not as usual."""
    for name in names:
        value = getattr(one, name)
        if value != getattr(usual, name):
            yield f"--{name.replace('_', '-')}"
            yield from map(str, value if isinstance(value, tuple) else (value,))
