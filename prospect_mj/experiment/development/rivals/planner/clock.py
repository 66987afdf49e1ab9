"""How long something took, by the clock on the wall and by the processor's."""

from time import perf_counter, process_time
from typing import NamedTuple


class Spent(NamedTuple):
    """Time since a clock was started."""

    wall: float
    """[s]; longer where other processes have the processors."""
    processor: float
    """Of all threads of this process [s]."""


class Clock:
    """Runs from when it is made."""

    def __init__(self) -> None:
        """Start."""
        self._wall, self._processor = perf_counter(), process_time()

    @property
    def spent(self) -> Spent:
        """Time since then."""
        return Spent(perf_counter() - self._wall, process_time() - self._processor)
