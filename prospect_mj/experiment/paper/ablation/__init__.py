"""What the published text leaves open, one choice at a time."""
