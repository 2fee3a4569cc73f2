"""Measurements, one module for each question of a user; `python -m benchmarks` writes RESULTS.md."""
