"""Which learners the study lets learn, from what, and where they are kept."""
