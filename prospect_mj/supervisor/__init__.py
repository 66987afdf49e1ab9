"""Which of the six actions may run, and which the learner may choose."""
