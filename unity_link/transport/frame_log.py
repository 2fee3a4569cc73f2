"""Loggers of the frames of connections that are opened while one of them is at debug level."""

import logging

SENT, RECEIVED, SAMPLES = (logging.getLogger(f"unity_link.frames.{name}") for name in ("sent", "received", "samples"))


def is_wanted() -> bool:
    """Return whether any frames are to be logged."""
    return any(log.isEnabledFor(logging.DEBUG) for log in (SENT, RECEIVED, SAMPLES))
