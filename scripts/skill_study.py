"""Success and duration of every action, and the side effects of random episodes."""

import sys

from prospect_mj.cli.skill_study import main

if __name__ == "__main__":
    sys.exit(main())
