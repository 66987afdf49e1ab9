"""Evaluate the policy of a run; `evaluate.py --help` lists the options."""

import sys

from prospect_mj.cli.evaluate import main

if __name__ == "__main__":
    sys.exit(main())
