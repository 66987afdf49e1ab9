"""Play actions in MuJoCo's viewer, live; `view.py --help` lists the options."""

import sys

from prospect_mj.cli.view import main

if __name__ == "__main__":
    sys.exit(main())
