"""Coverage-guided fuzzing of whatever reads bytes of strangers: targets, their known inputs, and the search."""
