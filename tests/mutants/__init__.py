"""Mutation testing of `protocol` and `capture`: small random faults are put in, each of which a test must find."""
