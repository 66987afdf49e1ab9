"""Several seeds in a few characters."""

from itertools import chain

from prospect_mj.checks import whole_number
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import LARGEST_SEED

MOST_SEEDS = 10_000

_EXPECTED = (
    "seeds such as 0:8, 0:8:2 or 0,3,5, each once; the end of a range is not in it"
)


def parse_seeds(words: str) -> tuple[int, ...]:
    """Read seeds: numbers and ranges start:stop or start:stop:step, with commas.

    Ranges are those of Python: 0:8 ends with 7.

    Returns:
        The seeds, ascending.

    Raises:
        InvalidValue: if they can't be read, are none, too many or too large, or one is
            there twice.
    """
    ranges = [_range(words, part) for part in words.split(",")]
    if sum(map(len, ranges)) > MOST_SEEDS:
        raise InvalidValue("--seeds", words, f"at most {MOST_SEEDS} seeds")
    seeds = sorted(chain.from_iterable(ranges))
    if not seeds or len(set(seeds)) < len(seeds):
        raise InvalidValue("--seeds", words, _EXPECTED)
    if seeds[-1] > LARGEST_SEED:
        raise InvalidValue("--seeds", words, f"seeds from 0 to {LARGEST_SEED}")
    return tuple(seeds)


def _range(words: str, part: str) -> range:
    values = [whole_number(number.strip()) for number in part.split(":")]
    if len(values) > 3 or None in values or values[2:] == [0]:
        raise InvalidValue("--seeds", words, _EXPECTED)
    return range(values[0], values[0] + 1) if len(values) == 1 else range(*values)
