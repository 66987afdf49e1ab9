"""Which learners develop as infants do: the study, and what it measures."""
