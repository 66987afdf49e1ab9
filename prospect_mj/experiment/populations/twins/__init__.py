"""Between the readable learners and their compiled twins: state to arrays and back."""
