"""Draw which grey levels decide in a run of 1000 recorded trials, for the README."""

import sys

from prospect_mj.cli.draw import weights

if __name__ == "__main__":
    sys.exit(weights())
