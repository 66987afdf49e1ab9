"""Size of the study, which all of its parts know."""

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from prospect_mj.checks import check_choice, check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.development.haptics.settings import check_grasped
from prospect_mj.experiment.populations.scenario import Scenario
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.recording.worlds import STANDARD

Part = Literal[
    "learners",
    "causal",
    "population",
    "worlds",
    "change",
    "found",
    "haptics",
    "rivals",
]
PARTS: tuple[Part, ...] = get_args(Part)

DOMINANT = Scenario(trials=1000, pretrain=400, dominant="right")
"""The paper's scenario with a dominant hand (section 3.2)."""

IMAGE_WORLDS = (STANDARD, "lamp-right", "lamp-high", "noisy", "ring-label")
"""Those that are looked at unlike each other."""
CHANGES = ("post", "lamp-right")
"""Those that the standard world changes into after learning."""

FELT_WORLDS = (STANDARD, "wide-lid")
"""Those whose recorded grasps learners are told of: the category tells which end of the
standard jar is held in most grasps, and of one with a wider lid in nearly all."""

_MOST_RUNS = 10_000
_MOST_DEEP, _MOST_TRIALS, _MOST_PLANNED = 1000, 100_000, 50
_FEW = 5


@dataclass(frozen=True)
class StudySettings:
    """Size of the study of development."""

    runs: int = 1000
    """Learners in each row of the parts learners and population, and in the rows of
    linear learners of the part rivals; the part found looks into 100 of them at most.
    """
    setting_runs: int | None = None
    """Learners in each row of the parts causal, worlds, change and haptics. Default:
    two fifths of the others, two at least."""
    seed: int = 0
    """Equal seeds give equal tables, wall times aside."""
    deep_runs: int = 10
    """Runs of each deep learner among the rivals."""
    deep_trials: int = 1500
    """Trials of each run of a rival."""
    grasped: int = 72
    """Live grasps of the jar without a recording in the part haptics, a multiple of 4
    from 8; 0: none."""
    planned: int = 4
    """Presentations in which the planner searches live physics, an even number; 0:
    none."""

    def __post_init__(self) -> None:
        """Refuse numbers that make no study."""
        check_integer("runs", self.runs, 2, _MOST_RUNS)
        if self.setting_runs is not None:
            check_integer("setting_runs", self.setting_runs, 2, _MOST_RUNS)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        check_integer("deep_runs", self.deep_runs, 2, _MOST_DEEP)
        check_integer("deep_trials", self.deep_trials, 50, _MOST_TRIALS)
        check_grasped(self.grasped)
        check_integer("planned", self.planned, 0, _MOST_PLANNED)
        if self.planned % 2:
            raise InvalidValue("planned", self.planned, "an even number")

    @property
    def fewer_runs(self) -> int:
        """Learners in a row of the parts that have many rows."""
        if self.setting_runs is not None:
            return self.setting_runs
        return max(2, 2 * self.runs // _FEW)

    def rng(self, *key: int) -> np.random.Generator:
        """A generator of its own for each use, told by its key."""
        return np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=key))


@dataclass(frozen=True)
class Extent:
    """How much of the study is made, or read where it was made before."""

    parts: tuple[Part, ...] = PARTS
    """learners, causal, population, worlds, change, found, haptics, rivals."""
    worlds: tuple[str, ...] = IMAGE_WORLDS
    """Worlds of the part worlds."""
    changes: tuple[str, ...] = CHANGES
    """Worlds that the standard one changes into in the part change."""

    def __post_init__(self) -> None:
        """Refuse what isn't there."""
        for name, given, known in (
            ("parts", self.parts, PARTS),
            ("worlds", self.worlds, IMAGE_WORLDS),
            ("changes", self.changes, CHANGES),
        ):
            for one in given:
                check_choice(name, one, known)
            if len(set(given)) < len(given) or not given:
                raise InvalidValue(name, given, "one at least, and each once")

    @property
    def all_worlds(self) -> tuple[str, ...]:
        """Worlds whose recordings the parts learn from, the standard one first."""
        wanted = [STANDARD]
        wanted += self.worlds if "worlds" in self.parts else ()
        wanted += self.changes if "change" in self.parts else ()
        wanted += FELT_WORLDS if "haptics" in self.parts else ()
        return tuple(dict.fromkeys(wanted))
