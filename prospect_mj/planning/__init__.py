"""Gross motion planning by harmonic functions over an arm's joint space."""

from prospect_mj.planning import kernel_cache

kernel_cache.use()
