"""Draw the supervised automaton for docs/supervisor.md."""

import sys
from pathlib import Path

from prospect_mj.cli import draw
from prospect_mj.experiment.automaton_plot import automaton

OUT = Path("docs/images/automaton.png")

if __name__ == "__main__":
    sys.exit(draw.main(automaton, OUT, "draw_automaton.py"))
