"""Measurements, one module for one question that a user asks; `python -m benchmarks` runs them and writes RESULTS.md."""
