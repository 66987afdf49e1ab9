"""`agent.ReplayQ`, compiled."""

import numpy as np

from prospect_mj.agent import ReplayQ
from prospect_mj.experiment.populations.kernels import replay
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.kernels.replay import ReplayState
from prospect_mj.experiment.populations.kernels.ring import new_ring
from prospect_mj.experiment.populations.twins.remembered import experience
from prospect_mj.experiment.populations.twins.sight import sight
from prospect_mj.experiment.populations.twins.twin import Twin, never_split


def begin(learner: ReplayQ, trials: Trials) -> ReplayState:
    """The learner's own weights, room for all features, and nothing remembered."""
    settings, n_images = learner.settings, len(trials.visual)
    seen = sight(settings.n_features)
    return ReplayState(
        weights=learner.weights,
        step_size=settings.step_size,
        bits=seen.bits,
        order=seen.order,
        spans=seen.spans,
        features=np.zeros((n_images, len(seen.bits), settings.n_features)),
        known=np.zeros(n_images, np.bool_),
        values=np.empty(settings.n_actions),
        ring=new_ring(
            settings.buffer,
            settings.n_actions,
            settings.replays,
            settings.replays_forget,
        ),
    )


def end(learner: ReplayQ, state: ReplayState, n_updates: int) -> None:
    """Let the learner remember what the ring does."""
    ring = state.ring
    left = state.features[ring.shown, ring.haptic]
    reached = state.features[ring.shown, ring.follows]
    learner.restore(
        {
            "weights": state.weights,
            "n_updates": np.array(learner.n_updates + n_updates),
            **experience(ring, left, reached),
        }
    )


TWIN = Twin(
    begin,
    replay.run,
    end,
    lambda state: never_split(len(state.bits), len(state.weights)),
)
