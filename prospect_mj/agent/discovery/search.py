"""The search for a feature that tells the classes of a context apart."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.detector import (
    BETTER,
    WORSE,
    Detector,
    detector,
    likelier_class,
    required_distance,
)
from prospect_mj.agent.discovery.examples import Context, Examples
from prospect_mj.agent.discovery.feature import Feature, draw
from prospect_mj.agent.settings import DiscoverySettings

KEPT = 0.75
"""A detector is dropped where its distance is below this part of the required one."""
_LEAST_EXAMPLES = 2
"""Of either class, to speak of a distribution."""


class Puzzle(NamedTuple):
    """An example that isn't understood."""

    context: Context
    kind: int
    """The class that it is of, WORSE or BETTER."""
    picture: NDArray[np.float64]
    """c, (101,) [1]."""


class Search:
    """Finds detectors in what is remembered.

    Args:
        settings: the learner's.
        contexts: where features may be known already.
        examples: what is remembered.
    """

    def __init__(
        self, settings: DiscoverySettings, contexts: Contexts, examples: Examples
    ) -> None:
        """Search for nothing yet."""
        self._settings, self._contexts = settings, contexts
        self._examples = examples

    def required(self, context: Context) -> float:
        """The distance that counts in a context; 1 or more with too few examples."""
        numbers = [self._examples.number(context, kind) for kind in (WORSE, BETTER)]
        if min(numbers) < _LEAST_EXAMPLES:
            return np.inf
        return required_distance(*numbers, self._settings.guard_probability)

    def renewed(self, context: Context, least: float) -> list[Detector]:
        """A context's detectors by the examples of today: those that are good enough.

        Args:
            context: whose.
            least: distance that each must have.
        """
        features = [one.feature for one in self._contexts.detectors(context)]
        return [
            one for one in self._detectors(context, features) if one.distance >= least
        ]

    def explanation(
        self, puzzle: Puzzle, required: float, rng: np.random.Generator
    ) -> Detector | None:
        """The best detector that puts an example into its class, if there is any.

        Features of other contexts come first, and only if none of them will do are new
        ones drawn.

        Args:
            puzzle: the example.
            required: distance that the detector must exceed.
            rng: draws the new features.
        """
        found = None
        if self._settings.reuse:
            known = self._known_elsewhere(puzzle.context)
            found = self._best(puzzle, known, required)
        if found is None:
            new = [draw(rng) for _ in range(self._settings.candidates)]
            found = self._best(puzzle, new, required)
        return found

    def novelty(self, context: Context, rng: np.random.Generator) -> Detector:
        """A new feature, drawn without any reason."""
        (drawn,) = self._detectors(context, [draw(rng)])
        return drawn

    def _best(
        self, puzzle: Puzzle, features: Sequence[Feature], required: float
    ) -> Detector | None:
        """That of the largest distance, of equal ones the first."""
        best = None
        for one in self._detectors(puzzle.context, features):
            is_better = one.distance > (best.distance if best else required)
            if is_better and likelier_class([one], puzzle.picture) == puzzle.kind:
                best = one
        return best

    def _known_elsewhere(self, context: Context) -> list[Feature]:
        """Features found in other contexts, without those that this one has itself."""
        here = [] if self._contexts.lent[context] else self._features(context)
        return [
            feature
            for other in np.ndindex(self._contexts.mean.shape)
            if other != context and not self._contexts.lent[other]
            for feature in self._features(other)
            if feature not in here
        ]

    def _features(self, context: Context) -> list[Feature]:
        return [one.feature for one in self._contexts.detectors(context)]

    def _detectors(
        self, context: Context, features: Iterable[Feature]
    ) -> list[Detector]:
        worse = self._examples.pictures(context, WORSE)
        better = self._examples.pictures(context, BETTER)
        return [detector(feature, worse, better) for feature in features]
