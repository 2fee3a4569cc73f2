"""The host's end of the protocol."""
