"""Pictures of one run: what it did, what it learned, and how its hands closed."""
