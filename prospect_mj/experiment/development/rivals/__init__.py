"""Rivals on the same task: deep learners, and the planner the paper argues against."""
