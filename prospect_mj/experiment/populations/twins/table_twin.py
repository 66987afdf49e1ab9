"""`agent.TableQ`, compiled."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent import TableQ
from prospect_mj.experiment.populations.kernels import table
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.kernels.ring import new_ring
from prospect_mj.experiment.populations.kernels.table import TableState
from prospect_mj.experiment.populations.twins.remembered import experience
from prospect_mj.experiment.populations.twins.twin import Twin, never_split


def begin(learner: TableQ, trials: Trials) -> TableState:
    """The learner's own values, and nothing remembered."""
    settings = learner.settings
    capacity = settings.buffer if settings.replays else 0
    return TableState(
        values=learner.values,
        step_size=settings.step_size,
        seen=learner.seen,
        copies=settings.copied_habit,
        mended=_mended(learner),
        ring=new_ring(
            capacity, settings.n_actions, settings.replays, settings.replays_forget
        ),
    )


def _mended(learner: TableQ) -> NDArray[np.float64]:
    """(2, h, 6) [actions]: what is known beforehand, NaN elsewhere."""
    mended = np.full(learner.values.shape, np.nan)
    if learner.settings.known_correction:
        for orientation, values in enumerate(mended):
            learner.correct(values, orientation)
    return mended


def end(learner: TableQ, state: TableState, n_updates: int) -> None:
    """Let the learner remember what the ring does; the values are its own already."""
    learned = {
        "values": state.values,
        "seen": state.seen,
        "n_updates": np.array(learner.n_updates + n_updates),
    }
    if learner.settings.replays:
        ring = state.ring
        left = np.stack([ring.shown, ring.haptic], axis=1)
        reached = np.stack([ring.shown, ring.follows], axis=1)
        learned |= experience(ring, left, reached)
    learner.restore(learned)


TWIN = Twin(begin, table.run, end, lambda state: never_split(*state.values.shape[1:]))
