"""The command line for drawing a run."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from prospect_mj.checks import check_integer
from prospect_mj.cli import command_line
from prospect_mj.cli.new_file import new_folder
from prospect_mj.cli.output import say_aside
from prospect_mj.sim import gl
from prospect_mj.storage import replace_file

_MOST_GRASPS = 1000
_FOLDER = "plots"


@dataclass(frozen=True)
class PlotOptions:
    """Draw a run: its strategies, Q-values, weights over grey levels, and grasps.

    The run may still be under way. Nothing is overwritten.
    """

    run: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="RUN")]
    """The run's folder."""
    out: Path | None = None
    """New or empty folder for the pictures. Default: plots in the run's folder."""
    grasps: int = 0
    """Grasps to simulate and draw as well, of a jar that the robot is told to lie some
    millimetres elsewhere; half a second each."""

    def __post_init__(self) -> None:
        """Refuse what can't be simulated."""
        check_integer("--grasps", self.grasps, 0, _MOST_GRASPS)


def main(argv: Sequence[str] | None = None, prog: str = "plot.py") -> int:
    """Draw what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_plot, PlotOptions(tyro.MISSING), prog, argv)


def _plot(options: PlotOptions) -> None:
    if options.grasps:
        gl.require_gl()
    # MuJoCo and Matplotlib are not loaded before it is known what they are needed for.
    from prospect_mj.experiment.portraits.portfolio import draw
    from prospect_mj.experiment.run.folder_guard import check_vacant
    from prospect_mj.experiment.view.run_view import RunView

    run = RunView.read(options.run)
    run.check_is_run()
    out = options.run / _FOLDER if options.out is None else options.out
    check_vacant(out, "choose another folder with --out")
    with new_folder(out):
        for name, content in draw(run, options.grasps, say_aside).items():
            replace_file(out / name, content)
            print(out / name)
