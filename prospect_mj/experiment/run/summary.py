"""What a run came to, in a few lines."""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np

from prospect_mj.experiment.run.learning_curve import NEAR_OPTIMAL, WINDOW, Course
from prospect_mj.experiment.run.run_folder import RunFolder


@dataclass(frozen=True)
class Summary:
    """Figures of a run."""

    trials: int
    """Finished trials."""
    pretrain: int
    """Of these, pretraining."""
    first_mean: float
    last_mean: float
    near_optimal: int | None
    """These three as in `Course`."""
    sim_seconds: float
    """Simulated time of the whole run [s]."""
    session_sim_seconds: float
    """Simulated time since the process began or resumed the run [s]."""
    wall_seconds: float
    """Wall time of the same [s]."""
    path: Path
    """The run folder."""

    @classmethod
    def of(cls, folder: RunFolder, first_trial: int, wall_seconds: float) -> Self:
        """Summarise `folder`, which this session continued at `first_trial`."""
        actions = folder.trials["n_actions"].to_numpy()
        seconds = folder.trials["sim_seconds"].to_numpy()
        pretrain = min(folder.config.pretrain, len(actions))
        return cls(
            trials=len(actions),
            pretrain=pretrain,
            **Course.of(actions, pretrain)._asdict(),
            sim_seconds=float(np.sum(seconds)),
            session_sim_seconds=float(np.sum(seconds[first_trial:])),
            wall_seconds=wall_seconds,
            path=folder.path,
        )

    def __str__(self) -> str:
        """Lay the figures out for a terminal."""
        window = min(WINDOW, self.trials)
        pretrain = f", {self.pretrain} of them pretraining" if self.pretrain else ""
        speed = self.session_sim_seconds / max(self.wall_seconds, 1e-9)
        return "\n".join(
            (
                f"trials        {self.trials}{pretrain}",
                f"mean actions  {self.first_mean:.2f} in the first {window} trials, "
                f"{self.last_mean:.2f} in the last {window}",
                f"near-optimal  {self._near_optimal_words()}",
                f"simulated     {self.sim_seconds:.0f} s; this session "
                f"{self.session_sim_seconds:.0f} s in {self.wall_seconds:.0f} s of "
                f"wall time ({speed:.0f} x)",
                f"run folder    {self.path}: config.yaml, actions.parquet, "
                "trials.parquet, weights.npz, learning_curve.png",
            )
        )

    def _near_optimal_words(self) -> str:
        if self.near_optimal is not None:
            last = self.near_optimal + WINDOW - 1
            return (
                f"trials {self.near_optimal} to {last} are the first {WINDOW} "
                f"with a mean of {NEAR_OPTIMAL} or less"
            )
        counted = self.trials - self.pretrain
        if counted < WINDOW:
            after = " after the pretraining" if self.pretrain else ""
            return f"not measured: it takes {WINDOW} trials{after}, not {counted}"
        return f"not reached (a mean of {NEAR_OPTIMAL} over {WINDOW} trials)"
