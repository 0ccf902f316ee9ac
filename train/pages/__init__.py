"""What the pages of this repository show, made by commands. Not in the wheel.

tables/     measured, kept as JSON, written into the pages        pictures/   drawn
"""
