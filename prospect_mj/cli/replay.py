"""The command line for replaying the trials of a run in Rerun."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.sim import gl


@dataclass(frozen=True)
class ReplayOptions:
    """Replay trials of a run in Rerun's viewer, or write them for it.

    Trials that --record of train.py kept are read; any other one is simulated again,
    which takes some seconds.
    """

    run: Annotated[Path, tyro.conf.Positional] = Path()
    """The run's folder."""
    trial: int | None = None
    """Number of the trial, from 0. Default: the last one that was kept."""
    worst: bool = False
    """The trial with most actions."""
    failures: bool = False
    """All trials that were kept and not solved."""
    save: Path | None = None
    """File to write in place of opening the viewer, NAME.rrd; of several trials a
    folder. Nothing is overwritten."""
    serve: bool = False
    """Show it in a browser: the address is printed."""

    def __post_init__(self) -> None:
        """Refuse more than one choice of the same thing."""
        if sum([self.trial is not None, self.worst, self.failures]) > 1:
            raise InvalidValue(
                "trials", "two choices", "one of --trial, --worst, --failures"
            )
        if self.save is not None and self.serve:
            raise InvalidValue("--serve", True, "none beside --save")


def main(argv: Sequence[str] | None = None, prog: str = "replay.py") -> int:
    """Replay what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_replay, ReplayOptions(), prog, argv)


def _replay(options: ReplayOptions) -> None:
    shown = options.serve or options.save is not None
    if not shown and sys.platform == "linux" and not _display():
        raise InvalidValue(
            "viewer", None, "--save FILE.rrd or --serve: there is no display"
        )
    gl.require_gl()
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.replayed import chosen, replayed
    from prospect_mj.experiment.run_view import RunView
    from prospect_mj.replay.rerun_export import export

    run = RunView.read(options.run)
    trials = chosen(run, options.trial, options.worst, options.failures)
    with tempfile.TemporaryDirectory(prefix="prospect-replay-") as place:
        files = _files(options, trials, Path(place))
        for one, path in zip(replayed(run, trials, _say), files, strict=True):
            export(one.episode, one.story, path)
        if options.save is None:
            _show(files, options.serve)
        else:
            print("\n".join(map(str, files)))


def _files(options: ReplayOptions, trials: Sequence[int], place: Path) -> list[Path]:
    """Where each trial is written."""
    if options.save is None:
        return [place / f"trial-{trial:06d}.rrd" for trial in trials]
    if options.failures:
        options.save.mkdir(parents=True, exist_ok=True)
        files = [options.save / f"trial-{trial:06d}.rrd" for trial in trials]
    else:
        files = [options.save]
    for path in files:
        if path.suffix != ".rrd":
            raise InvalidValue("--save", str(path), "a name that ends in .rrd")
        if path.exists():
            raise InvalidValue("--save", str(path), "a file that does not exist")
        if not path.parent.is_dir():
            raise InvalidValue("--save", str(path), "a file in a folder that exists")
    return files


def _show(files: Sequence[Path], serve: bool) -> None:
    """Rerun's viewer, until it is closed."""
    command = [sys.executable, "-m", "rerun_cli", *map(str, files)]
    subprocess.run([*command, "--serve-web"] if serve else command, check=False)


def _display() -> bool:
    return any(os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))


def _say(words: str) -> None:
    print(words, file=sys.stderr, flush=True)
