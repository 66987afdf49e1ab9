"""Watch a sequence of actions in MuJoCo's viewer, or write it as a video."""

import sys

from prospect_mj.cli.watch import main

if __name__ == "__main__":
    sys.exit(main())
