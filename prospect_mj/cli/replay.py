"""The command line for replaying the trials of a run in Rerun."""

import signal
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.cli.new_file import check_new_file
from prospect_mj.display import require_display
from prospect_mj.errors import InvalidValue, ProspectError
from prospect_mj.sim import gl
from prospect_mj.storage import make_folder

_SUFFIX = ".rrd"


@dataclass(frozen=True)
class ReplayOptions:
    """Replay trials of a run or of an evaluation in Rerun's viewer.

    Trials that --record of train kept are read; any other one is simulated again, which
    takes some seconds, also one of recorded physics.
    """

    run: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="RUN")]
    """The run's folder, or the file of one episode, NAME.npz."""
    trial: int | None = None
    """Number of the trial, from 0. Default: the last one that was kept, or the last."""
    worst: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """The trial with most actions."""
    failures: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """All trials that were kept and not solved; if none was kept, the last ten that
    were not solved."""
    save: Path | None = None
    """File to write in place of opening the viewer, NAME.rrd; with --failures a folder.
    Nothing is overwritten."""
    serve: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False
    """Show it in a browser: the address is printed. Ctrl-C ends it."""
    host: str = "127.0.0.1"
    """Address on which --serve listens; 0.0.0.0: other machines may look."""
    port: int = 9090
    """Of the page that --serve shows; the data come from the next one."""

    def __post_init__(self) -> None:
        """Refuse more than one choice of the same thing."""
        if self.save is not None and self.serve:
            raise InvalidValue("--serve", True, "none beside --save")
        if not self.serve and (self.host, self.port) != (_HOST, _PORT):
            raise InvalidValue("--host or --port", "given", "none without --serve")


_HOST, _PORT = ReplayOptions.host, ReplayOptions.port


def main(argv: Sequence[str] | None = None, prog: str = "replay.py") -> int:
    """Replay what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_replay, ReplayOptions(tyro.MISSING), prog, argv)


def _replay(options: ReplayOptions) -> None:
    _check_can_show(options)
    gl.require_gl()
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.watching import replayed
    from prospect_mj.replay.rerun_export import export

    choice = replayed.Choice(options.trial, options.worst, options.failures)
    names, trials = replayed.of(options.run, choice, _say)
    with tempfile.TemporaryDirectory(prefix="prospect-replay-") as place:
        files = _files(options, names, Path(place))
        several = len(files) > 1
        bar = tqdm(files, "trials", unit="trial", disable=None if several else True)
        for path, one in zip(bar, trials, strict=True):
            export(one.episode, one.story, path)
        if options.save is None:
            _show(options, files)
        else:
            print("\n".join(map(str, files)))


def _check_can_show(options: ReplayOptions) -> None:
    """Refuse before anything is simulated what nobody would see in the end."""
    from prospect_mj.replay import viewer

    if options.save is not None:
        if not options.failures:
            check_new_file("--save", options.save, _SUFFIX)
        return
    viewer.program()
    if options.serve:
        viewer.check_port_free(options.host, options.port)
    else:
        require_display("--save FILE.rrd writes a file, --serve shows it in a browser")


def _files(options: ReplayOptions, names: Sequence[str], place: Path) -> list[Path]:
    """Where each trial is written."""
    if options.save is None:
        return [place / f"{name}{_SUFFIX}" for name in names]
    if not options.failures:
        return [options.save]
    make_folder(options.save, ProspectError)
    files = [options.save / f"{name}{_SUFFIX}" for name in names]
    for path in files:
        check_new_file("--save", path, _SUFFIX)
    return files


def _show(options: ReplayOptions, files: Sequence[Path]) -> None:
    """Rerun's viewer, until it is closed or interrupted."""
    from prospect_mj.replay import viewer

    if not options.serve:
        viewer.show(files)
        return
    # Who is asked to end would else leave the server behind.
    usual = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        viewer.serve(files, options.host, options.port, _tell_address)
    except KeyboardInterrupt:
        _say("stopped")
    finally:
        signal.signal(signal.SIGTERM, usual)


def _tell_address(page: str) -> None:
    print(page, flush=True)
    _say("open this address in a browser; Ctrl-C ends it")


def _say(words: str) -> None:
    tqdm.write(words, file=sys.stderr)
