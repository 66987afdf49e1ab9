"""Many trials on one recording, stepped at once."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action, ActionResult
from prospect_mj.recording.arrays import UNKNOWN
from prospect_mj.recording.choices import choice_sets, phases
from prospect_mj.recording.recording import Recording
from prospect_mj.recording.trial import not_recorded
from prospect_mj.supervisor.supervisor import Supervisor

Indices = NDArray[np.intp]


class BatchOutcome(NamedTuple):
    """What the actions of k trials did."""

    executed: NDArray[np.bool_]
    """(k,): whether each was run: neither refused, nor left for want of a look."""
    result: NDArray[np.object_]
    """(k,) of str: how each ended."""
    sim_seconds: NDArray[np.float64]
    """(k,): simulated time [s]."""


class RecordedBatch:
    """Where n trials are in a recording; each steps as a `RecordedTask` does.

    Args:
        recording: where the outcomes come from.
        supervisor: decides what the learner may choose from.
        n: number of trials.

    Attributes:
        recording: as given.
        shown: (n,) the presentation of each trial.
        node: (n,) where each trial is.
    """

    def __init__(self, recording: Recording, supervisor: Supervisor, n: int) -> None:
        """Put all trials at the first presentation."""
        self.recording = recording
        self._supervisor = supervisor
        self._choices = choice_sets(supervisor, recording.predicates.states)
        self.shown = np.zeros(n, np.intp)
        self.node = np.full(n, recording.presentations.root[0], np.intp)

    def begin(self, which: Indices, presentations: Indices) -> None:
        """Present the jar to some of the trials.

        Args:
            which: (k,) the trials.
            presentations: (k,) numbers of what is shown to each.
        """
        self.shown[which] = presentations
        self.node[which] = self.recording.presentations.root[presentations]

    def execute(self, which: Indices, actions: Indices) -> BatchOutcome:
        """Take over what actions led to; those that may not run change nothing.

        Args:
            which: (k,) the trials.
            actions: (k,) one of each.

        Raises:
            RecordingError: if an outcome is not recorded; no trial has moved then.
        """
        nodes, here = self.recording.nodes, self.node[which]
        led_to = nodes.child[here, actions]
        if (led_to == UNKNOWN).any():
            first = int(np.flatnonzero(led_to == UNKNOWN)[0])
            raise not_recorded(Action(actions[first]), nodes.depth[here[first]])
        ran = led_to != here
        self.node[which] = np.where(ran, nodes.situation[led_to], here)
        refused = str(ActionResult.NOT_ALLOWED)
        return BatchOutcome(
            ran & nodes.executed[led_to],
            np.where(ran, nodes.result[led_to].astype(object), refused),
            np.where(ran, nodes.sim_seconds[led_to], 0.0),
        )

    @property
    def lid(self) -> NDArray[np.int8]:
        """(n,) side of the lid, LEFT or RIGHT."""
        return self.recording.presentations.lid[self.shown]

    @property
    def holding(self) -> NDArray[np.int8]:
        """(n,) NONE, LEFT or RIGHT."""
        return self.recording.nodes.holding[self.node]

    @property
    def inserted(self) -> NDArray[np.bool_]:
        """(n,) whether the jar stands in the receptacle."""
        return self.recording.nodes.inserted[self.node]

    def action_masks(self, trials: NDArray[np.intp]) -> NDArray[np.int8]:
        """The choice sets (n, 6), 1 = may be chosen.

        Args:
            trials: (n,) number of each trial, from 0, for the schedule.
        """
        state = self.recording.nodes.predicates[self.node]
        return self._choices[phases(self._supervisor, trials), state]
