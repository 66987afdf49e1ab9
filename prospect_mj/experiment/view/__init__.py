"""What the folder of a run or of an evaluation tells, for who only reads."""
