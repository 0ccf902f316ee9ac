"""Keeping the ball between the paws, past other players and to the goal."""
