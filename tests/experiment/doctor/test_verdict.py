"""One line for all that the doctor found."""

import pytest

from prospect_mj.experiment.doctor.check import Check, Level
from prospect_mj.experiment.doctor.examination import verdict


@pytest.mark.parametrize(
    ("levels", "words"),
    [
        ("OK OK", "all is well"),
        ("OK WARN OK", "2 OK, 1 WARN, 0 FAIL"),
        ("FAIL WARN WARN", "0 OK, 2 WARN, 1 FAIL"),
    ],
)
def test_levels_are_counted_by_their_names(levels, words):
    assert verdict([Check("it", Level[name], "") for name in levels.split()]) == words
