"""Draw what a run learned; `plot.py --help` lists the options."""

import sys

from prospect_mj.cli.plot import main

if __name__ == "__main__":
    sys.exit(main())
