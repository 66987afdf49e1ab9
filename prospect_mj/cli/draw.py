"""The command line of the scripts that draw one picture."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue


@dataclass(frozen=True)
class DrawOptions:
    """Draw a picture of the documentation."""

    out: Path
    """PNG file to write."""

    def __post_init__(self) -> None:
        """Refuse what is no picture's name, before anything is drawn."""
        if self.out.suffix != ".png" or self.out.is_dir():
            raise InvalidValue("--out", str(self.out), "a file that ends in .png")


def main(picture: Callable[[], bytes], out: Path, prog: str) -> int:
    """Draw as the command line says.

    Args:
        picture: draws it, as PNG.
        out: where it goes unless the command line says otherwise.
        prog: the script's name.

    Returns:
        The exit code; see `command_line.run`.
    """

    def draw(options: DrawOptions) -> None:
        content = picture()
        options.out.parent.mkdir(parents=True, exist_ok=True)
        options.out.write_bytes(content)
        print(f"wrote {options.out}")

    return command_line.main(draw, DrawOptions(out), prog)
