"""Measurements, one module for each question that a user asks; `python -m benchmarks` writes RESULTS.md."""
