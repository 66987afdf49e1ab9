"""What controllers, sensors and learner measured, as curves in panels.

Only what there is something of becomes a curve, and only panels with curves are shown.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from prospect_mj.actions.action import Action
from prospect_mj.episodes.episode import QUANTITIES, Episode
from prospect_mj.replay import colours
from prospect_mj.replay.colours import Colour
from prospect_mj.replay.playback import Frames
from prospect_mj.robot.names import SIDES

IK_POSITION, IK_ANGLE = "ik_error/position", "ik_error/angle"
WAY_LEFT, JOINT_ERROR = "way_left", "joint_error"
RESIDUAL = "grasp_residual"
WRIST, INSERTION = "forces/wrist", "forces/insertion"
FINGERTIPS = "forces/fingertips"
Q_VALUES = "q_values"


@dataclass(frozen=True, eq=False)
class Curve:
    """A quantity over time."""

    name: str
    colour: Colour
    times: NDArray[np.float64]
    """(n,) [s], from the beginning of the episode."""
    values: NDArray[np.float64]
    """(n,), NaN where there is none."""
    steps: bool = False
    """Whether it stays as it is until the next value."""
    dots: bool = False
    """Whether it is drawn as dots, as there are few values."""

    @property
    def is_empty(self) -> bool:
        """Whether there is no value at all."""
        return bool(np.isnan(self.values).all())


@dataclass(frozen=True, eq=False)
class Panel:
    """Curves that are drawn together."""

    origin: str
    """Path of its entities."""
    title: str
    curves: tuple[Curve, ...]


@dataclass(frozen=True)
class _Measured:
    """Where and how something that controllers measure is drawn."""

    quantity: str
    origin: str
    title: str
    scale: float = 1.0
    """Of what is drawn per unit of the quantity."""


_MEASURED = (
    _Measured("position_error", IK_POSITION, "IK position error [mm]", 1e3),
    _Measured("angle_error", IK_ANGLE, "IK angle error [deg]", np.rad2deg(1)),
    _Measured("way_left", WAY_LEFT, "Way left of the plan [rad]"),
    _Measured("joint_error", JOINT_ERROR, "Joint error [deg]", np.rad2deg(1)),
    _Measured("contact_force", INSERTION, "Insertion force [N]"),
)


def panels(
    episode: Episode, frames: Frames, q_values: NDArray[np.float64] | None
) -> tuple[Panel, ...]:
    """All panels in which there is something to be seen.

    Args:
        episode: what happened.
        frames: its states, played back.
        q_values: the learner's estimates (a, 6) before each action; None: no learner.
    """
    found = [
        *(
            Panel(one.origin, one.title, _of_arms(episode, one.quantity, one.scale))
            for one in _MEASURED
        ),
        Panel(RESIDUAL, "Grasp residual [1]", _residual(episode, frames)),
        Panel(FINGERTIPS, "Fingertip force [N]", _fingertips(frames)),
        Panel(WRIST, "Wrist force [N]", _wrist(episode, frames)),
    ]
    if q_values is not None:
        found.append(Panel(Q_VALUES, "Q-values", tuple(_values(episode, q_values))))
    return tuple(panel for panel in found if panel.curves)


def _filled(curves: Iterator[Curve]) -> tuple[Curve, ...]:
    return tuple(curve for curve in curves if not curve.is_empty)


def _of_arms(episode: Episode, quantity: str, scale: float = 1.0) -> tuple[Curve, ...]:
    """What the controllers of each arm measured of one quantity, scaled."""
    times = episode.signals.times - episode.states.times[0]
    measured = episode.signals.measured[:, :, QUANTITIES.index(quantity)]
    values = scale * measured.astype(np.float64)
    return _filled(
        Curve(side, colours.ARMS[side], times, values[:, arm])
        for arm, side in enumerate(SIDES)
    )


def _dots(curves: Iterable[Curve], name: str) -> tuple[Curve, ...]:
    """The same as dots, which are named beside the arm."""
    return tuple(replace(c, name=f"{c.name} {name}", dots=True) for c in curves)


def _per_arm(frames: Frames, values: NDArray[np.float64]) -> tuple[Curve, ...]:
    """What follows from the states for each arm; values is (n, 2)."""
    return _filled(
        Curve(side, colours.ARMS[side], frames.times, values[:, arm])
        for arm, side in enumerate(SIDES)
    )


def _residual(episode: Episode, frames: Frames) -> tuple[Curve, ...]:
    """That of all contacts, and as dots what the grasp controllers judged by."""
    judged = _dots(_of_arms(episode, "residual"), "probe")
    return (*_per_arm(frames, frames.residuals), *judged)


def _fingertips(frames: Frames) -> tuple[Curve, ...]:
    """Sum over the three tips of a hand."""
    return _per_arm(frames, frames.touch_forces.sum(axis=2))


def _wrist(episode: Episode, frames: Frames) -> tuple[Curve, ...]:
    """Its norm, and as dots the vertical part of it that was weighed."""
    weighed = _dots(_of_arms(episode, "load"), "weighing")
    return (*_per_arm(frames, frames.wrist_forces), *weighed)


def _values(episode: Episode, q_values: NDArray[np.float64]) -> Iterator[Curve]:
    start, end = episode.states.times[[0, -1]]
    begun: Sequence[float] = [span.start - start for span in episode.actions]
    # Once more at the end, or the last one would be a point.
    times = np.array([*begun, end - start])
    for action in Action:
        values = np.append(q_values[:, action], q_values[-1:, action])
        colour = colours.of_action(action.label)
        yield Curve(action.label, colour, times, values, steps=True)
