"""Recorded physics: every distinct outcome simulated once, to be stepped at will."""
