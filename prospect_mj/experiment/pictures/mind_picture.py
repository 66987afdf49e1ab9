"""The README's picture of what a run has learned: which grey levels decide."""

from collections.abc import Callable

from prospect_mj.experiment.pictures.recorded_run import recorded_run
from prospect_mj.experiment.portraits.portfolio import weights_of

TRIALS = 1000
"""Of the run."""
STEPS = 2
"""Learning and drawing."""


def mind_picture(tick: Callable[[], object], trials: int = TRIALS) -> bytes:
    """What `prospect plot` draws of the weights of a run on recorded physics, as PNG.

    Args:
        tick: called after each of the `STEPS`.
        trials: of the run.
    """
    with recorded_run(trials) as run:
        tick()
        content = weights_of(run, {})
    tick()
    return content
