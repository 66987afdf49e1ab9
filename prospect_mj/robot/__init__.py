"""The torso: published facts, names, postures, and its sensors and servos."""
