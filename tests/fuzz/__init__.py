"""Coverage-guided fuzzing of code that reads untrusted bytes: targets, their known inputs, and the search."""
