"""Settings of a training run."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Self, get_args

from prospect_mj.agent.failed_actions import RULES, FailedActions
from prospect_mj.agent.features import FeatureSettings
from prospect_mj.agent.haptics import n_features, n_haptic
from prospect_mj.agent.learners import settings_of
from prospect_mj.agent.settings import AnyLearnerSettings, LinearSettings
from prospect_mj.checks import check_choice, check_integer, check_names
from prospect_mj.envs.settings import Physics
from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.experiment.run.records import ACTION_NAMES
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording import shipped
from prospect_mj.recording.config import (
    LARGEST_SEED,
    MOST_CELLS,
    GrossMotion,
    ObjectPose,
)
from prospect_mj.recording.worlds import STANDARD, WORLDS
from prospect_mj.supervisor.supervisor import Mode, Supervisor
from prospect_mj.task.presentation import ORIENTATIONS, Orientation

_MOST_TRIALS = 100_000


@dataclass(frozen=True)
class TrainConfig:
    """Everything that decides the numbers of a training run."""

    trials: int = 1000
    """All trials of the run, those of the pretraining included."""
    pretrain: int = 0
    """Of these, the first ones show one orientation only; 0: no dominant hand."""
    dominant: Orientation = "right"
    """The hand that the pretraining makes dominant: the lid lies on its side."""
    seed: int = 0
    """Equal seeds give equal runs, bit for bit."""
    supervisor: Mode = "none"
    """Which actions the learner may choose from: none: all six; safe: not the
    dangerous ones; productive: not the useless ones either."""
    shaping: tuple[str, ...] = ()
    """Actions that the learner may not choose in the first trials, such as
    swap-left-to-right:200 swap-right-to-left:200."""
    physics: Physics = "live"
    """live: every action is simulated; recorded: what it led to when it was simulated
    before is looked up."""
    recording: str | None = None
    """Folder of a recording; default: the one of the world that comes with the
    package."""
    grow: bool = False
    """Simulate outcomes that the recording lacks, and add them to it."""
    object_pose: ObjectPose = "vision"
    """Where the controllers get the jar's pose from; truth is an ablation."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go: harmonic: along streamlines in configuration space, clear
    of everything; cartesian: straight, as an ablation."""
    grid_cells: int = 16
    """Of harmonic movements: cells of the coarsest grid for each of its four joints."""
    world: str = STANDARD
    """What stands round the torso, and how well its eyes see: standard, post,
    lamp-right, lamp-high, noisy, ring-label, wide-lid or narrow-lid."""
    max_actions: int = 10
    """A trial is cut off after this many actions."""
    bootstrap_at_truncation: bool = True
    """Whether the last action of a cut-off trial counts the value of what follows."""
    failed_actions: FailedActions = "allowed"
    """Whether an action that had no effect may be run again while the same hand, or
    none, holds the jar: allowed, or suppressed for the rest of the trial."""
    features: FeatureSettings = field(default_factory=FeatureSettings)
    """The state features."""
    haptic_models: TrajectoryModels | None = None
    """Categories of grasps that the state tells as well (docs/haptics.md); none: it
    tells only which hand holds the jar."""
    learner: AnyLearnerSettings = field(default_factory=LinearSettings)
    """The learner, with the parameters that it has."""

    def __post_init__(self) -> None:
        """Refuse every number and choice that makes no run."""
        check_integer("trials", self.trials, 1, _MOST_TRIALS)
        check_integer("pretrain", self.pretrain, 0, self.trials)
        check_integer("seed", self.seed, 0, LARGEST_SEED)
        check_integer("max_actions", self.max_actions, 1, 1000)
        check_choice("dominant hand", self.dominant, ORIENTATIONS)
        Supervisor(self.supervisor, self.shaping)
        check_choice("physics", self.physics, get_args(Physics))
        check_choice("object pose", self.object_pose, get_args(ObjectPose))
        check_choice("gross motion", self.gross_motion, get_args(GrossMotion))
        check_integer("grid cells per joint", self.grid_cells, 2, MOST_CELLS)
        check_choice("world", self.world, WORLDS)
        if not isinstance(self.bootstrap_at_truncation, bool):
            raise InvalidValue(
                "bootstrap at truncation", self.bootstrap_at_truncation, "true or false"
            )
        check_choice("failed actions", self.failed_actions, RULES)
        if not isinstance(self.haptic_models, TrajectoryModels | None):
            expected = "TrajectoryModels, or None"
            raise InvalidValue("haptic models", self.haptic_models, expected)
        self._check_sizes()

    def _check_sizes(self) -> None:
        """The learner must know all actions and all that is observed."""
        if not isinstance(self.learner, AnyLearnerSettings):
            raise InvalidValue("learner", self.learner, "settings of a learner")
        sizes = {
            "n_actions": ("number of actions", len(ACTION_NAMES)),
            "n_features": ("number of features", n_features(self.categories)),
            "n_haptic": ("number of haptic states", n_haptic(self.categories)),
        }
        for name, (what, size) in sizes.items():
            check_integer(what, getattr(self.learner, name, size), size, size)

    @classmethod
    def from_dict(cls, plain: Mapping[str, Any]) -> Self:
        """Build a configuration from what `dataclasses.asdict` returned.

        Raises:
            ProspectError: if a setting is missing, unknown or out of range.
        """
        check_names(plain, cls)
        try:
            return cls(
                **{
                    **plain,
                    "shaping": tuple(plain["shaping"]),
                    "features": FeatureSettings(**plain["features"]),
                    "haptic_models": _models(plain["haptic_models"]),
                    "learner": settings_of(plain["learner"]),
                }
            )
        except (TypeError, AttributeError) as error:
            raise ProspectError(f"settings of the wrong type: {error}") from error

    @property
    def categories(self) -> int:
        """K, number of the categories of grasps that the state tells."""
        return 0 if self.haptic_models is None else len(self.haptic_models)

    @property
    def recording_folder(self) -> Path:
        """Where recorded physics is looked up.

        Raises:
            RecordingError: if none of this world comes with the package.
        """
        if self.recording is None:
            return shipped.folder(self.world)
        return Path(self.recording)

    def with_trials(self, trials: int) -> Self:
        """The same run, longer or shorter."""
        return replace(self, trials=trials)


def _models(plain: Mapping[str, Any] | None) -> TrajectoryModels | None:
    return None if plain is None else TrajectoryModels.from_dict(plain)
