"""Draw a harmonic function over two joints for docs/gross_motion.md."""

import sys
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.sim import gl


@dataclass(frozen=True)
class Options:
    """Where the picture goes."""

    out: Path = Path("docs/images/harmonic_field.png")
    """PNG file to write."""

    def __post_init__(self) -> None:
        """Refuse what is no picture's name, before anything is drawn."""
        if self.out.suffix != ".png" or self.out.is_dir():
            raise InvalidValue("--out", str(self.out), "a file that ends in .png")


def main() -> int:
    """Draw as the command line says and return the exit code."""
    return command_line.run(draw)


def draw() -> None:
    """Write the picture and say so."""
    out = command_line.parse(Options, sys.argv[1:], Options(), "draw_field.py").out
    gl.require_gl()
    # dm_control, which composes the scene, needs OpenGL chosen before it is loaded.
    from prospect_mj.experiment import field_plot

    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_bytes(field_plot.field_picture())
    print(f"wrote {out}")


if __name__ == "__main__":
    sys.exit(main())
