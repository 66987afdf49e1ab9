"""Draw the supervised automaton for docs/supervisor.md."""

import sys
from dataclasses import dataclass
from pathlib import Path

from prospect_mj.cli import command_line
from prospect_mj.errors import InvalidValue
from prospect_mj.experiment import automaton_plot


@dataclass(frozen=True)
class Options:
    """Where the picture goes."""

    out: Path = Path("docs/images/automaton.png")
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
    out = command_line.parse(Options, sys.argv[1:], Options(), "draw_automaton.py").out
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_bytes(automaton_plot.automaton())
    print(f"wrote {out}")


if __name__ == "__main__":
    sys.exit(main())
