"""Mutation testing of the protocol package: small random faults are put into it, each of which a test must find."""
