"""Exit codes of the command `soccer`, beside 0."""

BELOW = 1  # a result is below what was asked for, or is not what it says
WRONG = 2  # the command cannot be carried out as given
STOPPED = 130  # interrupted from the keyboard
