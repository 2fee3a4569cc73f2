"""The parsed URL of a gateway."""

from __future__ import annotations

import math

import msgspec

from unity_link.errors import ArgumentError


class DriverUrl(msgspec.Struct, frozen=True):
    """A parsed URL, such as ``serial:/dev/ttyUSB0?baud=12000000`` or ``tcp://robot:7001``."""

    text: str
    """The URL for messages, as the user wrote it, but without the value of a token."""
    scheme: str
    host: str
    """Name of a computer, or of a device."""
    port: int | None
    path: str
    options: dict[str, str]

    def integer(self, option: str, default: int) -> int:
        """Return the value of an option as an integer, or `default` if the URL does not have the option.

        Raises:
            ArgumentError: if the value is not an integer.
        """
        text = self.options.get(option)
        if text is None:
            return default
        try:
            return int(text, 0)
        except ValueError:
            raise ArgumentError(f"{option}={text} in {self.text} is not a whole number") from None

    def number(self, option: str) -> float:
        """Return the value of an option that the URL has, as a finite number.

        Raises:
            ArgumentError: if the value is not a number.
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
        """Return the value of an option, 0 or 1, as a bool, or `default` if the URL does not have the option.

        Raises:
            ArgumentError: if the value is neither 0 nor 1.
        """
        text = self.options.get(option, str(int(default)))
        if text not in ("0", "1"):
            raise ArgumentError(f"{option}={text} in {self.text} is neither 0 nor 1")
        return text == "1"

    @property
    def without_host(self) -> str:
        """The URL with its host as the first folder of its path."""
        return self.text.replace("://", ":/", 1)

    @property
    def node(self) -> int | None:
        """Node number on a shared medium, 0 to 254 (docs/protocol.md, "Addressed frames"); None without ``node=``."""
        if "node" not in self.options:
            return None
        node = self.integer("node", 0)
        if not 0 <= node <= 0xFE:
            raise ArgumentError(f"node={node} in {self.text} is not from 0 to 254")
        return node

    @property
    def any_map(self) -> bool:
        """True if a program may use a gateway that was built from another spec than its own."""
        chosen = self.options.get("map")
        if chosen not in (None, "any"):
            raise ArgumentError(f"map={chosen} in {self.text} is not 'any', the only value of map=")
        return chosen is not None

    @property
    def compact(self) -> bool:
        """True if frames may have the compact form (docs/protocol.md, "The compact form")."""
        return self.flag("compact", default=True)

    @property
    def echo(self) -> bool:
        """True if the URL declares that the adapter echoes all sent bytes."""
        return self.flag("echo")

    @property
    def snoop(self) -> str | None:
        """Path of the snoop; None if the URL does not name one."""
        name = self.options.get("snoop")
        if name == "":
            raise ArgumentError(f"snoop= in {self.text} names no file")
        return name
