"""`python -m soccer_env` is the command `soccer`."""

import sys

from soccer_env.train.command.command_line import main

if __name__ == "__main__":
    sys.exit(main())
