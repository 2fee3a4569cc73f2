"""Mutation testing of the protocol room: small wrongs put into it by chance, each of which some test must find."""
