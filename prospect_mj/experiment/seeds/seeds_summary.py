"""What runs of several seeds came to: figures of each, and over all."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from prospect_mj.experiment.estimate import Estimate, mean_of_few
from prospect_mj.experiment.paper.report import markdown
from prospect_mj.experiment.run.learning_curve import (
    NEAR_OPTIMAL,
    OPTIMUM,
    WINDOW,
    Course,
)
from prospect_mj.experiment.text_table import aligned
from prospect_mj.experiment.view.run_view import RunView


@dataclass(frozen=True)
class SeedFigures:
    """Figures of one run."""

    seed: int
    first_mean: float
    last_mean: float
    near_optimal: int | None
    """These three as in `Course`."""
    solved: float
    """Share of the last trials (at most `WINDOW`) in which the jar was inserted."""

    @classmethod
    def of(cls, run: RunView) -> Self:
        """Measure a run."""
        n_actions = run.trials["n_actions"].to_numpy()
        return cls(
            seed=run.config.seed,
            **Course.of(n_actions, run.config.pretrain)._asdict(),
            solved=float(np.mean(run.trials["solved"].to_numpy()[-WINDOW:])),
        )


@dataclass(frozen=True)
class SeedsSummary:
    """Figures of several runs of one configuration.

    Means have Student's intervals, within what can be: of few seeds a bootstrap would
    be too sure.
    """

    trials: int
    """Per run."""
    seeds: tuple[SeedFigures, ...]
    first_mean: Estimate
    last_mean: Estimate
    near_optimal: Estimate
    """Over those that reached it."""
    reached: int
    """How many did."""
    solved: Estimate

    @classmethod
    def of(cls, runs: Sequence[RunView]) -> Self:
        """Sum up finished runs."""
        seeds = tuple(SeedFigures.of(run) for run in runs)
        reached = [one.near_optimal for one in seeds if one.near_optimal is not None]
        config, n_trials = runs[0].config, runs[0].n_trials
        # No trial is shorter or longer, so no mean is.
        lengths = OPTIMUM, config.max_actions
        return cls(
            trials=n_trials,
            seeds=seeds,
            first_mean=mean_of_few([one.first_mean for one in seeds]).within(*lengths),
            last_mean=mean_of_few([one.last_mean for one in seeds]).within(*lengths),
            near_optimal=mean_of_few(reached).within(
                config.pretrain, n_trials - WINDOW
            ),
            reached=len(reached),
            solved=mean_of_few([one.solved for one in seeds]).within(0, 1),
        )

    def __str__(self) -> str:
        """Lay the figures out for a terminal."""
        return "\n".join([*aligned(self._rows), *self._notes])

    def markdown(self) -> str:
        """The same as a page."""
        head, *rows = self._rows
        title = f"# {self._runs}"
        notes = "\n".join(f"- {note}" for note in self._notes)
        return "\n\n".join([title, markdown.table(head, rows), notes]) + "\n"

    @property
    def _runs(self) -> str:
        plural = "s" if len(self.seeds) > 1 else ""
        return f"{len(self.seeds)} seed{plural} of {self.trials} trials"

    @property
    def _rows(self) -> list[list[str]]:
        window = min(WINDOW, self.trials)
        head = ["seed", f"actions, first {window}", f"actions, last {window}"]
        head += ["near-optimal from", f"solved of last {window}, %"]
        return [head, *map(_row, self.seeds), ["mean", *_means(self)]]

    @property
    def _notes(self) -> list[str]:
        return [
            "in brackets 95 % intervals of the mean over seeds (Student's t)",
            f"near-optimal: a mean of {NEAR_OPTIMAL} or less over {WINDOW} trials; "
            f"reached by {self.reached} of {len(self.seeds)} seeds",
        ]


def _row(one: SeedFigures) -> list[str]:
    reached = "-" if one.near_optimal is None else str(one.near_optimal)
    actions = [f"{one.first_mean:.2f}", f"{one.last_mean:.2f}"]
    return [str(one.seed), *actions, reached, f"{100 * one.solved:.0f}"]


def _means(summary: SeedsSummary) -> list[str]:
    return [
        summary.first_mean.words(2),
        summary.last_mean.words(2),
        summary.near_optimal.words(0),
        summary.solved.words(1, scale=100),
    ]
