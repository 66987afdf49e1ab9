"""What a discovery learner has learned, as arrays by name."""

from collections.abc import Mapping

from numpy.typing import NDArray

from prospect_mj.agent import state_arrays
from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.examples import Examples
from prospect_mj.agent.features import N_BINS
from prospect_mj.errors import InvalidValue

_EXAMPLE = "example_"


def named(contexts: Contexts, examples: Examples) -> dict[str, NDArray]:
    """All arrays, by name; not copied."""
    remembered = {f"{_EXAMPLE}{n}": array for n, array in examples._asdict().items()}
    return {**contexts._asdict(), **remembered}


def take_over(
    state: Mapping[str, NDArray], contexts: Contexts, examples: Examples
) -> None:
    """Write the arrays of a state into those of a learner.

    Args:
        state: arrays of the right shapes and kinds.
        contexts: written to.
        examples: written to.

    Raises:
        InvalidValue: on numbers of what there isn't.
    """
    arrays = named(contexts, examples)
    n_haptic, _, slots = contexts.cut.shape
    for name, most in (
        ("n_detectors", slots),
        ("ranges", N_BINS),
        ("example_next_haptic", n_haptic - 1),
        ("example_orientation", 1),
    ):
        found = state[name]
        if found.min() < 0 or found.max() > most:
            wrong = found.min() if found.min() < 0 else found.max()
            raise InvalidValue(name, int(wrong), f"0 to {most}")
    for name in ("count", "leaf_count", "present", "total", "example_added"):
        state_arrays.check_count(name, int(state[name].min()))
    for name, array in arrays.items():
        array[...] = state[name]
