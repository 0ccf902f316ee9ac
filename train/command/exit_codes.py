"""Exit codes of the command `soccer`, apart from 0 for success."""

BELOW = 1  # a result is below --at-least, or a recheck found differences
WRONG = 2  # the command cannot run as given
STOPPED = 130  # interrupted from the keyboard
