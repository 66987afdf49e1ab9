"""Draw a harmonic function over two joints for docs/gross_motion.md."""

import sys

from prospect_mj.cli.draw import field

if __name__ == "__main__":
    sys.exit(field())
