"""Models of grasps by which the lid and the body of the standard jar can be told."""

from prospect_mj.haptics import TrajectoryModels


def models(*residuals: float, deviation: float = 0.002) -> TrajectoryModels:
    """A model about each residual [1], nearly at rest, all alike else."""
    n = len(residuals)
    return TrajectoryModels(
        weight=(1 / n,) * n,
        mean=tuple(((residual, 0.0), (residual, 0.0)) for residual in residuals),
        deviation=(((deviation, 0.01), (deviation, 0.01)),) * n,
    )


THREE = models(0.005, 0.009, 0.013)
