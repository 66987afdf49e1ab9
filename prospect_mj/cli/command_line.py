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
    default: _Options | None = None,
    **tyro_arguments: object,
) -> _Options:
    """Parse a command line into a dataclass.

    Args:
        options: the dataclass.
        argv: the arguments, without the program's name.
        default: values of the options that are not given.
        tyro_arguments: more for `tyro.cli`.

    Raises:
        BadOptions: in one line, where tyro would draw a box.
    """
    drawn = io.StringIO()
    extra = {} if default is None else {"default": default}
    try:
        with contextlib.redirect_stderr(drawn):
            return tyro.cli(options, args=list(argv), **extra, **tyro_arguments)
    except SystemExit as exit_:
        if exit_.code in (0, None):
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
