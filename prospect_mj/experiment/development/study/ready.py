"""Whether a study can be made at all, told before anything starts."""

from prospect_mj.experiment.development.haptics.recorded import grasps
from prospect_mj.experiment.development.rivals.deep.agents import check_installed
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.settings import (
    FELT_WORLDS,
    Extent,
    StudySettings,
)
from prospect_mj.sim import gl


def check_ready(
    settings: StudySettings, extent: Extent, recordings: Recordings
) -> None:
    """Refuse what would fail after minutes.

    Args:
        settings: size of the study.
        extent: its parts.
        recordings: that it learns from.

    Raises:
        MissingPackage: if a library of the rivals is not installed.
        RecordingError: if haptics are asked for, and no grasp was felt.
        RenderingUnavailable: if a part needs pictures or live physics, and there is no
            OpenGL.
    """
    parts = extent.parts
    if "rivals" in parts:
        check_installed()
    if "haptics" in parts:
        for world in FELT_WORLDS:
            grasps(recordings.by_world[world])
    live = (
        "haptics" in parts and settings.grasped,
        "rivals" in parts and settings.planned,
    )
    if "found" in parts or any(live):
        gl.renderer_name()
