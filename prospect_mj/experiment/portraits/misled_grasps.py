"""Grasps of a jar that does not lie where the hand was told.

In a run almost every grasp balances at its first probe, as the jar has been seen
within a millimetre, and its portrait is a dot. Told a wrong pose, the hand has to
probe and correct its place, as in Coelho and Grupen (1997).
"""

from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass, replace
from itertools import cycle, islice, product

import numpy as np
from tqdm import tqdm

from prospect_mj.actions.belief import Belief, SeenJar
from prospect_mj.checks import check_number
from prospect_mj.experiment.portraits.grasp_phases import GraspPhases, grasps_of
from prospect_mj.experiment.run.config import TrainConfig
from prospect_mj.experiment.run.environment import make_environment
from prospect_mj.recording.hands import GRASPS
from prospect_mj.task.presentation import ORIENTATIONS


@dataclass(frozen=True)
class MisledSettings:
    """How wrong the pose is that the robot is told."""

    position_sd: float = 0.006
    """Standard deviation of the jar's place across its axis, in each direction [m]."""
    angle_sd: float = 0.05
    """Standard deviation of its axis' direction, about each axis across [rad]."""

    def __post_init__(self) -> None:
        """Refuse what no hand could close on."""
        check_number("deviation of the position", self.position_sd, 0, 0.02)
        check_number("deviation of the axis", self.angle_sd, 0, 0.2)


def grasp_misled(
    config: TrainConfig,
    n: int,
    rng: np.random.Generator,
    settings: MisledSettings | None = None,
) -> Iterator[GraspPhases]:
    """Simulate grasps of both orientations by both hands.

    Args:
        config: of a run, for the ways in which its hands move.
        n: how many.
        rng: draws presentations and errors.
        settings: how wrong the robot is told.

    Raises:
        RenderingUnavailable: if there is no OpenGL.
    """
    wrong = MisledSettings() if settings is None else settings
    live = replace(
        config,
        physics="live",
        recording=None,
        grow=False,
        supervisor="none",
        shaping=(),
    )
    trials = list(islice(cycle(product(ORIENTATIONS, GRASPS.values())), n))
    with closing(make_environment(live)) as env:
        watched = env.watch()
        for orientation, action in tqdm(
            trials, "grasping", unit="grasp", disable=None, leave=False
        ):
            watched.reset(orientation, rng)
            runner = watched.task.runner
            if runner.belief.seen is not None:
                runner.begin(Belief(_misplaced(runner.belief.seen, wrong, rng)))
            watched.execute(action)
            yield from grasps_of(watched.episode())


def _misplaced(
    seen: SeenJar, settings: MisledSettings, rng: np.random.Generator
) -> SeenJar:
    """A jar with errors across its axis; along it the fingers feel no difference."""
    shift = rng.normal(0.0, settings.position_sd, 3)
    shift -= (shift @ seen.axis) * seen.axis
    axis = seen.axis + np.cross(rng.normal(0.0, settings.angle_sd, 3), seen.axis)
    return SeenJar(seen.position + shift, axis / np.linalg.norm(axis))
