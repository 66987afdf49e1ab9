"""The command line that grows a recording."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.workers import Workers
from prospect_mj.sim import gl


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
    arguments = sys.argv[1:] if argv is None else argv
    return command_line.run(
        lambda: _record(arguments), interrupted="interrupted: what was recorded is kept"
    )


def _record(argv: Sequence[str]) -> None:
    options = command_line.parse(RecordOptions, argv, RecordOptions(), "record.py")
    gl.require_gl()
    # Only here: MuJoCo chooses its OpenGL library at import.
    from prospect_mj.recording import growing, growth
    from prospect_mj.recording.key import RecordingKey

    key = RecordingKey.present(options.config, gl.renderer_name())
    with growing.GrowingRecording.open(options.out, key) as recording:
        n_trees, added = 2 * options.extent.presentations, 0
        with tqdm(total=n_trees, unit="tree", dynamic_ncols=True) as bar:
            for step in growth.grow(recording, options.extent, options.workers):
                added += step.nodes
                bar.set_postfix_str(f"{added} actions", refresh=False)
                bar.update(step.complete)
        print(f"{options.out}: {added} actions recorded")
        if options.pack is not None:
            trees = recording.complete_trees(options.extent)
            growing.pack(trees, recording.key, options.pack)
            print(f"packed into {options.pack}")
