"""Replay trials of a run in Rerun; `replay.py --help` lists the options."""

import sys

from prospect_mj.cli.replay import main

if __name__ == "__main__":
    sys.exit(main())
