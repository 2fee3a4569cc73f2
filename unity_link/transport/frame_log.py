"""Loggers of frames; a connection logs its frames if one of them is at level DEBUG when the connection is opened."""

import logging

SENT, RECEIVED, SAMPLES = (logging.getLogger(f"unity_link.frames.{name}") for name in ("sent", "received", "samples"))


def is_wanted() -> bool:
    """Return True if one of the loggers is at level DEBUG."""
    return any(log.isEnabledFor(logging.DEBUG) for log in (SENT, RECEIVED, SAMPLES))
