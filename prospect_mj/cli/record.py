"""The command line that grows a recording."""

import warnings
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import tyro

from prospect_mj.cli import command_line
from prospect_mj.cli.output import Output, counted
from prospect_mj.errors import UnfinishedRecording
from prospect_mj.recording import files
from prospect_mj.recording.config import Extent, RecordingConfig
from prospect_mj.recording.key import RecordingKey
from prospect_mj.recording.packing import Packing, check_free
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
    output: Annotated[Output, tyro.conf.arg(name="")] = field(default_factory=Output)
    """What is printed."""


def main(argv: Sequence[str] | None = None, prog: str = "record.py") -> int:
    """Record as the command line says.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    words = "interrupted: what was recorded is kept"
    return command_line.main(_record, RecordOptions(), prog, argv, words)


def _record(options: RecordOptions) -> None:
    _check(options)
    # Only here: MuJoCo chooses its OpenGL library at import.
    from prospect_mj.recording.growing import GrowingRecording

    key = RecordingKey.present(options.config, gl.renderer_name())
    with ExitStack() as stack:
        packing = None
        if options.pack is not None:
            packing = stack.enter_context(Packing.open(options.pack, options.out))
        recording = stack.enter_context(GrowingRecording.open(options.out, key))
        grown = _grow(recording, options)
        packed = None if packing is None else _pack(recording, options, packing)
    figures = {"path": options.out, **grown._asdict(), "pack": packed}
    options.output.result("", figures)
    if grown.n_failed:
        raise UnfinishedRecording(
            f"{grown.n_failed} of the trees could not be grown to an end"
        )


def _check(options: RecordOptions) -> None:
    """Refuse what can't be done, before a folder is begun."""
    files.check_folder(options.out)
    if options.pack is not None:
        check_free(options.pack, options.out)
    gl.require_gl()
    from prospect_mj.recording.grower import task_settings

    task_settings(options.config)
    options.workers.check()


class _Grown(NamedTuple):
    n_actions: int
    """Recorded by this process."""
    n_trees: int
    """Of the recording."""
    n_failed: int
    """Trees that could not be grown to an end."""


def _grow(recording: "GrowingRecording", options: RecordOptions) -> _Grown:
    """Grow to the wanted size."""
    from prospect_mj.cli.record_progress import RecordProgress
    from prospect_mj.recording.growth import Growth

    growth = Growth(recording, options.extent)
    n_before = growth.n_actions
    with RecordProgress(growth) as progress:
        for _ in growth.run(options.workers):
            progress.advance()
    n_new = growth.n_actions - n_before
    options.output.say(f"{options.out}: {counted(n_new, 'action')} recorded")
    for words in growth.failures:
        warnings.warn(words, stacklevel=2)
    return _Grown(n_new, recording.n_trees, len(growth.failures))


def _pack(
    recording: "GrowingRecording", options: RecordOptions, packing: Packing
) -> dict[str, object]:
    extent, say = options.extent, options.output.say
    n_packed = packing.write(recording.complete(extent), recording.key)
    say(f"{options.pack}: {counted(n_packed, 'tree')} packed")
    n_left = recording.n_trees - n_packed
    if n_left:
        say(
            f"{counted(n_left, 'tree')} of {recording.path} left out: not complete "
            f"to {extent.depth} executed actions, or beyond the number wanted"
        )
    return {"path": options.pack, "n_trees": n_packed, "n_left_out": n_left}
