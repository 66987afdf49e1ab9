"""Vision: from a stereo image pair to the object's histogram and pose."""
