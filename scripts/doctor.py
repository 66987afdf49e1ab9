"""What is wrong with this machine, and how to mend it."""

import sys

from prospect_mj.cli.doctor import main

if __name__ == "__main__":
    sys.exit(main())
