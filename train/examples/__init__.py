"""Small programs that show how something is done, each run by a test.

monte_carlo.py   Monte Carlo search in branches of a match, which beats `chaser` in a drill
"""
