"""Help texts from docstrings, whatever lines these have."""

from collections.abc import Callable
from dataclasses import is_dataclass, replace
from typing import Annotated

from tyro.conf import DisallowNone, arg
from tyro.constructors import (
    ConstructorRegistry,
    StructConstructorSpec,
    StructFieldSpec,
    StructTypeInfo,
)


def joining_lines() -> ConstructorRegistry:
    """A rule for tyro, which else keeps the line breaks of an indented docstring."""
    registry = ConstructorRegistry()
    under_way: list[object] = []

    @registry.struct_rule
    def join(info: StructTypeInfo) -> StructConstructorSpec | None:
        if not is_dataclass(info.type) or info.type in under_way:
            return None
        under_way.append(info.type)
        try:
            # By the other rules, as this one does nothing for a type under way.
            spec = ConstructorRegistry.get_struct_spec(info)
        finally:
            under_way.pop()
        return _joined(spec) if isinstance(spec, StructConstructorSpec) else None

    return registry


def _joined(spec: StructConstructorSpec) -> StructConstructorSpec:
    return replace(spec, fields=tuple(map(_in_words, spec.fields)))


def _in_words(part: StructFieldSpec) -> StructFieldSpec:
    """An option whose words tell its default, if there is none that can be given."""
    words = _in_one_line(part.helptext)
    # An array can't be compared with a tuple.
    empty = isinstance(part.default, tuple) and not part.default
    if part.default is not None and not empty:
        return replace(part, helptext=words)
    hint = "" if words is not None and "efault: " in words else "(default: none)"
    kind = Annotated[part.type, DisallowNone, arg(help_behavior_hint=hint)]
    return replace(part, type=kind, helptext=words)


def _in_one_line(words: str | Callable[[], str | None] | None) -> str | None:
    found = words() if callable(words) else words
    return None if found is None else " ".join(found.split())
