"""The command line for watching actions live, in MuJoCo's viewer or as a video."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.actions.action import Action
from prospect_mj.cli import command_line
from prospect_mj.cli.output import say_aside
from prospect_mj.cli.video import check_new_video
from prospect_mj.display import require_display
from prospect_mj.errors import InvalidChoice, InvalidValue
from prospect_mj.experiment.watching.shown import Shown
from prospect_mj.recording.worlds import STANDARD
from prospect_mj.robot.names import Side
from prospect_mj.sim import gl


@dataclass(frozen=True)
class ViewOptions:
    """Play actions on one presentation of the jar, in MuJoCo's viewer.

    After the last action the window stays open until you close it. Double-click
    something and drag it with Ctrl and the right button to pull at it.
    """

    actions: tuple[str, ...] = ("grasp-right", "swap-right-left", "insert-left")
    """Any of grasp-left, grasp-right, swap-left-right, swap-right-left, insert-left,
    insert-right, as often as you like, with commas or blanks between them."""
    lid: Side = "left"
    """The side on which the lid lies."""
    seed: int = 0
    """Of the presentation."""
    speed: float = 1.0
    """Simulated seconds per second, 0.01 to 100."""
    world: str = STANDARD
    """What stands round the torso: standard, post, lamp-right, lamp-high, noisy,
    ring-label, wide-lid or narrow-lid."""
    video: Path | None = None
    """MP4 file to write in place of opening a window; it must not exist."""

    def __post_init__(self) -> None:
        """Refuse actions that do not exist and files that do."""
        self.shown()
        if self.video is not None:
            check_new_video("--video", self.video)
            if self.speed != 1.0:
                raise InvalidValue("--speed", self.speed, "none beside --video")

    def shown(self) -> Shown:
        """What they ask for."""
        actions = actions_named(self.actions)
        return Shown(self.lid, actions, self.seed, self.speed, self.world)


def actions_named(words: Sequence[str]) -> tuple[Action, ...]:
    """Actions by their names, or with the `to` of a swap left out.

    Args:
        words: names, also several in a word with commas between them.

    Raises:
        InvalidChoice: if one of them is none.
    """
    known = {_short(action.label): action for action in Action}
    names = [name for word in words for name in word.split(",") if name]
    for name in names:
        if _short(name) not in known:
            raise InvalidChoice("action", name, known)
    return tuple(known[_short(name)] for name in names)


def _short(name: str) -> str:
    return name.strip().replace("-to-", "-")


def main(argv: Sequence[str] | None = None, prog: str = "view.py") -> int:
    """Show what the command line asks for.

    Args:
        argv: the arguments; None for those of the process.
        prog: the name in its help.

    Returns:
        The exit code; see `command_line.run`.
    """
    return command_line.main(_view, ViewOptions(), prog, argv)


def _view(options: ViewOptions) -> None:
    if options.video is None:
        require_display("--video FILE.mp4 writes a video in place of opening a window")
    gl.require_gl()
    say_aside("loading the scene ...")
    # MuJoCo is not loaded before it is known that it can render.
    from prospect_mj.experiment.watching.live_view import in_film, in_window

    shown = options.shown()
    film = options.video
    for outcome in in_window(shown) if film is None else in_film(shown, film):
        if outcome is None:
            print("done; the window stays open until you close it", flush=True)
        else:
            label = outcome.action.label
            print(f"{label}: {outcome.result}, {outcome.sim_seconds:.1f} s", flush=True)
    if film is not None:
        print(film)
