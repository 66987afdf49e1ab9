"""What is measured on learning curves, and held against the paper and infants."""
