"""The paper's figures 5 and 6, and that of live runs."""
