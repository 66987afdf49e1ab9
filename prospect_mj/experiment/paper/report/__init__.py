"""The report, and the folder that it is in."""
