"""Draw the README's picture: a trial with an early correction in four frames."""

import sys

from prospect_mj.cli.draw import scene

if __name__ == "__main__":
    sys.exit(scene())
