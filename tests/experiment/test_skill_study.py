"""The study of the skills, without physics: how it is split."""

import pytest

from prospect_mj.experiment.skill_study import in_parallel


def squares(seeds):
    return [seed**2 for seed in seeds]


@pytest.mark.parametrize(("first", "n"), [(5, 40), (0, 1)])
def test_what_is_found_is_in_the_order_of_the_seeds(first, n):
    """Whichever share ends first."""
    seeds = range(first, first + n)
    assert in_parallel(squares, seeds, jobs=2) == squares(seeds)
