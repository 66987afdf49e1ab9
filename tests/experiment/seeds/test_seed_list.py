"""Seeds on a command line."""

import pytest

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.seeds.seed_list import parse_seeds


@pytest.mark.parametrize(
    ("words", "seeds"),
    [
        ("0:8", range(8)),
        ("0:8:2", range(0, 8, 2)),
        ("3:4", [3]),
        ("0,3,5", [0, 3, 5]),
        ("5,0", [0, 5]),
        ("7", [7]),
        ("0:3,10:12,20", [0, 1, 2, 10, 11, 20]),
        (str(2**63 - 1), [2**63 - 1]),
    ],
)
def test_ranges_are_those_of_python(words, seeds):
    assert parse_seeds(words) == tuple(seeds)


@pytest.mark.parametrize(
    "words",
    [
        *("", ",", "a", "0:", ":8", "0:8:", "0:8:0", "0:8:2:1", "8:0", "3:3", "-1"),
        *("-3:2", "0:8:-1", "1.5", "0,0", "0:3,2", "1e3", "٣", "0;1"),
        *(str(2**63), "9" * 5000, f"0:{10**18}", "0:10001", f"{2**63}:{2**63 + 2}"),
    ],
)
def test_what_is_none_is_named(words):
    with pytest.raises(InvalidValue, match="--seeds is"):
        parse_seeds(words)
