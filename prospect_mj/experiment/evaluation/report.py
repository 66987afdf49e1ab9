"""What an evaluation came to, with 95 % confidence intervals.

Shares have Wilson's. Mean actions have Student's, within what can be: of few trials a
bootstrap would be too sure.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np
from numpy.typing import NDArray

from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.estimate import Estimate, share, stratified_mean
from prospect_mj.experiment.evaluation.listing import Listed, listed
from prospect_mj.experiment.populations.strategies import Strategy
from prospect_mj.experiment.portraits.trial_strategies import TrialStrategies
from prospect_mj.experiment.run.learning_curve import OPTIMUM
from prospect_mj.experiment.view.run_view import RunView
from prospect_mj.recording.hands import NUMBERS

_Ints = NDArray[np.integer]


@dataclass(frozen=True)
class Outcome:
    """What became of trials of one orientation, or of both."""

    trials: int
    solved: int
    """Of these, in how many the jar was inserted."""
    success: Estimate
    """Share of them."""
    actions: Estimate
    """Mean per trial [actions]; a trial that was not solved counts all that it had."""
    strategies: dict[str, int]
    """Trials with each strategy of the paper."""


@dataclass(frozen=True)
class Report:
    """What an evaluation came to."""

    path: Path
    """Its folder."""
    physics: str
    learned_trials: int
    """Trials after which the learner was evaluated."""
    outcomes: dict[str, Outcome]
    """Of the lid on the left, on the right, and of all trials."""
    failures: tuple[Listed, ...]
    """Trials that were not solved."""
    longer: tuple[Listed, ...]
    """Trials that were solved with more actions than the optimum."""

    @classmethod
    def of(cls, view: RunView) -> Self:
        """Sum up a finished evaluation.

        Raises:
            InvalidValue: if it is a run.
        """
        evaluation = view.evaluation
        if evaluation is None:
            raise InvalidValue("view", view.path, "an evaluation")
        found = TrialStrategies.of(view.trials, view.actions, view.config.world)
        n_actions = view.trials["n_actions"].to_numpy()
        solved = view.trials["solved"].to_numpy()
        most = view.config.max_actions
        groups = {side: [found.lid == lid] for side, lid in NUMBERS.items()}
        groups["all"] = [shown for (shown,) in groups.values()]
        return cls(
            path=view.path,
            physics=view.config.physics,
            learned_trials=evaluation.learned.trials,
            outcomes={
                name: _outcome(parts, n_actions, solved, found.strategy, most)
                for name, parts in groups.items()
            },
            failures=listed(view, ~solved),
            longer=listed(view, solved & (n_actions > OPTIMUM)),
        )


def _outcome(
    parts: list[NDArray[np.bool_]],
    n_actions: _Ints,
    solved: NDArray[np.bool_],
    strategy: _Ints,
    most: int,
) -> Outcome:
    """Of the trials (n,), of `most` actions, that are in any of some parts of all."""
    there = np.any(parts, axis=0)
    used = {s.name.lower(): int(np.sum(strategy[there] == s)) for s in Strategy}
    shown = [n_actions[part] for part in parts]
    n_trials, n_solved = int(there.sum()), int(solved[there].sum())
    # No trial is shorter or longer, so no mean is.
    actions = stratified_mean(shown).within(OPTIMUM, most)
    return Outcome(n_trials, n_solved, share(n_solved, n_trials), actions, used)
