"""The standard streams, which a caller may have closed, or stopped reading."""

import contextlib
import os
import sys


def open_missing() -> None:
    """Lead to nowhere the streams that were closed from the start.

    Python has none then, and most of what writes to one relies on it. They are opened
    before any other file is: that would else get a stream's number. Processes that are
    started have them too.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            nowhere = os.open(os.devnull, os.O_RDWR)
            os.set_inheritable(nowhere, True)
            setattr(sys, name, os.fdopen(nowhere, mode, encoding="utf-8"))


def discard_output() -> None:
    """Nobody reads on; Python would complain of that at the end of the process."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
