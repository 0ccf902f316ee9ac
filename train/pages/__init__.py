"""The tables, pictures and notebooks of this repository's pages, made by commands. Not in the wheel.

tables/     measured, stored as JSON, written into the pages        pictures/   drawn from matches
notebooks.py  made from pages, and run
"""
