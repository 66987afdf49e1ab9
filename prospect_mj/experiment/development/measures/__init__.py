"""What is measured on a population with a dominant hand, after its pretraining."""
