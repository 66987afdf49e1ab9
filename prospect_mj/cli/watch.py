"""The command line for watching actions, in MuJoCo's viewer or as a video."""

import os
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.actions.action import Action
from prospect_mj.checks import check_choice
from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.robot.names import Side
from prospect_mj.sim import gl


@dataclass(frozen=True)
class WatchOptions:
    """Watch a sequence of actions on one presentation of the jar."""

    lid: Side = "left"
    """The side on which the lid lies."""
    actions: tuple[str, ...] = ("grasp-right", "swap-right-to-left", "insert-left")
    """Any of grasp-left, grasp-right, swap-left-to-right, swap-right-to-left,
    insert-left, insert-right, as often as you like."""
    seed: int = 0
    """Of the presentation."""
    video: Path | None = None
    """MP4 file to write instead of opening a window; it must not exist."""

    def __post_init__(self) -> None:
        """Refuse actions that do not exist and files that do."""
        labels = [action.label for action in Action]
        for name in self.actions:
            check_choice("action", name, labels)
        if self.seed < 0:
            raise InvalidValue("seed", self.seed, "0 or more")
        if self.video is not None:
            _check_video(self.video)


def _check_video(path: Path) -> None:
    if path.suffix != ".mp4":
        raise InvalidValue("--video", str(path), "a name that ends in .mp4")
    if path.exists():
        raise InvalidValue("--video", str(path), "a file that does not exist")
    if not path.parent.is_dir():
        raise InvalidValue("--video", str(path), "a file in a folder that exists")


def main(argv: Sequence[str] | None = None, prog: str = "watch.py") -> int:
    """Show what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_watch, WatchOptions(), prog, argv)


def _watch(options: WatchOptions) -> None:
    displays = (os.environ.get(name) for name in ("DISPLAY", "WAYLAND_DISPLAY"))
    if options.video is None and sys.platform == "linux" and not any(displays):
        raise InvalidValue("--video", None, "a file, as there is no display")
    gl.require_gl()
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.screening import screen

    chosen = {action.label: action for action in Action}
    actions = [chosen[name] for name in options.actions]
    for outcome in screen(options.lid, actions, options.seed, options.video):
        label = outcome.action.label
        print(f"{label}: {outcome.result}, {outcome.sim_seconds:.1f} s", flush=True)
