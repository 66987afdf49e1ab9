"""Checking the arrays of a learner's state before they are taken over."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import InvalidChoice, InvalidValue


def check(state: Mapping[str, NDArray], like: Mapping[str, NDArray]) -> None:
    """Refuse arrays that are not just those of a state.

    Args:
        state: what is to be taken over.
        like: arrays of the names, shapes and kinds that it must have.

    Raises:
        InvalidChoice: on other names.
        InvalidValue: on another shape or kind, or what is no finite number.
    """
    if sorted(state) != sorted(like):
        raise InvalidChoice("learner's state", sorted(state), sorted(like))
    for name, wanted in like.items():
        found = state[name]
        if (found.dtype, found.shape) != (wanted.dtype, wanted.shape):
            what = f"{found.dtype} {found.shape}"
            raise InvalidValue(name, what, f"{wanted.dtype} {wanted.shape}")
        if not np.isfinite(found).all():
            raise InvalidValue(name, "NaN or infinite", "finite numbers")


def check_count(what: str, count: int) -> None:
    """Refuse a number of things that is below zero.

    Raises:
        InvalidValue: if it is.
    """
    if count < 0:
        raise InvalidValue(what, count, "a number from 0")
