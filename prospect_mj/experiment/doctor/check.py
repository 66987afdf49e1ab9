"""What one look at the machine found."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum


class Level(StrEnum):
    """How bad it is."""

    OK = "OK"
    WARN = "WARN"
    """Something does not work or is slow; the rest does its duty."""
    FAIL = "FAIL"
    """Some command can't do what it is for."""


@dataclass(frozen=True)
class Check:
    """One thing that was looked at."""

    name: str
    level: Level
    found: str
    """What there is."""
    remedy: str = ""
    """What to type or do to mend it; empty where all is well."""

    def __str__(self) -> str:
        """One line, and one more for the remedy."""
        line = f"{self.level:4}  {self.name:22}  {self.found}"
        return f"{line}\n{'':6}-> {self.remedy}" if self.remedy else line


Look = Callable[[], Sequence[Check]]


def guarded(name: str, look: Look) -> Iterator[Check]:
    """What a look finds; one that breaks has found that it can't be done.

    Args:
        name: what is told of, if it breaks.
        look: whatever may go wrong in it.
    """
    try:
        yield from look()
    # A broken installation may raise anything, and the doctor must not die of it.
    except Exception as error:
        reason = " ".join(str(error).split()) or "no reason given"
        found = f"could not be looked at: {type(error).__name__}: {reason}"
        yield Check(name, Level.FAIL, found, "see whether the checks above tell why")
