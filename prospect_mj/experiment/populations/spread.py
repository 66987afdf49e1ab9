"""Parameters that differ from learner to learner of a population."""

import math
from dataclasses import dataclass, fields, replace

import numpy as np

from prospect_mj.agent import AnyLearnerSettings
from prospect_mj.checks import check_choice, check_number
from prospect_mj.errors import InvalidValue

_SIZES = {"n_actions", "n_features", "n_haptic"}
_LARGEST = 1e9


@dataclass(frozen=True)
class Spread:
    """A parameter that every learner draws for itself, evenly from a range."""

    parameter: str
    """Name of a number in the learner's settings."""
    low: float
    """Least value, in the parameter's unit."""
    high: float
    """Largest value; an integer parameter takes it as often as any other."""
    logarithmic: bool = False
    """Whether it is the logarithm that is drawn evenly; not for integers."""

    def __post_init__(self) -> None:
        """Refuse what is no range."""
        check_number(f"lowest {self.parameter}", self.low, -_LARGEST, _LARGEST)
        check_number(f"highest {self.parameter}", self.high, self.low, _LARGEST)
        if self.logarithmic and self.low <= 0:
            expected = "above 0 where its logarithm is drawn"
            raise InvalidValue(f"lowest {self.parameter}", self.low, expected)

    def value(self, draw: float) -> float:
        """The value at a share of the range.

        Args:
            draw: in [0, 1).
        """
        if not self.logarithmic:
            return self.low + draw * (self.high - self.low)
        low, high = math.log(self.low), math.log(self.high)
        return math.exp(low + draw * (high - low))

    def whole_value(self, draw: float) -> int:
        """The whole number at a share of the range, both ends of it included."""
        return int(self.low + draw * (self.high - self.low + 1))


def check_spreads(settings: AnyLearnerSettings, spreads: tuple[Spread, ...]) -> None:
    """Refuse spreads of what the learner hasn't, or beyond what it may have.

    Raises:
        InvalidChoice: if there is no such number, or not in fractions.
        InvalidValue: if an end of a range is none that the learner may have.
    """
    whole = _numbers(settings)
    for spread in spreads:
        name = spread.parameter
        check_choice("spread parameter", name, whole)
        if whole[name]:
            check_choice(f"logarithmic {name}", spread.logarithmic, (False,))
        for end in (spread.low, spread.high):
            replace(settings, **{name: int(end) if whole[name] else float(end)})


def drawn_settings(
    settings: AnyLearnerSettings,
    spreads: tuple[Spread, ...],
    rng: np.random.Generator,
) -> AnyLearnerSettings:
    """The settings of one learner.

    Args:
        settings: those of all, but for the spread ones.
        spreads: for each a number is drawn, in this order.
        rng: of the learner.
    """
    whole = _numbers(settings)
    drawn: dict[str, float] = {}
    for spread in spreads:
        draw = rng.random()
        at = spread.whole_value if whole[spread.parameter] else spread.value
        drawn[spread.parameter] = at(draw)
    return replace(settings, **drawn)


def _numbers(settings: AnyLearnerSettings) -> dict[str, bool]:
    """Names of the parameters that are numbers, and whether they are whole ones."""
    return {
        field.name: field.type is int
        for field in fields(settings)
        if field.type in (int, float) and field.name not in _SIZES
    }
