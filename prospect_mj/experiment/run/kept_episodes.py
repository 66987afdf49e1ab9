"""Which trials of a run are kept as episodes, and where."""

from dataclasses import dataclass
from pathlib import Path
from typing import Self

from prospect_mj.checks import check_integer, whole_number
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.run.records import TrialRecord

FOLDER = "episodes"
_STEM, _SUFFIX = "trial-", ".npz"
_WORDS = "all, failures or every=N"


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
        if words == "all":
            return cls(1)
        if words == "failures":
            return cls(None)
        name, _, digits = words.partition("=")
        if name != "every" or not (digits.isascii() and digits.isdecimal()):
            raise InvalidValue("--record", words, _WORDS)
        number = whole_number(digits)
        # More digits than any number has that could be meant.
        number = f"{digits[:20]}..." if number is None else number
        check_integer("N of every=N", number, 1, 1_000_000)
        return cls(number)

    def wants(self, trial: TrialRecord) -> bool:
        """Whether a trial is to be kept."""
        return not trial.solved if self.every is None else trial.trial % self.every == 0


def path_of(run: Path, trial: int) -> Path:
    """Where the episode of a trial is kept in a run's folder."""
    return run / FOLDER / f"{_STEM}{trial:06d}{_SUFFIX}"


def kept_trials(run: Path) -> list[int]:
    """Numbers of the trials whose episodes are in a run's folder."""
    names = [path.name for path in (run / FOLDER).glob(f"{_STEM}*{_SUFFIX}")]
    numbers = (whole_number(name[len(_STEM) : -len(_SUFFIX)]) for name in names)
    return sorted(number for number in numbers if number is not None)
