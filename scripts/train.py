"""Train the Q-learner on live physics; `train.py --help` lists the options."""

import sys

from prospect_mj.cli.train import main

if __name__ == "__main__":
    sys.exit(main())
