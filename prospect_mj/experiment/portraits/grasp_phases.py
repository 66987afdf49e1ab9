"""How far a closing hand was from balance, and how fast that changed.

Coelho and Grupen (1997) read the course of a grasp from the contacts' residual eps and
its rate. A rate is here the change since the last measurement over the time that has
passed, so that it is the controller's own (`control.grasp.Probe.rate`) while the
fingers touch; from one probe to the next it is that of the correction between them,
which the controller doesn't ask for.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from prospect_mj.control.controller import CONTROL_PERIOD
from prospect_mj.control.grasp import GraspController
from prospect_mj.control.result import Status
from prospect_mj.episodes.episode import QUANTITIES, ControllerSpan, Episode
from prospect_mj.experiment.paper.measures.bootstrap import Floats
from prospect_mj.robot.names import SIDES

_RESIDUAL = QUANTITIES.index("residual")

End = Literal["lid", "body"]


@dataclass(frozen=True, eq=False)
class GraspPhases:
    """One run of a grasp controller: m measurements with all fingertips in touch."""

    end: End
    """What the hand closed on."""
    status: Status
    """How it came out."""
    times: Floats
    """(m,) [s]."""
    residual: Floats
    """(m,), eps [1]."""

    @property
    def phases(self) -> Floats:
        """(m - 1, 2), eps [1] and d eps/dt [1/s]; empty without two measurements."""
        if self.times.size < 2:
            return np.empty((0, 2))
        rate = np.diff(self.residual) / np.diff(self.times)
        return np.column_stack([self.residual[1:], rate])

    @property
    def probes(self) -> int:
        """How often the hand touched; in between it corrected its place."""
        if not self.times.size:
            return 0
        return 1 + int(np.sum(np.diff(self.times) > 1.5 * CONTROL_PERIOD))


def grasps_of(episode: Episode) -> Iterator[GraspPhases]:
    """Every run of a grasp controller in an episode, those within swaps among them."""
    for action in episode.actions:
        for span in action.controllers:
            if span.name == GraspController.__name__:
                yield _grasp(episode, span)


def _grasp(episode: Episode, span: ControllerSpan) -> GraspPhases:
    times = episode.signals.times
    residual = episode.signals.measured[:, SIDES.index(span.side), _RESIDUAL]
    # Sums of periods are not exact: half of one is room for that.
    since, until = span.start - CONTROL_PERIOD / 2, span.end - CONTROL_PERIOD / 2
    mine = (times > since) & (times < until) & np.isfinite(residual)
    # A hand takes the jar by the end on its own side, and a swap doesn't turn it.
    end: End = "lid" if span.side == episode.presentation.orientation else "body"
    return GraspPhases(end, span.status, times[mine], residual[mine].astype(np.float64))
