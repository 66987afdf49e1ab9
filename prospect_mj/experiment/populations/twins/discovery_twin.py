"""`agent.discovery.DiscoveryQ`, compiled."""

import numpy as np

from prospect_mj.agent.discovery import DiscoveryQ
from prospect_mj.agent.discovery.detector import guard_scale
from prospect_mj.agent.discovery.forced import forced_after
from prospect_mj.agent.features import N_BINS
from prospect_mj.agent.settings import DiscoverySettings
from prospect_mj.experiment.populations.kernels import discovery
from prospect_mj.experiment.populations.kernels.discovery_state import (
    DiscoveryState,
    Options,
    PresentTrial,
    Visits,
)
from prospect_mj.experiment.populations.kernels.graph import Trials
from prospect_mj.experiment.populations.twins.twin import Twin


def begin(learner: DiscoveryQ, trials: Trials) -> DiscoveryState:
    """The learner's own contexts and examples, and room for a trial."""
    settings = learner.settings
    return DiscoveryState(
        contexts=learner.contexts,
        examples=learner.examples,
        forced_after=forced_after(settings),
        options=_options(settings),
        visits=_visits(settings),
        sight=_sight(settings),
        n_trials=np.array([learner.n_trials]),
    )


def end(learner: DiscoveryQ, state: DiscoveryState, n_updates: int) -> None:
    """Count; contexts and examples are the learner's own already."""
    learner.n_updates += n_updates
    learner.n_trials = int(state.n_trials[0])


def _options(settings: DiscoverySettings) -> Options:
    return Options(
        least_rate=float(settings.least_rate),
        surprise=float(settings.surprise),
        guard_scale=guard_scale(settings.guard_probability),
        candidates=settings.candidates,
        reuse=settings.reuse,
        search_after_first=settings.search_after_first,
        expert_phase=settings.expert_phase,
        inherits=settings.revalue == "inherit",
        stored=settings.revalue == "stored",
        by_return=settings.labels == "return",
        caches_all=settings.cache == "all",
        share_first=settings.share_first,
        is_forced=bool(settings.forced_splits),
    )


def _visits(settings: DiscoverySettings) -> Visits:
    most = settings.n_haptic * settings.n_actions
    return Visits(
        context=np.zeros((most, 2), np.int64),
        leaf=np.zeros(most, np.int64),
        predicted=np.zeros(most),
        mean_before=np.zeros(most),
        target=np.zeros(most),
        step=np.zeros(most, np.int64),
        next_haptic=np.zeros(most, np.int64),
        terminated=np.zeros(most, np.bool_),
        allowed=np.zeros((most, settings.n_actions), np.bool_),
    )


def _sight(settings: DiscoverySettings) -> PresentTrial:
    shape = settings.n_haptic, settings.n_actions
    return PresentTrial(
        picture=np.zeros(N_BINS + 1),
        orientation=np.zeros(1, np.int64),
        leaf=np.zeros(shape, np.int64),
        is_visited=np.zeros(shape, np.bool_),
        values=np.zeros(settings.n_actions),
        strengths=np.zeros((2, settings.memory)),
    )


TWIN = Twin(begin, discovery.run, end, lambda state: state.contexts.first_split)
