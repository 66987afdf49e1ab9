"""Studies of the parts: how often, how exactly, how fast."""
