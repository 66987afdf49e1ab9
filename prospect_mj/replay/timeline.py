"""Simulated time as Rerun's timeline."""

from collections.abc import Iterable

import numpy as np
import rerun as rr

TIMELINE = "sim_time"


def column(seconds: Iterable[float]) -> rr.TimeColumn:
    """Times since the beginning of the episode [s]."""
    return rr.TimeColumn(TIMELINE, duration=np.asarray(seconds, np.float64))
