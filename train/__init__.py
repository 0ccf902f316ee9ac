"""Train, evaluate and compare teams, from Python or with the command `soccer`."""
