"""Backward chaining over a model of the task, and search in exact physics."""
