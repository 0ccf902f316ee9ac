"""What robots perceive. For now the ideal provider alone: the truth in the fields of a belief."""
