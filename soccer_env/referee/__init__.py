"""The referee: goals, out of play, restarts, stuck ball, halves. One rule set per league, built from shared rules."""
