"""Draw the worlds for docs/worlds.md, as the eye sees them, and the post."""

import sys

from prospect_mj.cli.draw import worlds

if __name__ == "__main__":
    sys.exit(worlds())
