"""Results of the checks."""

from __future__ import annotations

import enum

import msgspec


class FaultName(enum.StrEnum):
    """Names of faults, which programs may compare with."""

    MISSING = "missing package"
    PERMISSION = "no permission"
    BUSY = "busy"
    UNPLUGGED = "unplugged"
    ABSENT = "nothing listens"
    EEPROM = "wrong EEPROM"
    LATENCY = "latency timer"
    SEND_IMMEDIATE = "no SIWU#"
    BAUD = "wrong baud"
    LOOPBACK = "loopback"
    LINE_ENDS = "changed line ends"
    PROTOCOL = "another protocol"
    VERSION = "other version"
    SPEC = "wrong spec"
    FIFO = "small FIFO"
    STALLED = "stalled gateway"
    NOISE = "noise"
    LOSS = "loss"
    FIREWALL = "firewall"
    NOBODY = "no such station"
    DOUBLE = "two of one address"
    SLOW_HOST = "slow host"
    SLOW_LINK = "slow link"
    FAILED = "failed"


class Finding(msgspec.Struct, frozen=True):
    """Result of one check."""

    check: str
    text: str
    fault: FaultName | None = None
    """None if the check found no fault."""
    advice: str = ""
    """Advice to the user."""
