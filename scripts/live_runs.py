"""Make runs on live physics; `live_runs.py --help` lists the options."""

import sys

from prospect_mj.cli.live_runs import main

if __name__ == "__main__":
    sys.exit(main())
