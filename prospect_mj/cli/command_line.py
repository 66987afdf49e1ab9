"""Parsing options, and telling a user in one line what is wrong with them."""

import contextlib
import io
import operator
import os
import re
import sys
import warnings
from collections.abc import Callable, Sequence
from itertools import dropwhile, takewhile
from typing import TYPE_CHECKING, TypeVar

from prospect_mj.errors import (
    ProspectError,
    SimulationDiverged,
    UnfinishedRecording,
    UnforeseenEvent,
)

if TYPE_CHECKING:
    import tyro

FAILED = 1
BAD_INPUT = 2
INTERRUPTED = 130

_NO_INPUTS_FAULT = (SimulationDiverged, UnfinishedRecording, UnforeseenEvent)

_Options = TypeVar("_Options")
_ESCAPE = re.compile(r"\x1b\[[0-9;]*m")
# What tyro puts before an option or before a dataclass's own words.
_PARSING = re.compile(r"^Error parsing (?:[A-Za-z_][\w.]*: )?")
_RULE = re.compile(r"-{4,}")
_FRAME = "╭╮╰╯│─ \t"


class BadOptions(ProspectError):
    """Options that can't be parsed."""


def parse(
    options: type[_Options],
    argv: Sequence[str],
    default: _Options,
    prog: str,
    registry: "tyro.constructors.ConstructorRegistry | None" = None,
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
    # Only here: the list of all commands is there without it in half the time.
    import tyro

    from prospect_mj.cli.help_text import joining_lines

    drawn = io.StringIO()
    try:
        with contextlib.redirect_stderr(drawn), joining_lines():
            return tyro.cli(
                options, prog=prog, args=list(argv), default=default, registry=registry
            )
    except SystemExit as end:
        if end.code in (0, None):
            raise
        raise BadOptions(_first_section(drawn.getvalue())) from None


def main(
    command: Callable[[_Options], None],
    default: _Options,
    prog: str,
    argv: Sequence[str] | None = None,
    interrupted: str = "interrupted",
) -> int:
    """Parse a command line and do what it says.

    Args:
        command: what to run with the options.
        default: values of the options that are not given.
        prog: the program's name in the help.
        argv: the arguments; None for those of the process.
        interrupted: what to tell a user who stops it.

    Returns:
        The exit code; see `run`.
    """
    given = sys.argv[1:] if argv is None else argv
    return run(lambda: command(parse(type(default), given, default, prog)), interrupted)


def run(command: Callable[[], None], interrupted: str = "interrupted") -> int:
    """Run a command; failures print one line on stderr.

    Args:
        command: what to run.
        interrupted: what to tell a user who stops it.

    Returns:
        The exit code: 0; 1 if the machine or the physics failed; 2 for input that
        can't be used; 130 if the user stopped it.
    """
    try:
        try:
            with warnings.catch_warnings():
                warnings.showwarning = _show_warning
                command()
        finally:
            # Here and not at the end of the process, where nothing could catch it.
            sys.stdout.flush()
    except KeyboardInterrupt:
        print(interrupted, file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _discard_output()
        return FAILED
    except (ProspectError, OSError) as error:
        print(f"error: {' '.join(str(error).split())}", file=sys.stderr)
        return _exit_code(error)
    return 0


def _show_warning(message: Warning | str, *where: object, **more: object) -> None:
    """One line for a user, to whom the place in the code says nothing."""
    print(f"warning: {message}", file=sys.stderr, flush=True)


def _exit_code(error: Exception) -> int:
    """A missing model file is both kinds of error; it counts as input."""
    bad_input = isinstance(error, ProspectError)
    bad_input = bad_input and not isinstance(error, _NO_INPUTS_FAULT)
    return BAD_INPUT if bad_input else FAILED


def _discard_output() -> None:
    """Nobody reads on; Python would complain of that at the end of the process."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)


def _first_section(box: str) -> str:
    """The text of a box below its title, down to the next rule, without the frame."""
    lines = [line.strip(_FRAME) for line in _ESCAPE.sub("", box).splitlines()]
    # Where the terminal has no box characters, a rule is dashes, also below the title.
    ruled = ["" if _RULE.fullmatch(line) else line for line in lines[1:]]
    text = dropwhile(operator.not_, ruled)
    return _PARSING.sub("", " ".join(takewhile(bool, text)))
