"""How a robot notices that it is stuck, and how it gets free."""
