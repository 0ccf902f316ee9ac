"""Play learned teams: networks, policy files and the bundled policies."""
