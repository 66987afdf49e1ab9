"""The study of development from recordings to the report.

Its folder has `development.yaml`, what it is of; `populations`, `haptics` and `rivals`,
what took time to make; `tables` and `figures`; and `report.md`, which tells of the
parts of the last command.
"""

import warnings
from collections.abc import Iterable
from pathlib import Path

from prospect_mj.experiment.development.figures import pictures
from prospect_mj.experiment.development.report.report import Made, report
from prospect_mj.experiment.development.study.learning import FOLDER, Tell
from prospect_mj.experiment.development.study.ready import check_ready
from prospect_mj.experiment.development.study.recordings import Recordings
from prospect_mj.experiment.development.study.results import Results
from prospect_mj.experiment.development.study.settings import Extent, StudySettings
from prospect_mj.experiment.development.study.study import Study
from prospect_mj.experiment.development.study.tables import tables
from prospect_mj.experiment.populations.digests import recording_digest
from prospect_mj.experiment.report_folder import REPORT, Kind, ReportFolder

KIND = Kind("development")
"""Of the folder."""


def develop(
    out: Path,
    settings: StudySettings,
    extent: Extent,
    recordings: Recordings,
    jobs: int = 1,
    tell: Tell = print,
) -> Path:
    """Make the study, or what is left of it, and write the report.

    Args:
        out: new or empty folder, or one of the same study.
        settings: its size.
        extent: which parts of it.
        recordings: of the worlds that these need.
        jobs: threads, and processes of what needs them.
        tell: takes a line for people now and then.

    Returns:
        The report's path.

    Raises:
        RunFolderError: if the folder can't be used.
        RecordingError: if a recording lacks what a part needs.
        MissingPackage, RenderingUnavailable: if the machine lacks it.
    """
    check_ready(settings, extent, recordings)
    origin = recording_digest(recordings.standard)
    with ReportFolder.open(out, KIND, settings, origin) as folder:
        study = Study(out, settings, extent, recordings, jobs, tell)
        _write(folder, study.results(), recordings)
        if extent == Extent():
            _warn(out, study.unused())
    return out / REPORT


def _write(folder: ReportFolder, results: Results, recordings: Recordings) -> None:
    for name, table in tables(results).items():
        folder.write_table(f"tables/{name}", table)
    for name, png in pictures.pictures(results, recordings.standard):
        folder.write(f"figures/{name}.png", png)
    keys = {world: one.key for world, one in recordings.by_world.items()}
    folder.write(REPORT, report(Made(results, keys)).encode())


def _warn(out: Path, unused: Iterable[Path]) -> None:
    if number := len(list(unused)):
        warnings.warn(
            f"{out / FOLDER} has files of other code, settings or versions, no longer "
            f"read: {number}",
            stacklevel=3,
        )
