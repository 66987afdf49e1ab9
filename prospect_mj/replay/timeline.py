"""Simulated time as Rerun's timeline."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple, Protocol

import numpy as np
import rerun as rr

TIMELINE = "sim_time"

_AT_ONCE = 1e-6
"""What follows so soon leaves no gap [s]."""


def column(seconds: Iterable[float]) -> rr.TimeColumn:
    """Times since the beginning of the episode [s]."""
    return rr.TimeColumn(TIMELINE, duration=np.asarray(seconds, np.float64))


class Span(Protocol):
    """What lasts for some time."""

    @property
    def start(self) -> float:
        """[s]."""
        ...

    @property
    def end(self) -> float:
        """[s]."""
        ...


class Change(NamedTuple):
    """When something else is shown."""

    time: float
    """[s]"""
    shown: int | None
    """Number of the span that is shown from then on; None: a gap."""


def changes(spans: Sequence[Span]) -> Iterator[Change]:
    """What is to be logged so that each span is seen until it ends.

    Rerun shows a value until the next one comes. Of spans that last at the same time
    the one is shown that began last; of those that began together, the longest.
    """
    edges = sorted({time for span in spans for time in (span.start, span.end)})
    before = None
    for now, following in pairwise([*edges, np.inf]):
        if following - now <= _AT_ONCE:
            continue
        lasting = [n for n, span in enumerate(spans) if span.start <= now < span.end]
        shown = max(lasting, key=lambda n: (spans[n].start, spans[n].end), default=None)
        if shown != before:
            yield Change(now, shown)
            before = shown
