"""Haptic categories: models of how grasps feel, and recognising one during a grasp.

After Coelho, Piater and Grupen (Developing haptic and visual perceptual categories for
reaching and grasping with a humanoid robot, Robotics and Autonomous Systems 37, 2001):
what a grasp controller goes through is a path in the phase portrait of its residual and
the residual's rate; such paths are clustered into a few models, and the chance of each
model is computed while a grasp runs.
"""

from prospect_mj.haptics.agreement import Agreement, agreement
from prospect_mj.haptics.category import CategoryRecogniser
from prospect_mj.haptics.clustering import ClusterSettings, Fit, fit
from prospect_mj.haptics.models import TrajectoryModels, categories
from prospect_mj.haptics.phase_portrait import phase_samples

__all__ = [
    "Agreement",
    "CategoryRecogniser",
    "ClusterSettings",
    "Fit",
    "TrajectoryModels",
    "agreement",
    "categories",
    "fit",
    "phase_samples",
]
