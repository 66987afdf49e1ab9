"""Learners by the thousand: compiled, on recorded physics, and kept."""
