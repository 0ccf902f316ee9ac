"""What this repository's pages show, made by commands: `tables/` measures, `pictures/` draws. Not in the wheel."""
