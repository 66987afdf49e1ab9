"""How work over many seeds is split, and that its end is told."""

import pytest

from prospect_mj.experiment.studies.shares import in_parallel


def squares(seeds):
    return [seed**2 for seed in seeds]


@pytest.mark.parametrize(("first", "n"), [(5, 40), (0, 1)])
def test_what_is_found_is_in_the_order_of_the_seeds(first, n):
    """Whichever share ends first."""
    seeds = range(first, first + n)
    assert in_parallel(squares, seeds, jobs=2) == squares(seeds)


def test_every_seed_is_told_of_once():
    done = []
    in_parallel(squares, range(37), jobs=2, tick=done.append)
    assert len(done) > 2
    assert sum(done) == 37
