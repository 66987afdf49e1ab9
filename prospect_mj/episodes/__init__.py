"""Trials as they were simulated: states, controllers and pictures, to be watched later.

Not to be confused with `recording`, the outcomes that learners step without physics.
"""
