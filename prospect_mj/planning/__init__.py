"""Harmonic path planning in an arm's joint space (Connolly & Grupen 1993)."""
