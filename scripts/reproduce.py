"""Reproduce the paper's experiment; `reproduce.py --help` lists the options."""

import sys

from prospect_mj.cli.reproduce import main

if __name__ == "__main__":
    sys.exit(main())
