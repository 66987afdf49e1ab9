"""Recognising the category of a grasp while it runs."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import InvalidValue
from prospect_mj.haptics.models import TrajectoryModels
from prospect_mj.haptics.phase_portrait import phase_samples


class CategoryRecogniser:
    """Chances of the models, renewed with every sample of a grasp.

    Args:
        models: the categories.
    """

    def __init__(self, models: TrajectoryModels) -> None:
        """Begin with nothing felt."""
        self._models = models
        self._last: tuple[float, float] | None = None
        self._probe = 0.0
        self._log_odds = np.log(models.weight)

    def feel(self, seconds: float, residual: float) -> NDArray[np.float64]:
        """Take in what the fingertips tell in one control period.

        Args:
            seconds: time since the hand closes [s]; later than of the sample before.
            residual: eps [1].

        Returns:
            (K,), the chance of each model.

        Raises:
            InvalidValue: if the time is not later, or a number is not finite.
        """
        if not np.isfinite([seconds, residual]).all():
            raise InvalidValue("sample", (seconds, residual), "finite numbers")
        now = seconds, residual
        known = [now] if self._last is None else [self._last, now]
        sample = phase_samples(np.array(known))[-1:] + [0.0, 0.0, self._probe]
        self._last, self._probe = now, float(sample[0, 2])
        self._log_odds = self._log_odds + self._models.log_likelihoods(sample)[0]
        return self.chances

    @property
    def chances(self) -> NDArray[np.float64]:
        """(K,): of each model; their weights before anything is felt."""
        odds = np.exp(self._log_odds - self._log_odds.max())
        return odds / odds.sum()

    @property
    def category(self) -> int:
        """The most likely model."""
        return int(np.argmax(self._log_odds))
