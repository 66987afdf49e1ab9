"""The learners and the state features; they know no robot."""

from prospect_mj.agent.features import FeatureSettings, StateFeatureGenerator
from prospect_mj.agent.learner import Learner
from prospect_mj.agent.learners import new_learner
from prospect_mj.agent.linear_q import LinearQ
from prospect_mj.agent.observation import Observation, Transition
from prospect_mj.agent.replay_q import ReplayQ
from prospect_mj.agent.settings import (
    AnyLearnerSettings,
    DiscoverySettings,
    LinearSettings,
    ReplaySettings,
    TableSettings,
)
from prospect_mj.agent.table_q import TableQ

__all__ = [
    "AnyLearnerSettings",
    "DiscoverySettings",
    "FeatureSettings",
    "Learner",
    "LinearQ",
    "LinearSettings",
    "Observation",
    "ReplayQ",
    "ReplaySettings",
    "StateFeatureGenerator",
    "TableQ",
    "TableSettings",
    "Transition",
    "new_learner",
]
