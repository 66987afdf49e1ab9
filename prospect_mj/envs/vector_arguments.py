"""What many environments at once can be told, checked."""

from collections.abc import Sequence

import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.errors import InvalidChoice, InvalidValue

Seeds = int | Sequence[int | None] | None

RESET_MASK = "reset_mask"


def checked_mode(mode: object) -> AutoresetMode:
    """When an environment whose trial has ended is reset.

    Raises:
        InvalidChoice: if there is no such mode.
    """
    try:
        return AutoresetMode(mode)
    except ValueError as error:
        valid = [known.value for known in AutoresetMode]
        raise InvalidChoice("autoreset_mode", mode, valid) from error


def spread(seed: Seeds, n: int) -> Sequence[int | None]:
    """A seed for each of n environments.

    Args:
        seed: of the first one, the others' counting on; or one for each.
        n: number of environments.

    Raises:
        InvalidValue: if it is neither.
    """
    if seed is None:
        return [None] * n
    if _is_seed(seed):
        return [int(seed) + number for number in range(n)]
    several = isinstance(seed, Sequence | np.ndarray) and len(seed) == n
    if not several or not all(one is None or _is_seed(one) for one in seed):
        raise InvalidValue("seed", seed, f"a whole number from 0, or {n} of them")
    return [None if one is None else int(one) for one in seed]


def _is_seed(seed: object) -> bool:
    whole = isinstance(seed, int | np.integer) and not isinstance(seed, bool)
    return whole and seed >= 0


def checked_mask(mask: object, n: int) -> NDArray[np.bool_]:
    """Which of n environments are reset (n,); None: all of them.

    Raises:
        InvalidValue: if that can't be said of them.
    """
    if mask is None:
        return np.ones(n, bool)
    flags = np.asarray(mask)
    if flags.shape != (n,) or flags.dtype != bool or not flags.any():
        raise InvalidValue(RESET_MASK, mask, f"({n},) of bool, one of them true")
    return flags


def checked_actions(actions: object, n: int) -> NDArray[np.intp]:
    """An action for each of n environments (n,).

    Raises:
        InvalidChoice: if there is no such action.
        InvalidValue: if there is not one for each.
    """
    chosen = np.asarray(actions)
    if chosen.shape != (n,) or not np.issubdtype(chosen.dtype, np.integer):
        raise InvalidValue("actions", actions, f"({n},) of integers")
    wrong = (chosen < 0) | (chosen >= len(Action))
    if wrong.any():
        raise InvalidChoice("action", int(chosen[wrong][0]), range(len(Action)))
    return chosen.astype(np.intp)
