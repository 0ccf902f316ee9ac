"""What robots believe, built from percepts and never from the truth. Filled by a later version.

See `perception.ideal`.
"""
