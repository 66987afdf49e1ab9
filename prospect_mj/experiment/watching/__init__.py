"""Trials of a run once more, and actions live, for people to watch."""
