"""What is presented to a population, and to which learner."""

from dataclasses import dataclass, field
from typing import Literal, get_args

from prospect_mj.agent import (
    AnyLearnerSettings,
    FeatureSettings,
    LinearSettings,
    ReplaySettings,
)
from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.agent.haptics import n_features, n_haptic
from prospect_mj.checks import check_choice, check_integer, check_number
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment.populations.spread import Spread, check_spreads
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.recording.config import LARGEST_SEED
from prospect_mj.supervisor.supervisor import Mode, Supervisor
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

Pictures = Literal["recorded", "one_per_side"]

_MOST = 100_000
_MOST_ACTIONS = 100


@dataclass(frozen=True)
class Scenario:
    """What the trials of a run present (Wheeler, Fagg and Grupen 2002, section 3.2)."""

    trials: int = 1000
    """All trials of a run, those of the pretraining included."""
    pretrain: int = 0
    """Of these, the first ones show one orientation only; 0: no dominant hand."""
    dominant: Orientation = "right"
    """The hand that the pretraining makes dominant: the lid lies on its side."""
    then_trials: int = 0
    """Trials of either orientation that follow in a second world, the same learner
    going on in it; 0: there is none."""

    def __post_init__(self) -> None:
        """Refuse numbers and choices that make no run."""
        check_integer("trials", self.trials, 1, _MOST)
        check_integer("pretraining trials", self.pretrain, 0, self.trials)
        check_choice("dominant hand", self.dominant, ORIENTATIONS)
        check_integer("trials in the second world", self.then_trials, 0, _MOST)

    @property
    def all_trials(self) -> int:
        """Those in both worlds."""
        return self.trials + self.then_trials


@dataclass(frozen=True)
class PopulationSettings:
    """How many learners there are, and how they learn."""

    runs: int = 1000
    """Learners, each of which begins anew."""
    seed: int = 0
    """Equal seeds give equal populations; run k is the same in all sizes of them."""
    learner: AnyLearnerSettings = field(default_factory=LinearSettings)
    """The learner, which the class of its settings tells."""
    spread: tuple[Spread, ...] = ()
    """Parameters that every learner draws for itself, in place of those above."""
    features: FeatureSettings = field(default_factory=FeatureSettings)
    """The state features."""
    supervisor: Mode = "none"
    """Which actions the learner may choose from."""
    shaping: tuple[str, ...] = ()
    """Actions that it may not choose in the first trials, as `<action>:<trials>`."""
    failed_actions: FailedActions = "allowed"
    """Whether an action that had no effect may be run again in the same trial."""
    categories: int = 0
    """Number of the categories of grasps that the learner is told."""
    max_actions: int = 10
    """A trial is cut off after this many actions."""
    bootstrap_at_truncation: bool = True
    """Whether the last action of a cut-off trial counts the value of what follows."""
    image_noise: float = 0.0
    """Standard deviation of normal noise [1] that every trial adds to each bin of the
    scaled histogram. A bin falls to zero at most; the noisy histogram is then scaled
    like any other."""
    pictures: Pictures = "recorded"
    """What a trial looks like: "recorded", as its presentation did; "one_per_side", as
    one presentation of that side did, drawn for the whole run. Outcomes are those of
    the trial's own presentation in both."""

    def __post_init__(self) -> None:
        """Refuse numbers and choices that make no population."""
        check_integer("runs", self.runs, 1, _MOST)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        Supervisor(self.supervisor, self.shaping)
        check_integer("actions per trial", self.max_actions, 1, _MOST_ACTIONS)
        if not isinstance(self.bootstrap_at_truncation, bool):
            raise InvalidValue(
                "bootstrap at truncation", self.bootstrap_at_truncation, "true or false"
            )
        check_number("image noise", self.image_noise, 0, 10)
        check_choice("pictures", self.pictures, get_args(Pictures))
        check_choice("rule for failed actions", self.failed_actions, RULES)
        check_integer("haptic categories", self.categories, 0, 100)
        self._check_learner()

    def _check_learner(self) -> None:
        """Refuse a learner of other actions or states than there are."""
        known, n_actions = self.learner, len(ACTION_NAMES)
        check_integer("number of actions", known.n_actions, n_actions, n_actions)
        if isinstance(known, LinearSettings | ReplaySettings):
            size = n_features(self.categories)
            check_integer("number of features", known.n_features, size, size)
        else:
            size = n_haptic(self.categories)
            check_integer("number of haptic states", known.n_haptic, size, size)
        check_spreads(known, self.spread)
