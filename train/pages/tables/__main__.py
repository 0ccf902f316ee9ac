"""Measure tables, or check them: see the package's docstring."""

import sys

from soccer_env.train.pages.tables.pages import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
