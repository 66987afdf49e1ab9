"""The command lines that draw one picture of the documentation each."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.sim import gl

IMAGES = Path("docs/images")


@dataclass(frozen=True)
class DrawOptions:
    """Draw a picture of the documentation."""

    out: Path
    """PNG file to write, also over an older one."""

    def __post_init__(self) -> None:
        """Refuse what is no picture's name, before anything is drawn."""
        if self.out.suffix != ".png" or self.out.is_dir():
            raise InvalidValue("--out", str(self.out), "a file that ends in .png")


def automaton(
    argv: Sequence[str] | None = None, prog: str = "draw_automaton.py"
) -> int:
    """Draw the supervised automaton for docs/supervisor.md."""
    return main(_automaton, IMAGES / "automaton.png", prog, argv)


def field(argv: Sequence[str] | None = None, prog: str = "draw_field.py") -> int:
    """Draw a harmonic function over two joints for docs/gross_motion.md."""
    return main(_field, IMAGES / "harmonic_field.png", prog, argv)


def scene(argv: Sequence[str] | None = None, prog: str = "make_pictures.py") -> int:
    """Draw the README's picture: a trial with an early correction in four frames."""
    return main(_scene, IMAGES / "scene.png", prog, argv)


def replay(argv: Sequence[str] | None = None, prog: str = "draw_replay.py") -> int:
    """Draw what Rerun shows of a late correction, for the README."""
    return main(_replay, IMAGES / "replay.png", prog, argv)


def weights(argv: Sequence[str] | None = None, prog: str = "draw_weights.py") -> int:
    """Draw which grey levels decide in a run on recorded physics, for the README."""
    return main(_weights, IMAGES / "weights.png", prog, argv)


def worlds(argv: Sequence[str] | None = None, prog: str = "draw_worlds.py") -> int:
    """Draw the worlds for docs/worlds.md, as the eye sees them, and the post."""
    return main(_worlds, IMAGES / "worlds.png", prog, argv)


def main(
    picture: Callable[[], bytes],
    out: Path,
    prog: str,
    argv: Sequence[str] | None = None,
) -> int:
    """Draw as the command line says.

    Args:
        picture: draws it, as PNG.
        out: where it goes unless the command line says otherwise.
        prog: the name in its help.
        argv: the arguments; None for those of the process.

    Returns:
        The exit code; see `command_line.run`.
    """

    def draw(options: DrawOptions) -> None:
        content = picture()
        options.out.parent.mkdir(parents=True, exist_ok=True)
        options.out.write_bytes(content)
        print(f"wrote {options.out}")

    return command_line.main(draw, DrawOptions(out), prog, argv)


def _automaton() -> bytes:
    from prospect_mj.experiment.pictures import automaton_plot

    # It takes a second: no bar.
    return automaton_plot.automaton()


def _field() -> bytes:
    with _bar() as bar:
        gl.require_gl()
        # dm_control, which composes the scene, needs OpenGL chosen before it is loaded.
        from prospect_mj.experiment.pictures import field_plot

        return field_plot.field_picture(_ticks(bar, field_plot.STEPS))


def _scene() -> bytes:
    with _bar() as bar:
        gl.require_gl()
        from prospect_mj.experiment.pictures import scene_picture

        return scene_picture.scene_picture(_ticks(bar, scene_picture.STEPS))


def _replay() -> bytes:
    with _bar() as bar:
        gl.require_gl()
        from prospect_mj.experiment.pictures import replay_picture

        return replay_picture.replay_picture(_ticks(bar, replay_picture.STEPS))


def _weights() -> bytes:
    with _bar() as bar:
        from prospect_mj.experiment.pictures import mind_picture

        return mind_picture.mind_picture(_ticks(bar, mind_picture.STEPS))


def _worlds() -> bytes:
    with _bar() as bar:
        gl.require_gl()
        from prospect_mj.experiment.pictures import worlds_picture

        return worlds_picture.worlds_picture(_ticks(bar, worlds_picture.STEPS))


def _bar() -> tqdm:
    """It is there at once: to load what draws takes seconds by itself."""
    return tqdm(desc="loading", unit="step", dynamic_ncols=True, disable=None)


def _ticks(bar: tqdm, steps: int) -> Callable[[], object]:
    """Begin the steps of a picture; what counts them."""
    bar.set_description_str("drawing")
    bar.reset(steps)
    return bar.update
