"""Measured numbers in words."""

from enum import StrEnum
from math import inf, isinf, isnan

from prospect_mj.experiment.paper.measures.bootstrap import LEVEL, Interval


class Kind(StrEnum):
    """What a number is of."""

    TRIAL = "trial"
    LAG = "lag"
    """Trials from where early corrections are gone to where late ones are."""
    REVERSED_LAG = "reversed lag"
    """Trials from where late corrections are gone to where early ones are."""
    ACTIONS = "actions"
    SHARE = "share"
    POINTS = "points"
    """A difference of two shares."""
    RATIO = "ratio"


def number(value: float, kind: Kind) -> str:
    """A measured number in words."""
    if isnan(value):
        return "none"
    if isinf(value):
        return _never(value, kind)
    match kind:
        case Kind.TRIAL | Kind.LAG | Kind.REVERSED_LAG:
            return _rounded(value, 0)
        case Kind.POINTS:
            return f"{_rounded(100 * value, 1)} points"
        case Kind.SHARE:
            return f"{_rounded(100 * value, 1)} %"
        case _:
            return _rounded(value, 2)


def with_interval(measured: Interval, kind: Kind) -> str:
    """An estimate and its interval in words."""
    low, high = measured.low, measured.high
    nothing = isnan(measured.estimate) or isnan(low)
    if nothing or (isinf(low) and low == high == measured.estimate):
        return number(measured.estimate, kind)
    words = f"{number(low, kind)} to {number(high, kind)}"
    if measured.lacking > 1 - LEVEL:
        words += f"; none in {100 * measured.lacking:.0f} % of the resamples"
    return f"{number(measured.estimate, kind)} ({words})"


def _rounded(value: float, digits: int) -> str:
    # Zero is added so that nothing is written as minus zero.
    return f"{round(value, digits) + 0.0:.{digits}f}"


def _never(value: float, kind: Kind) -> str:
    """What it means that something is never reached."""
    if kind not in (Kind.LAG, Kind.REVERSED_LAG):
        return "never"
    late = (value == inf) == (kind == Kind.LAG)
    return f"{'late' if late else 'early'} corrections never gone"
