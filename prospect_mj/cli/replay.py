"""The command line for replaying the trials of a run in Rerun."""

import signal
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro
from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.cli.new_file import check_new_file
from prospect_mj.cli.output import say_aside
from prospect_mj.display import require_display
from prospect_mj.errors import InvalidValue
from prospect_mj.sim import gl

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
    Nothing is overwritten; a failure that can't be replayed is left out, with a
    warning."""
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
        for name in () if self.serve else ("host", "port"):
            value = getattr(self, name)
            if value != getattr(ReplayOptions, name):
                raise InvalidValue(f"--{name}", value, "none without --serve")


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
    from prospect_mj.cli import replay_files
    from prospect_mj.experiment.watching import replayed

    choice = replayed.Choice(options.trial, options.worst, options.failures)
    trials = replayed.of(options.run, choice, say_aside)
    if options.save is None and not options.serve:
        # What is wrong with the run comes first, and before any of it is simulated.
        require_display("--save FILE.rrd writes a file, --serve shows it in a browser")
    place = replay_files.places(options.save, options.failures, list(trials))
    with place as files:
        written = replay_files.written(trials, files)
        if options.save is None:
            _show(options, list(written))
            return
        for path in written:
            # At once: it is there, whatever becomes of the others.
            tqdm.write(str(path))
            sys.stdout.flush()


def _check_can_show(options: ReplayOptions) -> None:
    """Refuse before anything is read what nobody would see in the end."""
    from prospect_mj.replay import viewer

    if options.save is not None:
        if not options.failures:
            check_new_file("--save", options.save, _SUFFIX)
        elif options.save.suffix == _SUFFIX:
            expected = f"a folder beside --failures, whose name has no {_SUFFIX}"
            raise InvalidValue("--save", str(options.save), expected)
        return
    viewer.program()
    if options.serve:
        viewer.check_port_free(options.host, options.port)


def _show(options: ReplayOptions, files: Sequence[Path]) -> None:
    """Rerun's viewer, until it is closed or interrupted."""
    from prospect_mj.replay import viewer

    if not options.serve:
        viewer.show(files)
        return
    # Who is asked to end would else leave the server behind.
    usual = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        passing = files[0].parent
        viewer.serve(files, options.host, options.port, _tell_address, passing)
    except KeyboardInterrupt:
        say_aside("stopped")
    finally:
        signal.signal(signal.SIGTERM, usual)


def _tell_address(page: str) -> None:
    print(page, flush=True)
    say_aside("open this address in a browser; Ctrl-C ends it")
