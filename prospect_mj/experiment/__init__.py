"""Training runs and studies: where the environment and the learner meet."""
