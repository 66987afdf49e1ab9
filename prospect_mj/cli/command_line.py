"""Parsing options, and telling a user in one line what is wrong with them."""

import contextlib
import io
import re
import sys
from collections.abc import Callable, Sequence
from typing import TypeVar

import tyro

from prospect_mj.errors import ProspectError

BAD_INPUT = 2
INTERRUPTED = 130

_Options = TypeVar("_Options")
_ESCAPE = re.compile(r"\x1b\[[0-9;]*m")
_FRAME = "╭╮╰╯│─ \t"


class BadOptions(ProspectError):
    """Options that can't be parsed."""


def parse(
    options: type[_Options],
    argv: Sequence[str],
    default: _Options,
    prog: str,
    registry: tyro.constructors.ConstructorRegistry | None = None,
) -> _Options:
    """Parse a command line into a dataclass.

    Args:
        options: the dataclass.
        argv: the arguments, without the program's name.
        default: values of the options that are not given.
        prog: the program's name in the help.
        registry: tyro's rules for types that it should treat in another way.

    Raises:
        BadOptions: in one line, where tyro would draw a box.
    """
    drawn = io.StringIO()
    try:
        with contextlib.redirect_stderr(drawn):
            return tyro.cli(
                options, prog=prog, args=list(argv), default=default, registry=registry
            )
    except SystemExit as end:
        if end.code in (0, None):
            raise
        raise BadOptions(_first_section(drawn.getvalue())) from None


def run(command: Callable[[], None]) -> int:
    """Run a command and return the exit code; failures print one line on stderr."""
    try:
        command()
    except KeyboardInterrupt:
        print("interrupted: all finished trials are kept", file=sys.stderr)
        return INTERRUPTED
    except (ProspectError, OSError) as error:
        print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
        return BAD_INPUT
    return 0


def _first_section(box: str) -> str:
    """The text of a box down to its first rule, without the frame."""
    lines = [line.strip(_FRAME) for line in _ESCAPE.sub("", box).splitlines()]
    text = lines[1:]
    until = text.index("") if "" in text else len(text)
    return " ".join(text[:until])
