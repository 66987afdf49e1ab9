"""What each learner costs in time and memory, beside the linear one."""

import time
from collections.abc import Sequence
from typing import NamedTuple

from prospect_mj.agent import (
    AnyLearnerSettings,
    Learner,
)
from prospect_mj.agent.learners import DEFAULTS
from prospect_mj.experiment.populations.plain import learn_plainly
from prospect_mj.experiment.populations.population import learn
from prospect_mj.experiment.populations.programme import Programme
from prospect_mj.experiment.populations.scenario import PopulationSettings, Scenario
from prospect_mj.experiment.text_table import aligned
from prospect_mj.recording.recording import Recording

_COMPILED = Scenario(trials=1000, pretrain=400)
_PLAIN = Scenario(trials=60, pretrain=20)
_HEAD = ["learner", "ms per 1000 trials", "us per action", "readable, us", "kB learned"]


class Cost(NamedTuple):
    """Of one learner on recorded physics, on one thread."""

    learner: str
    """Its name."""
    seconds: float
    """Of 1000 trials with a dominant hand, compiled [s]."""
    action: float
    """Of one action and what is learned from it, compiled [s]."""
    plain_action: float
    """The same by the readable learner, in shorter runs [s]."""
    n_bytes: int
    """Size of all that it has learned and remembers after 1000 trials [bytes]."""


def measured_costs(
    recording: Recording,
    learners: Sequence[AnyLearnerSettings] = tuple(DEFAULTS.values()),
    runs: int = 5,
) -> list[Cost]:
    """What some learners cost, in time of the processor.

    Args:
        recording: what they learn from.
        learners: their settings.
        runs: of each compiled one, after another one that compiles it if need be.
    """
    return [_cost(recording, settings, runs) for settings in learners]


def _cost(recording: Recording, learner: AnyLearnerSettings, runs: int) -> Cost:
    settings = PopulationSettings(learner=learner)
    programme = Programme(recording, _COMPILED, settings)
    size = n_bytes(learn(programme, 0).learner)
    began = time.process_time()
    learned = [learn(programme, number, take_over=False) for number in range(runs)]
    seconds = time.process_time() - began
    n_actions = sum(int(one.n_actions.sum()) for one in learned)
    programme = Programme(recording, _PLAIN, settings)
    began = time.process_time()
    short = learn_plainly(programme, 0)
    plain = (time.process_time() - began) / int(short.n_actions.sum())
    return Cost(learner.name, seconds / runs, seconds / n_actions, plain, size)


def n_bytes(learner: Learner) -> int:
    """Size of all that a learner has learned and remembers [bytes]."""
    return sum(array.nbytes for array in learner.state().values())


def table(costs: Sequence[Cost]) -> str:
    """A line per learner, each number with its ratio to the first one's."""
    first = costs[0]
    rows = [_HEAD]
    for cost in costs:
        cells = (
            _beside(cost.seconds, first.seconds, 1e3),
            _beside(cost.action, first.action, 1e6),
            _beside(cost.plain_action, first.plain_action, 1e6),
            _beside(cost.n_bytes, first.n_bytes, 1e-3),
        )
        rows.append([cost.learner, *cells])
    return "\n".join(aligned(rows))


def _beside(value: float, of_first: float, scale: float) -> str:
    return f"{_short(scale * value)} (x {_short(value / of_first)})"


def _short(number: float) -> str:
    return f"{number:.0f}" if number >= 100 else f"{number:.2g}"
