"""Film a trial of a run; `video.py --help` lists the options."""

import sys

from prospect_mj.cli.video import main

if __name__ == "__main__":
    sys.exit(main())
