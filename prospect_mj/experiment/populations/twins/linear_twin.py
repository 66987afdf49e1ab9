"""`agent.LinearQ`, compiled."""

import numpy as np

from prospect_mj.agent import LinearQ
from prospect_mj.experiment.populations.kernels import linear
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.kernels.linear import LinearState
from prospect_mj.experiment.populations.twins.sight import sight
from prospect_mj.experiment.populations.twins.twin import Twin, never_split


def begin(learner: LinearQ, trials: Trials) -> LinearState:
    """The learner's own weights, and room for what is known in a trial."""
    n_actions, n_features = learner.weights.shape
    seen = sight(n_features)
    n_haptic = len(seen.bits)
    return LinearState(
        weights=learner.weights,
        step_size=learner.settings.step_size,
        bits=seen.bits,
        order=seen.order,
        spans=seen.spans,
        features=np.zeros((n_haptic, n_features)),
        values=np.empty((n_haptic, n_actions)),
        known=np.zeros(n_haptic, np.bool_),
    )


def end(learner: LinearQ, state: LinearState, n_updates: int) -> None:
    """The weights are the learner's own already."""
    learner.n_updates += n_updates


TWIN = Twin(begin, linear.run, end, lambda state: never_split(*state.values.shape))
