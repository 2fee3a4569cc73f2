"""Writes from JSON: values by paths, also many at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.bridges.merged_writes import Objects, Value
from unity_link.data import Writable
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from unity_link.data import Proxy, Robot


class Reader:
    """Parses values that are to be written to the signals of a robot.

    Args:
        robot: robot with the signals.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._known: dict[str, Proxy[Any]] = {}
        for proxy in robot.signals:
            if isinstance(proxy, Writable):
                self._known[proxy.path] = self._known[proxy.id] = proxy

    def read(self, payload: bytes) -> Objects:
        """Parse an object of values by paths or IDs, or a list of such objects, and check all values.

        Raises:
            ArgumentError: for any other text, an unknown signal, or a value that a signal cannot have.
        """
        try:
            given = msgspec.json.decode(payload)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise ArgumentError(f'an object such as {{"j1.pos_sp": 5}} was expected: {error}') from None
        objects = given if isinstance(given, list) else [given]
        return [self._check(one) for one in objects]

    def read_one(self, proxy: Proxy[Any], payload: bytes) -> Objects:
        """Parse the value of one signal and check it.

        Raises:
            ArgumentError: for text that is no value, or a value that the signal cannot have.
        """
        try:
            value = msgspec.json.decode(payload)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise ArgumentError(f"a value for {proxy.path} was expected: {error}") from None
        return [[Value.of(proxy, value)]]

    def _check(self, given: Any) -> list[Value]:
        if not isinstance(given, dict):
            raise ArgumentError(f'an object such as {{"j1.pos_sp": 5}} was expected, not {given!r:.80}')
        known = self._known
        found = []
        for path, value in given.items():
            proxy = known.get(path)
            if proxy is None:
                raise ArgumentError(f"{self._robot[path].path} cannot be written through Zenoh")
            found.append(Value.of(proxy, value))
        return found
