"""Many recorded trials at once: what `Trials` is of one, with arrays for values.

They step by `RecordedBatch`, which looks every outcome up where `RecordedTask` does.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from prospect_mj.agent.features import StateFeatureGenerator
from prospect_mj.agent.haptics import LEFT, NONE, RIGHT, haptic_states
from prospect_mj.envs.observation import FeatureObserver
from prospect_mj.envs.reset_options import ResetOptions
from prospect_mj.envs.settings import PickPlaceSettings
from prospect_mj.envs.tasks import load_recording, make_supervisor
from prospect_mj.envs.touch import NO_CATEGORY
from prospect_mj.envs.trials import drawn_orientation
from prospect_mj.recording.batch import RecordedBatch
from prospect_mj.recording.felt import category_of_nodes
from prospect_mj.recording.hands import hand_of
from prospect_mj.recording.presenter import Presenter
from prospect_mj.recording.recording import Recording

Indices = NDArray[np.intp]

_NAMES = np.array([hand_of(hand) or "none" for hand in (NONE, LEFT, RIGHT)], object)
"""Of a hand, or of the side on which the lid lies, by its number."""


class VectorTrials:
    """n trials on one recording.

    Args:
        settings: of the environment.
        n: number of trials.

    Attributes:
        space: where one trial's observations lie.
    """

    def __init__(self, settings: PickPlaceSettings, n: int) -> None:
        """Load the recording.

        Raises:
            RecordingError: if it can't be had, or is of other physics.
        """
        recording = load_recording(settings)
        self.space: spaces.Box = FeatureObserver(
            settings.features, settings.categories
        ).space
        self._presenter = Presenter(recording, settings.max_actions)
        self._batch = RecordedBatch(recording, make_supervisor(settings), n)
        self._category = _categories(recording, settings)
        self._haptic = haptic_states(
            recording.nodes.holding, self._category, settings.categories
        )
        self._features = _feature_table(recording, settings)
        self._looks = recording.presentations.look.astype(object)
        self._max_actions = settings.max_actions
        self._trial = np.full(n, -1)
        self._n_actions = np.zeros(n, np.intp)
        self._executed = np.zeros(n, bool)
        self._result = np.full(n, None, object)
        self._sim_seconds = np.zeros(n)

    @property
    def begun(self) -> NDArray[np.bool_]:
        """(n,): whether a trial has ever begun."""
        return self._trial >= 0

    def begin(
        self, which: Indices, told: ResetOptions, rngs: Sequence[np.random.Generator]
    ) -> None:
        """Present the jar to some of the trials.

        Args:
            which: (k,) the trials.
            told: what the agent wants of all of them.
            rngs: (n,) draw the rest, each for its trial.
        """
        shown = [self._drawn(told, rngs[trial]) for trial in which]
        self._batch.begin(which, np.array(shown, np.intp))
        counted = self._trial[which] + 1
        self._trial[which] = counted if told.trial is None else told.trial
        self._n_actions[which] = 0
        self._executed[which], self._sim_seconds[which] = False, 0.0
        self._result[which] = self._looks[self._batch.shown[which]]

    def _drawn(self, told: ResetOptions, rng: np.random.Generator) -> int:
        orientation = told.orientation or drawn_orientation(rng)
        return self._presenter.draw(orientation, rng)

    def act(
        self, which: Indices, actions: Indices
    ) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Run an action in some of the trials.

        Args:
            which: (k,) the trials.
            actions: (k,) one for each.

        Returns:
            Whether each was terminated (k,) and truncated (k,).
        """
        done = self._batch.execute(which, actions)
        self._executed[which] = done.executed
        self._result[which] = done.result
        self._sim_seconds[which] = done.sim_seconds
        self._n_actions[which] += 1
        terminated = self._batch.inserted[which]
        cut_off = self._n_actions[which] >= self._max_actions
        return terminated, cut_off & ~terminated

    def observe(self) -> NDArray[np.float64]:
        """The features of every trial (n, n_features)."""
        return self._features[self._batch.shown, self._haptic[self._batch.node]]

    def choice_sets(self) -> NDArray[np.int8]:
        """What may be chosen in every trial (n, 6), 1 = may be chosen."""
        return self._batch.action_masks(np.maximum(self._trial, 0))

    def infos(self, known: NDArray[np.bool_]) -> dict[str, Any]:
        """What is told of every trial, under each key an array over trials.

        Args:
            known: (n,) for which it holds; the mask under each `_key`.
        """
        told = {
            "action_mask": self.choice_sets(),
            "orientation": _NAMES[self._batch.lid],
            "holding": _NAMES[self._batch.holding],
            "category": self._category[self._batch.node],
            "executed": self._executed.copy(),
            "result": self._result.copy(),
            "sim_seconds": self._sim_seconds.copy(),
            "inserted": self._batch.inserted,
        }
        return told | {f"_{key}": known.copy() for key in told}


def _categories(recording: Recording, settings: PickPlaceSettings) -> NDArray[np.int64]:
    """(n,): what is told of the grasp in every node of a recording."""
    holding = recording.nodes.holding
    nothing = np.full(len(holding), NO_CATEGORY)
    if settings.haptic_models is None:
        return nothing
    category = category_of_nodes(recording, settings.haptic_models)
    return np.where(holding == NONE, nothing, category)


def _feature_table(
    recording: Recording, settings: PickPlaceSettings
) -> NDArray[np.float64]:
    """The features (p, h, n_features) of all presentations and h haptic states."""
    generator = StateFeatureGenerator(settings.features, settings.categories)
    return np.array(
        [
            [generator.generate(histogram, *state) for state in generator.states]
            for histogram in recording.presentations.histogram
        ]
    )
