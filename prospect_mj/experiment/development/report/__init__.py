"""What the study tells."""
