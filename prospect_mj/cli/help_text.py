"""Help texts from docstrings, whatever lines these have."""

from collections.abc import Callable
from dataclasses import is_dataclass, replace

from tyro.constructors import (
    ConstructorRegistry,
    StructConstructorSpec,
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
    fields = [
        replace(part, helptext=_in_one_line(part.helptext)) for part in spec.fields
    ]
    return replace(spec, fields=tuple(fields))


def _in_one_line(words: str | Callable[[], str | None] | None) -> str | None:
    found = words() if callable(words) else words
    return None if found is None else " ".join(found.split())
