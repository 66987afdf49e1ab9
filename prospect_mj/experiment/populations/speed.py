"""How fast the compiled learner is, beside the plain one."""

import time
from collections.abc import Callable
from typing import NamedTuple

from prospect_mj.experiment.populations.plain import learn_plainly
from prospect_mj.experiment.populations.population import Learned, learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.recording.recording import Recording


class Speed(NamedTuple):
    """Actions that a learner takes and learns from in a second, one after the other."""

    kernel: float
    """[1/s] compiled."""
    plain: float
    """[1/s] with NumPy alone."""


def measured_speed(
    recording: Recording,
    scenario: Scenario,
    settings: PopulationSettings | None = None,
    runs: int = 20,
) -> Speed:
    """How fast both learn the same, in this process, on one thread.

    Args:
        recording: where outcomes and histograms come from.
        scenario: what the trials present.
        settings: of the population.
        runs: learners that the compiled kernel is timed by; the plain one is by the
            first of them.
    """
    settings = PopulationSettings() if settings is None else settings
    programme = Programme(recording, scenario, settings)
    learn(programme, 0)  # Compiled, or read from the cache, before it is timed.
    kernel = _rate(lambda number: learn(programme, number), runs)
    return Speed(kernel, _rate(lambda number: learn_plainly(programme, number), 1))


def _rate(learns: Callable[[int], Learned], runs: int) -> float:
    """Actions per second of wall time."""
    began = time.perf_counter()
    n_actions = sum(int(learns(number).n_actions.sum()) for number in range(runs))
    return n_actions / (time.perf_counter() - began)
