"""Parsing options, and telling a user in one line what is wrong with them."""

import contextlib
import io
import sys
import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

from prospect_mj.cli import interruption, refusal, standard_streams
from prospect_mj.errors import (
    InvalidChoice,
    InvalidValue,
    ProspectError,
    is_inputs_fault,
    told,
)

if TYPE_CHECKING:
    import tyro

FAILED = 1
BAD_INPUT = 2
INTERRUPTED = 130

_Options = TypeVar("_Options")


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
        raise BadOptions(refusal.of_box(drawn.getvalue())) from None


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
    return run(
        lambda: command(parse(type(default), given, default, prog)), interrupted, given
    )


def run(
    command: Callable[[], None],
    interrupted: str = "interrupted",
    argv: Sequence[str] = (),
) -> int:
    """Run a command; failures print one line on stderr.

    Args:
        command: what to run.
        interrupted: what to tell a user who stops it.
        argv: the arguments that it was given, by which bad values are named.

    Returns:
        The exit code: 0; 1 if the machine or the physics failed; 2 for input that
        can't be used; 130 if the user stopped it.
    """
    standard_streams.open_missing()
    with interruption.noticed() as was_interrupted:
        try:
            _run_quietly(command)
        except BrokenPipeError:
            standard_streams.discard_output()
            return FAILED
        except (KeyboardInterrupt, Exception) as error:
            if isinstance(error, KeyboardInterrupt) or was_interrupted():
                print(interrupted, file=sys.stderr)
                return INTERRUPTED
            if not isinstance(error, ProspectError | OSError):
                raise
            print(f"error: {_told(error, argv)}", file=sys.stderr)
            return BAD_INPUT if is_inputs_fault(error) else FAILED
    return 0


def _run_quietly(command: Callable[[], None]) -> None:
    """Run a command with its warnings as lines for a user."""
    try:
        with warnings.catch_warnings():
            warnings.showwarning = _show_warning
            command()
    finally:
        # Here and not at the end of the process, where nothing could catch it.
        sys.stdout.flush()


def _told(error: Exception, argv: Sequence[str]) -> str:
    words = told(error)
    of_a_value = isinstance(error, BadOptions | InvalidChoice | InvalidValue)
    return refusal.as_typed(words, argv) if of_a_value else words


def _show_warning(message: Warning | str, *where: object, **more: object) -> None:
    """One line for a user, to whom the place in the code says nothing."""
    # Only here: few commands warn, and it takes a while to load.
    from tqdm import tqdm

    # Beside a bar that may be there.
    tqdm.write(f"warning: {message}", file=sys.stderr)
    sys.stderr.flush()
