"""The learner: state features and linear action values; it knows no robot."""

from prospect_mj.agent.features import FeatureSettings, StateFeatureGenerator
from prospect_mj.agent.linear_q import LinearQ
from prospect_mj.agent.settings import LearnerSettings

__all__ = ["FeatureSettings", "LearnerSettings", "LinearQ", "StateFeatureGenerator"]
