"""The URL of a gateway, taken apart."""

from __future__ import annotations

import math

import msgspec

from unity_link.errors import ArgumentError


class DriverUrl(msgspec.Struct, frozen=True):
    """A parsed URL, such as ``serial:/dev/ttyUSB0?baud=12000000`` or ``tcp://robot:7001``."""

    text: str
    """The URL as it was given, without a token; messages name it."""
    scheme: str
    host: str
    """A computer; or a device, as it stands in the URL."""
    port: int | None
    path: str
    options: dict[str, str]

    def integer(self, option: str, default: int) -> int:
        """Return an option that is a whole number.

        Raises:
            ArgumentError: where it is none.
        """
        text = self.options.get(option)
        if text is None:
            return default
        try:
            return int(text, 0)
        except ValueError:
            raise ArgumentError(f"{option}={text} in {self.text} is not a whole number") from None

    def number(self, option: str) -> float:
        """Return an option that is a number, and is there.

        Raises:
            ArgumentError: where it is none.
        """
        text = self.options[option]
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not math.isfinite(number):
            raise ArgumentError(f"{option}={text} in {self.text} is not a number")
        return number

    def flag(self, option: str, *, default: bool = False) -> bool:
        """Return an option that is 0 or 1, `default` where it is not given.

        Raises:
            ArgumentError: where it is something else.
        """
        text = self.options.get(option, str(int(default)))
        if text not in ("0", "1"):
            raise ArgumentError(f"{option}={text} in {self.text} is neither 0 nor 1")
        return text == "1"

    @property
    def without_host(self) -> str:
        """The URL with what it has for a host as the first folder of its path."""
        return self.text.replace("://", ":/", 1)

    @property
    def node(self) -> int | None:
        """Number of the node on a shared medium (docs/protocol.md, "Addressed frames"), None on a medium of our own."""
        if "node" not in self.options:
            return None
        node = self.integer("node", 0)
        if not 0 <= node <= 0xFE:
            raise ArgumentError(f"node={node} in {self.text} is not from 0 to 254")
        return node

    @property
    def any_map(self) -> bool:
        """Return whether a program may use a gateway that was built from another spec than its own."""
        chosen = self.options.get("map")
        if chosen not in (None, "any"):
            raise ArgumentError(f"map={chosen} in {self.text} is not any")
        return chosen is not None

    @property
    def compact(self) -> bool:
        """Return whether frames may be in compact form (docs/protocol.md, "The compact form")."""
        return self.flag("compact", default=True)

    @property
    def echo(self) -> bool:
        """Return whether an adapter is known to give back what is sent."""
        return self.flag("echo")

    @property
    def snoop(self) -> str | None:
        """Path of the file that is to hold what passes, None where none is named."""
        name = self.options.get("snoop")
        if name == "":
            raise ArgumentError(f"snoop= in {self.text} names no file")
        return name
