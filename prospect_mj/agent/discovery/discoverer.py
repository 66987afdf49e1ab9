"""What is made of a surprise: contexts split where a feature explains it."""

from typing import NamedTuple

import numpy as np

from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.detector import BETTER, WORSE, Detector
from prospect_mj.agent.discovery.examples import Context, Example, Examples
from prospect_mj.agent.discovery.search import KEPT, Puzzle, Search
from prospect_mj.agent.discovery.values import Values
from prospect_mj.agent.settings import DiscoverySettings


class Visit(NamedTuple):
    """A step of a trial in a context that the trial had not been in before."""

    context: Context
    example: Example
    leaf: int
    """That the picture was in, or WHOLE."""
    predicted: float
    """[actions], the value of that leaf before anything was learned from the step."""
    mean_before: float
    """[actions], the context's mean before that."""
    step: int
    """Number of the step in its trial."""


class Discoverer:
    """Remembers what is telling, and finds features where something is a surprise.

    Args:
        settings: the learner's.
        contexts: values and detectors.
        examples: where what is telling goes.
        values: of the contexts.
    """

    def __init__(
        self,
        settings: DiscoverySettings,
        contexts: Contexts,
        examples: Examples,
        values: Values,
    ) -> None:
        """Nothing has been a surprise yet."""
        self._settings, self._contexts, self._examples = settings, contexts, examples
        self._values = values
        self._search = Search(settings, contexts, examples)

    def consider(
        self, visit: Visit, outcome: float, trial: int, rng: np.random.Generator
    ) -> None:
        """Remember a visit if it is telling; explain it if it is a surprise.

        Args:
            visit: what was done, when its trial has ended.
            outcome: what it is judged by [actions].
            trial: number of that trial.
            rng: draws new features.
        """
        settings, surprise = self._settings, self._settings.surprise
        kind = BETTER if outcome > visit.mean_before else WORSE
        is_telling = abs(outcome - visit.mean_before) > surprise / 2.0
        if is_telling or settings.cache == "all":
            self._examples.add(visit.context, kind, visit.example)
        if settings.forced_splits:
            return
        found = None
        if abs(outcome - visit.predicted) > surprise:
            puzzle = Puzzle(visit.context, kind, visit.example.picture)
            found = self._explanation(puzzle, rng)
        elif settings.expert_phase:
            found = self._refinement(visit.context, rng)
        if found is not None:
            self._adopt(visit.context, found, trial)

    def _explanation(self, puzzle: Puzzle, rng: np.random.Generator) -> Detector | None:
        """A detector that puts an example into its class, if those there do not."""
        context, known = puzzle.context, self._contexts
        required = self._search.required(context)
        if required >= 1.0:
            return None
        if known.lent[context]:
            # One of its own would change no value.
            if self._settings.revalue == "inherit":
                return None
        else:
            known.put(context, self._search.renewed(context, KEPT * required))
            if known.is_split(context):
                is_right = known.leaf(context, puzzle.picture, 0) == puzzle.kind
                if is_right or not self._settings.search_after_first:
                    return None
        return self._search.explanation(puzzle, required, rng)

    def _refinement(
        self, context: Context, rng: np.random.Generator
    ) -> Detector | None:
        """Piater's expert phase: where nothing is wrong, more is required.

        One feature is drawn; its distance must be more than half-way from the largest
        one there to 1.
        """
        known = self._contexts
        if known.lent[context] or not known.is_split(context):
            return None
        best = max(one.distance for one in known.detectors(context))
        required = max(self._search.required(context), (best + 1.0) / 2.0)
        if required >= 1.0:
            return None
        drawn = self._search.novelty(context, rng)
        return drawn if drawn.distance > required else None

    def _adopt(self, context: Context, found: Detector, trial: int) -> None:
        """Split a context by a detector, too; the weakest gives way if need be."""
        known = self._contexts
        own = [] if known.lent[context] else known.detectors(context)
        if len(own) < self._settings.features_per_context:
            own.append(found)
        else:
            weakest = min(range(len(own)), key=lambda slot: own[slot].distance)
            if found.distance <= own[weakest].distance:
                return
            own[weakest] = found
        is_first = bool((known.first_split < 0).all())
        self._values.split(context, own, trial)
        if is_first and self._settings.share_first:
            self._values.lend(context, found, trial)
