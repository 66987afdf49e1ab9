"""The task: how the jar is presented, and when a trial has succeeded."""
