"""What is measured on their learning curves, and held against the paper and infants."""
