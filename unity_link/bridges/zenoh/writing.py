"""From JSON to the bus: values by paths, many in one go, in order."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from unity_link.data import Writable
from unity_link.data.writing import write_values
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.data import Proxy, Robot
    from unity_link.hardware import Bus


class Value(NamedTuple):
    """What is to be written to one signal: checked, and encoded once."""

    proxy: Proxy[Any]
    value: Any
    words: tuple[int, ...]


Objects = list[list[Value]]
"""What is written, one object after the other."""


class Writer:
    """Writes the signals of a robot.

    Args:
        robot: the robot, behind an open link.
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._known: dict[str, Proxy[Any]] = {}
        for proxy in robot.signals:
            if isinstance(proxy, Writable):
                self._known[proxy.path] = self._known[proxy.id] = proxy

    def read(self, payload: bytes) -> Objects:
        """Read an object of values by paths or IDs, or a list of such; check all that it says.

        Raises:
            ArgumentError: for text that is something else, a signal that there is not, or a value that it does not
                take.
        """
        try:
            given = msgspec.json.decode(payload)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise ArgumentError(f'an object such as {{"j1.pos_sp": 5}} was expected: {error}') from None
        objects = given if isinstance(given, list) else [given]
        return [self._check(one) for one in objects]

    def read_one(self, proxy: Proxy[Any], payload: bytes) -> Objects:
        """Read the value of one signal, and check it.

        Raises:
            ArgumentError: for text that is no value, or one that the signal does not take.
        """
        try:
            value = msgspec.json.decode(payload)
        except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
            raise ArgumentError(f"a value for {proxy.path} was expected: {error}") from None
        return [[Value(proxy, value, proxy.signal.encode(value))]]

    def _check(self, given: Any) -> list[Value]:
        if not isinstance(given, dict):
            raise ArgumentError(f'an object such as {{"j1.pos_sp": 5}} was expected, not {given!r:.80}')
        known = self._known
        found = []
        for path, value in given.items():
            proxy = known.get(path)
            if proxy is None:
                raise ArgumentError(f"{self._robot[path].path} is not one that can be written so")
            found.append(Value(proxy, value, proxy.signal.encode(value)))
        return found

    async def write(self, objects: Objects, *, posted: bool) -> None:
        """Write objects in order; whole words of several go as one batch.

        Args:
            objects: as `read` gives them.
            posted: whether words are not to be waited for; then errors are those of the link's next `fence`.

        Raises:
            GatewayError: the first error; the other writes may have been executed.
        """
        for run in _runs(objects):
            if isinstance(run, list):
                await write_values({proxy: value for proxy, value, _ in run}, posted=posted)
            else:
                bus, addresses, words = run
                await (bus.post_many if posted else bus.write_many)(addresses, words)


def _runs(objects: Objects) -> Iterator[list[Value] | tuple[Bus, list[int], list[int]]]:
    """Join what follows each other and is nothing but whole words on one bus."""
    bus: Bus | None = None
    addresses: list[int] = []
    words: list[int] = []
    for one in objects:
        if not _is_plain(one):
            if bus is not None and addresses:
                yield bus, addresses, words
            yield one
            bus, addresses, words = None, [], []
            continue
        for proxy, _, encoded in one:
            if bus is not None and proxy.bus is not bus:
                yield bus, addresses, words
                addresses, words = [], []
            bus = proxy.bus
            addresses.append(proxy.signal.address)
            words += encoded
    if bus is not None and addresses:
        yield bus, addresses, words


def _is_plain(values: Iterable[Value]) -> bool:
    return not any(len(words) > 1 or proxy.signal.is_field for proxy, _, words in values)
