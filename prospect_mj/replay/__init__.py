"""Episodes brought to the eye: played back from their states, in Rerun, as a video."""
