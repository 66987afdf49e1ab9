"""Work over many seeds, in shares for several processes."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TypeVar

import numpy as np

from prospect_mj.recording.workers import Workers

Tick = Callable[[int], object]
"""Told of how many more seeds the work is done."""

_Found = TypeVar("_Found")


def in_parallel(
    study: Callable[[Sequence[int]], list[_Found]],
    seeds: Sequence[int],
    jobs: int,
    tick: Tick = lambda n: None,
) -> list[_Found]:
    """What a study finds at each of the seeds, in their order.

    Args:
        study: what finds something for each seed of a share; it is given several, as
            each share compiles the scene once.
        seeds: of all shares.
        jobs: processes.
        tick: called as the shares are done.
    """
    n_shares = min(jobs * 8, len(seeds))
    shares = np.array_split(np.array(seeds), n_shares)
    numbered = [(number, share.tolist()) for number, share in enumerate(shares)]
    work, parts = partial(_numbered, study), {}
    for number, found in Workers(jobs).map(work, numbered):
        parts[number] = found
        tick(len(shares[number]))
    return [found for _, part in sorted(parts.items()) for found in part]


def _numbered(
    study: Callable[[Sequence[int]], list[_Found]], share: tuple[int, Sequence[int]]
) -> tuple[int, list[_Found]]:
    number, seeds = share
    return number, study(seeds)
