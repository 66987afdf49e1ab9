"""Runs on live physics, to be compared with recorded ones."""
