"""What `reset` of the environment can be told about a trial."""

from collections.abc import Mapping
from typing import Any, NamedTuple, Self

import numpy as np

from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue
from prospect_mj.task.presentation import Orientation, checked_orientation


class ResetOptions(NamedTuple):
    """The options of `reset`, each None if it was not given."""

    orientation: Orientation | None = None
    """The side on which the lid lies."""
    trial: int | None = None
    """Number of the trial, from 0, that a shaping schedule counts by."""

    @classmethod
    def read(cls, options: Mapping[str, Any] | None) -> Self:
        """Check the options that an agent has given.

        Raises:
            InvalidChoice: on an unknown option or orientation.
            InvalidValue: on a trial that is no number from 0, or no options at all.
        """
        given = named_options(options)
        for name in given:
            check_choice("reset option", name, cls._fields)
        if "orientation" in given:
            given["orientation"] = checked_orientation(given["orientation"])
        if "trial" in given:
            given["trial"] = _checked_trial(given["trial"])
        return cls(**given)


def named_options(options: object) -> dict[str, Any]:
    """What was given by name; nothing for None.

    Raises:
        InvalidValue: if it is something else.
    """
    if not isinstance(options, Mapping | None):
        raise InvalidValue("options", options, "a dictionary, or None")
    return dict(options or {})


def _checked_trial(number: object) -> int:
    whole = isinstance(number, int | np.integer) and not isinstance(number, bool)
    if not whole or number < 0:
        raise InvalidValue("trial", number, "a whole number from 0")
    return int(number)
