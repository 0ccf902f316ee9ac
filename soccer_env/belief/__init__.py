"""What robots make of their percepts over time. Nothing here ever sees the truth."""
