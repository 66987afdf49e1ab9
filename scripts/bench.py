"""Simulated seconds per wall second, and where the time goes."""

import sys

from prospect_mj.cli.bench import main

if __name__ == "__main__":
    sys.exit(main())
