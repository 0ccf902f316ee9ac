"""How a legged robot finds and follows the ball."""
