"""What robots believe, built from percepts and never from the truth. Filled by a later version; see `perception.ideal`."""
