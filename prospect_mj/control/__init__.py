"""Closed-loop controllers: sensors in, servo targets out; none steps physics."""
