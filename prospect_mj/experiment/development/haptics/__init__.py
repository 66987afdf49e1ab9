"""What categories of grasps tell that two bits can't, and what they do to learning."""
