"""Reaches along streamlines on pairs of start and goal, and how long planning took."""

import functools
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple
from unittest import mock

import mink
import numpy as np
from joblib import Parallel, delayed
from reach_pairs import SCENE, ReachPair
from reach_runs import Reach, run

from prospect_mj.control.arm_control import ArmControl
from prospect_mj.control.harmonic_motion import HarmonicReach
from prospect_mj.planning import harmonic_field
from prospect_mj.planning.gross_plan import GrossPlan
from prospect_mj.planning.planner import GrossPlanner
from prospect_mj.planning.surroundings import JarShape, KnownJars

JAR = JarShape(SCENE.props.jar.lid_radius, SCENE.props.jar.length)
NO_JAR = KnownJars(JAR)


@dataclass
class Clock:
    """Adds up the time that calls of a function take [s]."""

    seconds: float = 0.0

    def __call__(self, function):
        @functools.wraps(function)
        def timed(*arguments):
            begun = time.perf_counter()
            try:
                return function(*arguments)
            finally:
                self.seconds += time.perf_counter() - begun

        return timed


class Planning(NamedTuple):
    """What one plan took."""

    seconds: float
    solver: float
    """The part of it in the solver of Laplace's equation [s]."""
    found: bool


@dataclass
class TimedPlanner:
    """A planner that keeps count of its plans."""

    planner: GrossPlanner
    plans: list[Planning] = field(default_factory=list)

    def plan(self, *question) -> GrossPlan | None:
        whole, solver = Clock(), Clock()
        with mock.patch.object(harmonic_field, "solve", solver(harmonic_field.solve)):
            plan = whole(self.planner.plan)(*question)
        found = plan is not None
        self.plans.append(Planning(whole.seconds, solver.seconds, found))
        return plan

    def resume(self, *question) -> GrossPlan | None:
        return self.planner.resume(*question)


@functools.cache
def planner_of(arm: ArmControl) -> GrossPlanner:
    return GrossPlanner(arm.twin.model, arm.side)


def planning(arm: ArmControl) -> ArmControl:
    """The same arm, with a planner that counts."""
    return replace(arm, planner=TimedPlanner(planner_of(arm)))


def run_harmonic(pair: ReachPair) -> tuple[Reach, list[Planning]]:
    """A pair in physics, and its plans."""
    plans = []

    def make(arm: ArmControl, target: mink.SE3, posture: np.ndarray) -> HarmonicReach:
        arm = planning(arm)
        plans.append(arm.planner.plans)
        return HarmonicReach(arm, target, posture, NO_JAR)

    reach = run(pair, make)
    return reach, plans[0]


def run_harmonic_in_parallel(
    pairs: Sequence[ReachPair], jobs: int = 2
) -> list[tuple[Reach, list[Planning]]]:
    """All pairs, in their order."""
    return Parallel(n_jobs=jobs)(delayed(run_harmonic)(pair) for pair in pairs)


def plan_table(plans: Sequence[Planning]) -> str:
    """Median, 95th percentile and longest time of a plan, and the solver's part."""
    whole = 1e3 * np.array([plan.seconds for plan in plans])
    solver = 1e3 * np.array([plan.solver for plan in plans])
    return (
        f"{len(plans)} plans: median {np.median(whole):.1f} ms, 95 %"
        f" {np.quantile(whole, 0.95):.1f} ms, longest {whole.max():.0f} ms;"
        f" of the median the solver {np.median(solver):.1f} ms"
    )
