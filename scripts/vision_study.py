"""Measure vision; draw what it sees for docs/vision.md."""

import sys

from prospect_mj.cli.vision_study import main

if __name__ == "__main__":
    sys.exit(main())
