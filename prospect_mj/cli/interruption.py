"""Ctrl-C, also where a library makes an error of its own of it.

Python raises it wherever it is: in a function that C calls back, ctypes reports
another error in its place.
"""

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType


@contextmanager
def noticed() -> Iterator[Callable[[], bool]]:
    """Raise `KeyboardInterrupt` as usual on Ctrl-C, and remember it.

    Yields:
        Whether there was one.
    """
    happened = threading.Event()

    def remember(number: int, frame: FrameType | None) -> None:
        happened.set()
        signal.default_int_handler(number, frame)

    usual = signal.getsignal(signal.SIGINT)
    in_main = threading.current_thread() is threading.main_thread()
    # What ignores it, such as a job in the background of a shell, goes on doing so.
    if not in_main or usual is not signal.default_int_handler:
        yield happened.is_set
        return
    signal.signal(signal.SIGINT, remember)
    try:
        yield happened.is_set
    finally:
        signal.signal(signal.SIGINT, usual)
