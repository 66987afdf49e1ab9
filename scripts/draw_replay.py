"""Draw what Rerun's viewer shows of a late correction."""

import sys

from prospect_mj.cli.draw import replay

if __name__ == "__main__":
    sys.exit(replay())
