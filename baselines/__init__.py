"""Play scripted teams: simple ones, and those of the two papers."""
