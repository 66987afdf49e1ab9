"""The values of all contexts: looked up, and estimated anew when a context splits."""

import numpy as np
from numpy.typing import NDArray

from prospect_mj.agent.discovery.contexts import Contexts
from prospect_mj.agent.discovery.detector import BETTER, WORSE, Detector
from prospect_mj.agent.discovery.examples import Context, Example, Examples
from prospect_mj.agent.settings import DiscoverySettings


class Values:
    """What is expected of every action.

    Args:
        settings: the learner's.
        contexts: values and detectors, changed by splits.
        examples: what is remembered.
    """

    def __init__(
        self, settings: DiscoverySettings, contexts: Contexts, examples: Examples
    ) -> None:
        """Nothing has been looked up yet."""
        self._settings, self._contexts = settings, contexts
        self._examples = examples

    def of(
        self, haptic: int, picture: NDArray[np.float64], orientation: int
    ) -> NDArray[np.float64]:
        """The values of all actions in a haptic state, (n_actions,) [actions].

        Args:
            haptic: number of the haptic state.
            picture: c, (101,) [1].
            orientation: side of the lid; only forced splits know it.
        """
        known, n_actions = self._contexts, self._settings.n_actions
        contexts = [(haptic, action) for action in range(n_actions)]
        leaves = [known.leaf(one, picture, orientation) for one in contexts]
        return np.array(list(map(known.value, contexts, leaves)))

    def target(self, example: Example) -> float:
        """What an example brings by the values of today [actions]."""
        reward = float(example.reward)
        if example.terminated:
            return reward
        haptic, orientation = int(example.next_haptic), int(example.orientation)
        values = self.of(haptic, example.picture, orientation)[example.allowed]
        return reward + self._settings.discount * float(values.max())

    def split(self, context: Context, detectors: list[Detector], trial: int) -> None:
        """Split a context, or split it in another way.

        Args:
            context: which.
            detectors: all that it has from now on; none: it is told the orientation.
            trial: number of the present one.
        """
        known = self._contexts
        was_split = known.is_split(context) and not known.lent[context]
        known.put(context, detectors)
        known.told[context], known.lent[context] = not detectors, False
        if known.first_split[context] < 0:
            known.first_split[context] = trial
        if not was_split:
            known.inherit(context)
        if self._settings.revalue == "inherit":
            return
        if not was_split:
            # Of a leaf without examples nothing is known: its first target replaces it.
            known.leaf_count[context] = 0
        self._revalue(context)

    def lend(self, lender: Context, found: Detector, trial: int) -> None:
        """Split all other contexts by the detector of one, values as they were."""
        known = self._contexts
        for context in np.ndindex(known.mean.shape):
            if context != lender:
                known.put(context, [found])
                known.lent[context], known.first_split[context] = True, trial
                known.inherit(context)

    def _revalue(self, context: Context) -> None:
        """Let a leaf be the mean of its remembered examples, if it has any."""
        is_stale = self._settings.revalue == "stored"
        total, number = [0.0, 0.0], [0, 0]
        for example in self._examples.of(context):
            leaf = self._contexts.leaf(context, example.picture, example.orientation)
            total[leaf] += float(example.target) if is_stale else self.target(example)
            number[leaf] += 1
        for leaf in (WORSE, BETTER):
            if number[leaf]:
                place = *context, leaf
                self._contexts.leaf_value[place] = total[leaf] / number[leaf]
                self._contexts.leaf_count[place] = number[leaf]
