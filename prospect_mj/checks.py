"""Checks of settings: what passes is of the right kind and range.

Of numbers Python's only: settings are written to JSON and YAML, which know no others.
"""

import math
from collections.abc import Collection, Mapping
from dataclasses import fields

from prospect_mj.errors import InvalidChoice, InvalidValue

_MOST_DIGITS = 19
"""Of a whole number: the largest integer of 64 bits has so many."""


def check_integer(what: str, value: object, least: int, most: int) -> None:
    """Refuse all but an integer in a range; true and false are none.

    Raises:
        InvalidValue: with the range.
    """
    integer = isinstance(value, int) and not isinstance(value, bool)
    if not integer or not least <= value <= most:
        expected = str(least) if least == most else f"an integer from {least} to {most}"
        raise InvalidValue(what, value, expected)


def check_number(
    what: str, value: object, least: float, most: float, above: bool = False
) -> None:
    """Refuse all but a finite number in a range.

    Args:
        what: name of the setting.
        value: what it was set to.
        least: smallest valid number, or what all must lie above.
        most: largest valid number.
        above: whether `least` itself is invalid.

    Raises:
        InvalidValue: with the range.
    """
    if (
        not isinstance(value, int | float)
        or isinstance(value, bool)
        or not math.isfinite(value)
        or not least <= value <= most
        or (above and value == least)
    ):
        bracket = "(" if above else "["
        raise InvalidValue(what, value, f"a number in {bracket}{least}, {most}]")


def check_choice(what: str, value: object, choices: Collection[object]) -> None:
    """Refuse all but some values.

    Raises:
        InvalidChoice: with the values.
    """
    if value not in choices:
        raise InvalidChoice(what, value, choices)


def whole_number(words: str) -> int | None:
    """The number that some digits write, such as `50`; None for all other words.

    Not what `int` reads as well: signs, blanks, underscores, digits of other scripts.
    Nor more digits than any number has that could be meant.
    """
    written = words.isascii() and words.isdecimal() and len(words) <= _MOST_DIGITS
    return int(words) if written else None


def check_names(plain: Mapping[str, object], settings: type) -> None:
    """Refuse a mapping that doesn't name just the fields of a dataclass.

    Raises:
        InvalidChoice: with their names.
    """
    names = [field.name for field in fields(settings)]
    if sorted(plain) != sorted(names):
        raise InvalidChoice("settings", sorted(plain), names)
