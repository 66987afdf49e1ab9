"""Several runs of one configuration, each of its own seed."""
