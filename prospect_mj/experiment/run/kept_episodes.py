"""Which trials of a run are kept as episodes, and where."""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

from prospect_mj.checks import check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run.records import TrialRecord

FOLDER = "episodes"
_STEM, _SUFFIX = "trial-", ".npz"
_WORDS = "all, failures or every=N"
_LONG = 20
"""More digits than any number has that could be meant."""


@dataclass(frozen=True)
class Kept:
    """Which trials are kept."""

    every: int | None
    """Each trial whose number is a multiple of it; None: those that were not solved."""

    @classmethod
    def parse(cls, words: str) -> Self:
        """Read `all`, `failures` or `every=N`.

        Raises:
            InvalidValue: if it is none of them.
        """
        name, _, number = words.partition("=")
        match name, number:
            case "all", "":
                return cls(1)
            case "failures", "":
                return cls(None)
            case "every", digits if digits.isdecimal() and len(digits) < _LONG:
                check_integer("N of every=N", int(digits), 1, 1_000_000)
                return cls(int(digits))
        raise InvalidValue("--record", words, _WORDS)

    def wants(self, trial: TrialRecord) -> bool:
        """Whether a trial is to be kept."""
        return not trial.solved if self.every is None else trial.trial % self.every == 0


def path_of(run: Path, trial: int) -> Path:
    """Where the episode of a trial is kept in a run's folder."""
    return run / FOLDER / f"{_STEM}{trial:06d}{_SUFFIX}"


def kept_trials(run: Path) -> list[int]:
    """Numbers of the trials whose episodes are in a run's folder."""
    names = sorted((run / FOLDER).glob(f"{_STEM}*{_SUFFIX}"))
    stems = [path.name[len(_STEM) : -len(_SUFFIX)] for path in names]
    return [int(stem) for stem in stems if stem.isdecimal()]
