"""The command line for filming a trial of a run."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.cli import command_line
from prospect_mj.cli.new_file import check_new_file
from prospect_mj.cli.output import say_aside
from prospect_mj.sim import gl


@dataclass(frozen=True)
class VideoOptions:
    """Film a trial of a run or of an evaluation, from its states, at real time."""

    run: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="RUN")]
    """The run's folder, or the file of one episode, NAME.npz."""
    out: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="OUT.mp4")]
    """MP4 file to write; it must not exist."""
    trial: int | None = None
    """Number of the trial, from 0. Default: the last one that was kept, or the last."""
    worst: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """The trial with most actions."""
    width: int = 854
    """Of the picture [pixels]."""
    height: int = 480
    """Of the picture [pixels]."""
    captions: bool = True
    """Write into the picture which action runs."""


def check_new_video(what: str, path: Path) -> None:
    """Refuse a video that can't be written, or is there.

    Raises:
        InvalidValue: with what is wrong.
    """
    check_new_file(what, path, ".mp4")


def main(argv: Sequence[str] | None = None, prog: str = "video.py") -> int:
    """Film what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    unset = VideoOptions(tyro.MISSING, tyro.MISSING)
    return command_line.main(_film, unset, prog, argv)


def _film(options: VideoOptions) -> None:
    check_new_video("OUT.mp4", options.out)
    gl.require_gl()
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.watching import replayed
    from prospect_mj.replay.video import VideoSettings, film

    look = VideoSettings(options.width, options.height, captions=options.captions)
    choice = replayed.Choice(options.trial, options.worst)
    (fetch,) = replayed.of(options.run, choice, say_aside).values()
    film(fetch().episode, options.out, look)
    print(options.out)
