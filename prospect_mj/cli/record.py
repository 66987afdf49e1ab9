"""The command line that grows a recording."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import tyro

from prospect_mj.cli import command_line
from prospect_mj.recording import files
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.workers import Workers
from prospect_mj.sim import gl

if TYPE_CHECKING:
    from prospect_mj.recording.growing import GrowingRecording


@dataclass(frozen=True)
class RecordOptions:
    """Record what every sequence of executed actions leads to, on live physics.

    The same command again goes on where it was stopped.
    """

    out: Path = Path("runs/recording")
    """Folder that grows: new, empty, or of the same recording."""
    pack: Path | None = None
    """New folder for the complete trees, without what they could grow on from."""
    extent: Annotated[Extent, tyro.conf.arg(name="")] = field(default_factory=Extent)
    """Size of the recording."""
    config: Annotated[RecordingConfig, tyro.conf.arg(name="")] = field(
        default_factory=RecordingConfig
    )
    """What it is of."""
    workers: Annotated[Workers, tyro.conf.arg(name="")] = field(default_factory=Workers)
    """Who does the work."""


def main(argv: Sequence[str] | None = None) -> int:
    """Record as the command line says.

    Returns:
        The exit code; see `command_line.run`.
    """
    words = "interrupted: what was recorded is kept"
    return command_line.main(_record, RecordOptions(), "record.py", argv, words)


def _record(options: RecordOptions) -> None:
    if options.pack is not None:
        files.check_free_to_pack(options.pack, options.out)
    gl.require_gl()
    # Only here: MuJoCo chooses its OpenGL library at import.
    from prospect_mj.recording.growing import GrowingRecording

    key = RecordingKey.present(options.config, gl.renderer_name())
    with GrowingRecording.open(options.out, key) as recording:
        _grow(recording, options)
        if options.pack is not None:
            _pack(recording, options.extent, options.pack)


def _grow(recording: "GrowingRecording", options: RecordOptions) -> None:
    from prospect_mj.cli.record_progress import RecordProgress
    from prospect_mj.recording.growth import Growth

    growth = Growth(recording, options.extent)
    n_before = growth.n_actions
    with RecordProgress(growth) as progress:
        for _ in growth.run(options.workers):
            progress.advance()
    print(f"{options.out}: {growth.n_actions - n_before} actions recorded")


def _pack(recording: "GrowingRecording", extent: Extent, path: Path) -> None:
    from prospect_mj.recording.packing import pack

    n_packed = pack(recording.complete_trees(extent), recording.key, path)
    print(f"{path}: {n_packed} trees packed")
    n_left = recording.n_trees - n_packed
    if n_left:
        print(
            f"{n_left} trees of {recording.path} are left out: not complete to "
            f"{extent.depth} executed actions, or beyond the number wanted"
        )
