"""Draw the supervised automaton for docs/supervisor.md."""

import sys

from prospect_mj.cli.draw import automaton

if __name__ == "__main__":
    sys.exit(automaton())
