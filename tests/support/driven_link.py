"""Links of programs in other languages, with the methods of a link in Python, for the tests of every API.

Each call sends one command to a compiled program or a script, and reads one line as its answer.
`tests/generate/driver.c`
defines the commands; `driver.cc` and `driver.m` implement the same commands in their languages.
"""

from __future__ import annotations

import asyncio
import itertools
import re
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from unity_link import (
    ArgumentError,
    BusError,
    BusTimeoutError,
    ConnectError,
    GatewayError,
    LinkLostError,
    Outcome,
    OutOfRangeError,
    UnansweredError,
    UnsupportedError,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine, Iterable, Sequence
    from types import TracebackType

PATIENCE = 30.0
"""Seconds to wait for a sample."""
_KINDS: dict[str, type[Exception]] = {
    "4": BusError,
    "5": BusTimeoutError,
    "6": OutOfRangeError,
    "35": UnansweredError,
    "36": ConnectError,
    "37": UnsupportedError,
    "38": ArgumentError,
    "39": TimeoutError,
    "unity_link:busError": BusError,
    "unity_link:busTimeout": BusTimeoutError,
    "unity_link:outOfRange": OutOfRangeError,
    "unity_link:unanswered": UnansweredError,
    "unity_link:connectError": ConnectError,
    "unity_link:unsupported": UnsupportedError,
    "unity_link:argumentError": ArgumentError,
    "unity_link:gatewayError": GatewayError,
}
_LOST = re.compile(r"3[234]|unity_link:linkLost")
_OUTCOMES = {
    "known to be executed": Outcome.EXECUTED,
    "known not to be executed": Outcome.NOT_EXECUTED,
    "perhaps executed": Outcome.UNKNOWN,
}


class DrivenSample(NamedTuple):
    """A sample that a program has received."""

    sequence: int
    lost: int
    values: list[int]


class DrivenLink:
    """A link of a program.

    Args:
        do: sends a command to the program, and returns its answer.
        url: of the gateway.
    """

    def __init__(self, do: Callable[[str], str], url: str) -> None:
        self._do = do
        self._url = url
        self._numbers = itertools.count()

    async def __aenter__(self) -> Self:
        await self._call("connect", self._url, "30")
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if error is None:
            await self._call("close")
        else:
            await asyncio.to_thread(self._do, "close")

    async def _call(self, command: str, *given: str | int) -> list[int]:
        line = " ".join([command, *(one if isinstance(one, str) else f"{one:X}" for one in given)])
        # Call the program in a thread: the gateway may run in this thread's event loop.
        status, _, rest = (await asyncio.to_thread(self._do, line)).partition(" ")
        if status != "0":
            raise _error(status, rest)
        return [int(float.fromhex(one)) if "x" in one else int(one) for one in rest.split()]

    async def read(self, address: int) -> int:
        (word,) = await self._call("read", address)
        return word

    async def write(self, address: int, word: int) -> None:
        await self._call("write", address, word)

    async def write_masked(self, address: int, word: int, mask: int) -> int:
        (before,) = await self._call("masked", address, word, mask)
        return before

    async def post(self, address: int, word: int) -> None:
        await self._call("post", address, word)

    async def fence(self) -> None:
        await self._call("fence")

    async def read_block(self, address: int, count: int) -> list[int]:
        return await self._call("rblock", address, count)

    async def write_block(self, address: int, words: Iterable[int]) -> None:
        await self._call("wblock", address, *words)

    async def read_queue(self, address: int, count: int) -> list[int]:
        return await self._call("rqueue", address, count)

    async def write_queue(self, address: int, words: Iterable[int]) -> None:
        await self._call("wqueue", address, *words)

    async def read_many(self, addresses: Iterable[int]) -> list[int]:
        return await self._call("rmany", *addresses)

    async def write_many(self, addresses: Iterable[int], words: Iterable[int]) -> None:
        await self._call("wmany", *itertools.chain.from_iterable(zip(addresses, words, strict=True)))

    def subscribe(self, addresses: Sequence[int], *, rate_hz: float = 0.0) -> DrivenSubscription:
        return DrivenSubscription(self._call, next(self._numbers), addresses, rate_hz)


class DrivenSubscription:
    """A subscription of a program."""

    def __init__(
        self, call: Callable[..., Coroutine[Any, Any, list[int]]], number: int, addresses: Sequence[int], rate_hz: float
    ) -> None:
        self._call, self._number, self._addresses, self._rate_hz = call, number, addresses, rate_hz

    async def __aenter__(self) -> Self:
        await self._call("subscribe", self._number, f"{self._rate_hz}", "-", *self._addresses)
        return self

    async def __aexit__(self, *error: object) -> None:
        await self._call("unsubscribe", self._number)

    async def publish(self) -> None:
        await self._call("publish", self._number)

    def __aiter__(self) -> Self:
        return self

    async def __anext__(self) -> DrivenSample:
        sequence, lost, _, *words = await self._call("next", self._number, f"{PATIENCE}")
        return DrivenSample(sequence, lost, words)


def _error(status: str, sentence: str) -> Exception:
    """Return the Python exception for an error that a program has reported."""
    if not _LOST.fullmatch(status):
        return _KINDS[status](sentence)
    outcome = next((known for words, known in _OUTCOMES.items() if words in sentence), Outcome.UNKNOWN)
    return LinkLostError(sentence, outcome)
