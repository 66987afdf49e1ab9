"""Measuring a learned policy on presentations that no training has shown."""
