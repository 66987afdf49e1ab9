"""What the environment can be told."""

from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Literal, Self, get_args

from prospect_mj.agent.features import FeatureSettings
from prospect_mj.checks import check_choice
from prospect_mj.errors import InvalidValue
from prospect_mj.recording.config import GrossMotion, ObjectPose, RecordingConfig
from prospect_mj.supervisor.supervisor import Mode, Supervisor
from prospect_mj.task.presentation import PresentationSettings

Physics = Literal["live", "recorded"]


@dataclass(frozen=True)
class PickPlaceSettings:
    """The environment's arguments."""

    physics: Physics = "live"
    """`live` simulates every action; `recorded` looks up what it led to when it was
    simulated before, which takes microseconds."""
    recording: Path | None = None
    """Folder of the recording; None is the one that comes with the package."""
    grow: bool = False
    """Whether outcomes that the recording lacks are simulated, and added to it; trials
    then draw from 50 presentations of each orientation, recorded or not."""
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
    max_actions: int = 10
    """After which a trial is truncated."""
    features: FeatureSettings = field(default_factory=FeatureSettings)
    """Reading and scale of the 303 features."""
    presentation: PresentationSettings = field(default_factory=PresentationSettings)
    """Spread of the jar's place and of the lamp's brightness, in live physics."""

    def __post_init__(self) -> None:
        """Refuse a trial without actions, a mode or a schedule that can't be."""
        check_choice("physics", self.physics, get_args(Physics))
        if not 1 <= self.max_actions <= 1000:
            raise InvalidValue("max_actions", self.max_actions, "1 to 1000")
        Supervisor(self.supervisor, self.shaping)
        self._check_recording()

    def _check_recording(self) -> None:
        if self.physics == "live" and self.recording is not None:
            raise InvalidValue("recording", str(self.recording), "none in live physics")
        if self.physics == "live" and self.grow:
            raise InvalidValue("grow", self.grow, "False in live physics")
        if self.grow and self.recording is None:
            raise InvalidValue("recording", None, "a folder that may grow")
        spread = self.presentation
        if self.physics == "recorded" and spread != PresentationSettings():
            raise InvalidValue("presentation", spread, "that of the recording")

    def changed(self, **changes: Any) -> Self:  # noqa: ANN401
        """The same settings but for some, given by name.

        Raises:
            InvalidChoice: if there is no such setting.
        """
        names = [setting.name for setting in fields(self)]
        for name in changes:
            check_choice("setting", name, names)
        return replace(self, **changes)

    @property
    def recorded_as(self) -> RecordingConfig:
        """The recording that these settings ask for, its seed apart."""
        return RecordingConfig(
            object_pose=self.object_pose,
            gross_motion=self.gross_motion,
            grid_cells=self.grid_cells,
        )
