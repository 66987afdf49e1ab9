"""Size of a reproduction of the paper's experiment, which all of its parts know."""

from dataclasses import dataclass

import numpy as np

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.populations.scenario import (
    PopulationSettings,
    Scenario,
)
from prospect_mj.recording.config import LARGEST_SEED

PRETRAIN = 400
"""Trials of pretraining (Wheeler, Fagg and Grupen 2002, section 3.2)."""

_FEWEST_TRIALS = PRETRAIN + 300
"""A hundred trials for each of the stages after the pretraining."""
# The resampled curves of so many stay below two gigabytes of memory.
_MOST_RUNS, _MOST_TRIALS = 10_000, 10_000
_LARGEST = 10_000_000
_ABLATION = 1


@dataclass(frozen=True)
class ReproduceConfig:
    """Size of the reproduction."""

    runs: int = 1000
    """Learners per scenario."""
    trials: int = 1000
    """Trials of each, with a dominant hand 400 of pretraining among them."""
    ablation_runs: int | None = None
    """Learners per scenario and choice in the ablation table. Default: as many."""
    seed: int = 0
    """Equal seeds give equal reports, wall times aside."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no experiment."""
        check_integer("runs", self.runs, 2, _MOST_RUNS)
        check_integer("trials", self.trials, _FEWEST_TRIALS, _MOST_TRIALS)
        check_integer("ablation runs", self._ablation_runs, 2, _MOST_RUNS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        total = max(self.runs, self._ablation_runs) * self.trials
        if total > _LARGEST:
            raise InvalidValue("runs x trials", total, f"{_LARGEST} at most")

    @property
    def scenarios(self) -> tuple[Scenario, Scenario]:
        """Without a dominant hand, and with one."""
        return Scenario(self.trials), Scenario(self.trials, PRETRAIN)

    @property
    def main(self) -> PopulationSettings:
        """The default learners, of either scenario."""
        return PopulationSettings(runs=self.runs, seed=self.seed)

    @property
    def ablation(self) -> PopulationSettings:
        """Those of the ablation, other runs than the main ones.

        So no choice is made by the runs that are judged in the end.
        """
        sequence = np.random.SeedSequence(self.seed, spawn_key=(_ABLATION,))
        seed = int(sequence.generate_state(1)[0])
        return PopulationSettings(runs=self._ablation_runs, seed=seed)

    @property
    def _ablation_runs(self) -> int:
        return self.runs if self.ablation_runs is None else self.ablation_runs
