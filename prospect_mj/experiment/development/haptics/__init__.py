"""What the fingers feel of a jar, and which end that tells, beyond the two bits."""
