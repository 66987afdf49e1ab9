"""What is claimed of development, asked alike of every learner under every rule."""
