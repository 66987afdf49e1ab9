"""Grow a recording of physics; see `prospect_mj.cli.record`."""

import sys

from prospect_mj.cli.record import main

if __name__ == "__main__":
    sys.exit(main())
