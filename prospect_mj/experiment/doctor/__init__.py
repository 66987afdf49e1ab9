"""Whether this machine and this installation do, and how to mend what does not."""
