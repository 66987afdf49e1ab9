"""What the environment can be told."""

import operator
from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Literal, Self, get_args

import numpy as np

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.checks import check_choice, check_integer
from prospect_mj.errors import InvalidValue
from prospect_mj.haptics import TrajectoryModels
from prospect_mj.recording.config import GrossMotion, ObjectPose, RecordingConfig
from prospect_mj.recording.worlds import STANDARD
from prospect_mj.supervisor.supervisor import Mode, Supervisor
from prospect_mj.task.presentation import PresentationSettings

Physics = Literal["live", "recorded"]
Observed = Literal["features", "images"]

_MOST_ACTIONS = 1000
"""Of a trial that two solve; as many take minutes of live physics."""
_MOST_RECORDED = int(np.iinfo(np.int8).max)
"""As deep as a recording's table can tell of."""
_LEAST_PIXELS, _MOST_PIXELS = 32, 1920
"""Side of a rendered picture: in less nothing can be made out, and more is larger than
most screens."""
_KINDS = {"features": FeatureSettings, "presentation": PresentationSettings}


@dataclass(frozen=True)
class PickPlaceSettings:
    """The environment's arguments."""

    physics: Physics = "live"
    """`live` simulates every action; `recorded` looks up what it led to when it was
    simulated before, which takes microseconds."""
    recording: Path | None = None
    """Folder of the recording; None is the one of this world that comes with the
    package."""
    grow: bool = False
    """Whether outcomes that the recording lacks are simulated, and added to it; trials
    then draw from 50 presentations of each orientation, recorded or not, or from all
    that are there if they are more."""
    supervisor: Mode = "none"
    """Choice set: `none` = all six actions, `safe`, `productive`."""
    shaping: tuple[str, ...] = ()
    """Actions not in the choice set of the first trials, as `<action>:<trials>`."""
    object_pose: ObjectPose = "vision"
    """Source of the jar's first pose; `truth` is an ablation."""
    gross_motion: GrossMotion = "harmonic"
    """How large movements go; `cartesian` is an ablation."""
    grid_cells: int = 16
    """Of the coarsest grid of the harmonic ones, for each of its four joints."""
    world: str = STANDARD
    """What stands round the torso, and how well its eyes see (docs/worlds.md)."""
    max_actions: int = 10
    """After which a trial is truncated; on recorded physics presentations are not shown
    whose outcomes are recorded for fewer."""
    observation: Observed = "features"
    """What an agent observes: the `features`, or these and, in live physics, the two
    `images` that they were made of."""
    features: FeatureSettings = field(default_factory=FeatureSettings)
    """Reading and scale of the features."""
    haptic_models: TrajectoryModels | None = None
    """Categories of grasps, K of them, by which the 303 features become 101 (3 + K);
    None: the features tell only which hand holds the jar."""
    presentation: PresentationSettings = field(default_factory=PresentationSettings)
    """Spread of the jar's place and of the lamp's brightness, in live physics."""
    width: int = 640
    """Of a rendered picture [pixels]."""
    height: int = 480
    """Of a rendered picture [pixels]."""

    def __post_init__(self) -> None:
        """Refuse what no trial can be made of, each setting for itself and together."""
        check_choice("physics", self.physics, get_args(Physics))
        check_choice("grow", self.grow, (False, True))
        check_choice("observation", self.observation, get_args(Observed))
        for name in ("max_actions", "grid_cells", "width", "height"):
            object.__setattr__(self, name, _as_integer(name, getattr(self, name)))
        for name in ("width", "height"):
            check_integer(name, getattr(self, name), _LEAST_PIXELS, _MOST_PIXELS)
        most = _MOST_RECORDED if self.physics == "recorded" else _MOST_ACTIONS
        check_integer("max_actions", self.max_actions, 1, most)
        for name, kind in _KINDS.items():
            if not isinstance(getattr(self, name), kind):
                raise InvalidValue(name, getattr(self, name), f"a {kind.__name__}")
        if not isinstance(self.haptic_models, TrajectoryModels | None):
            expected = "TrajectoryModels, or None"
            raise InvalidValue("haptic_models", self.haptic_models, expected)
        _check_schedule(self.shaping)
        Supervisor(self.supervisor, self.shaping)
        # A choice or a number that makes no recording makes no live physics either.
        _ = self.recorded_as
        self._check_recording()
        self._check_live_only()

    def _check_recording(self) -> None:
        if self.recording is not None:
            object.__setattr__(self, "recording", _as_path(self.recording))
        if self.physics == "live" and self.recording is not None:
            raise InvalidValue("recording", str(self.recording), "none in live physics")
        if self.physics == "live" and self.grow:
            raise InvalidValue("grow", self.grow, "False in live physics")
        if self.grow and self.recording is None:
            raise InvalidValue("recording", None, "a folder that may grow")

    def _check_live_only(self) -> None:
        """Refuse for recorded physics what only live physics has."""
        if self.physics == "live":
            return
        if self.presentation != PresentationSettings():
            raise InvalidValue(
                "presentation", self.presentation, "that of the recording"
            )
        if self.observation != "features":
            raise InvalidValue(
                "observation",
                self.observation,
                "'features' on recorded physics, which holds histograms and no images",
            )

    @classmethod
    def of(cls, settings: Self | None, **changes: Any) -> Self:  # noqa: ANN401
        """Settings given as a whole, by name, or both.

        Raises:
            InvalidChoice: if there is no such setting.
            InvalidValue: if they are something else.
        """
        given = cls() if settings is None else settings
        if not isinstance(given, cls):
            raise InvalidValue("settings", given, f"a {cls.__name__}")
        names = [setting.name for setting in fields(cls)]
        for name in changes:
            check_choice("setting", name, names)
        return replace(given, **changes)

    @property
    def categories(self) -> int:
        """K, number of the categories of grasps."""
        return 0 if self.haptic_models is None else len(self.haptic_models)

    @property
    def recorded_as(self) -> RecordingConfig:
        """The recording that these settings ask for, its seed apart."""
        return RecordingConfig(
            object_pose=self.object_pose,
            gross_motion=self.gross_motion,
            grid_cells=self.grid_cells,
            world=self.world,
        )


def _as_integer(name: str, value: object) -> int:
    """An integer of Python's, also of one of numpy's; true and false are none."""
    try:
        return value if isinstance(value, bool) else operator.index(value)
    except TypeError as error:
        raise InvalidValue(name, value, "an integer") from error


def _check_schedule(shaping: object) -> None:
    # A word by itself would be read letter by letter.
    if not isinstance(shaping, Sequence) or isinstance(shaping, str):
        expected = "a list of <action>:<trials>, such as swap-left-to-right:200"
        raise InvalidValue("shaping", shaping, expected)


def _as_path(folder: object) -> Path:
    if not isinstance(folder, str | Path) or not str(folder):
        raise InvalidValue("recording", folder, "the path of a folder")
    return Path(folder)
