"""Which learners develop as infants do; `development.py --help` lists the options."""

import sys

from prospect_mj.cli.development import main

if __name__ == "__main__":
    sys.exit(main())
