"""Reads and writes by keys: queries, which are answered, and publications by clients, which are written.

These keys are below the prefix of the bridge:

- ``signals/j1/cpos``: a query returns the value, or writes its payload; a query of ``signals/**`` returns all values
- ``read``: a query with a list of paths returns an object of values; without a payload, the values of all signals
- ``write``: a query with an object of values by paths, or a list of such objects, writes them, and is answered after
  all writes have been executed; a publication writes the same without an answer
- ``info``: a query returns the description of the robot

Payloads are JSON. Writes of one sender are executed in order. All values of a message are checked before the first of
them is written.
"""

from __future__ import annotations

import asyncio
import functools
from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.bridges.log_once import Faults
from unity_link.bridges.merged_writes import Objects, write_in_order
from unity_link.bridges.topic_names import topic_names
from unity_link.bridges.zenoh.describing import describe
from unity_link.bridges.zenoh.writing import Reader
from unity_link.data import Group, Readable, Writable
from unity_link.errors import ArgumentError, GatewayResetError, UnansweredError, UnityLinkError
from unity_link.transport.inbox import Inbox

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

    import zenoh

    from unity_link.bridges.serve.shared import SharedLink
    from unity_link.data import Proxy, Robot
    from unity_link.transport.zenoh_session import Declaration

    Answering = Callable[[zenoh.KeyExpr, bytes], Awaitable[dict[str, object]]]
    """Returns the replies to a query with a key and a payload, by the names of keys below the prefix."""

MOST_QUERIES = 1024
"""Most queries that are being answered; further ones are refused."""
MOST_PUTS = 4096
"""Most publications that wait to be written; with more, their publishers block."""
JSON = "application/json"
AWAY = "the gateway is away; nothing was done that it has not done already"


class ZenohSignals:
    """The signals of a robot at their keys.

    Args:
        session: an open session.
        prefix: prefix of all keys.
        robot: robot on an open link.
        shared: shared link that this link is a client of.
        report: called with a sentence about publications that cannot be written, once for each kind of fault.
    """

    def __init__(
        self, session: zenoh.Session, prefix: str, robot: Robot, shared: SharedLink, report: Callable[[str], None]
    ) -> None:
        self.written = 0
        """Number of values written."""
        self.answered = 0
        """Number of queries answered."""
        self._session = session
        self._prefix = prefix
        self._robot = robot
        self._shared = shared
        self._faults = Faults(report)
        names = topic_names(robot.interface)
        self._by_name = {f"signals/{names[proxy.path]}": proxy for proxy in robot.signals}
        self._reader = Reader(robot)
        self._group = functools.lru_cache(256)(self._make_group)
        self._answering: set[asyncio.Task[None]] = set()
        self._inbox: Inbox[bytes]
        self._puts: asyncio.Queue[list[bytes]] = asyncio.Queue()
        self._ended = False

    async def run(self) -> None:
        """Answer queries and write publications until this is cancelled. Earlier publications are still written then.

        Raises:
            LinkLostError: if the link ends for good.
        """
        self._inbox = published = Inbox(self._take, MOST_PUTS)
        kinds = {"signals/**": self._signals, "read": self._read, "write": self._write, "info": self._info}
        asked: list[Inbox[zenoh.Query]] = [Inbox(functools.partial(self._begin, kind)) for kind in kinds.values()]
        declared: list[Declaration] = [
            self._session.declare_queryable(f"{self._prefix}/{key}", inbox.give)
            for key, inbox in zip(kinds, asked, strict=True)
        ]
        subscriber = self._session.declare_subscriber(
            f"{self._prefix}/write", lambda sample: published.give(sample.payload.to_bytes())
        )
        writing = asyncio.ensure_future(self._write_puts())
        try:
            await asyncio.shield(writing)
        finally:
            self._ended = True
            self._puts.put_nowait(published.close())
            for inbox in asked:
                inbox.close()
            for one in (*declared, subscriber):
                one.undeclare()
            for task in self._answering:
                task.cancel()
            await writing

    # Publications by clients

    def _take(self, payloads: list[bytes]) -> None:
        # The inbox collects further publications until these are written; if it is full, a fast publisher blocks.
        self._inbox.hold()
        self._puts.put_nowait(payloads)

    async def _write_puts(self) -> None:
        while not self._ended or not self._puts.empty():
            objects = []
            for payload in await self._puts.get():
                try:
                    objects += self._reader.read(payload)
                except ArgumentError as error:
                    self._faults.tell(str(error))
            if objects:
                await self._post(objects)
            self._inbox.release()

    async def _post(self, objects: Objects) -> None:
        faults = await write_in_order(objects, posted=True)
        try:
            await self._robot.link.fence()
        except UnityLinkError as error:
            faults.append(error)
        if not faults:
            self.written += sum(map(len, objects))
        for fault in faults:
            if isinstance(fault, UnansweredError) and not isinstance(fault, GatewayResetError):
                raise fault
            self._faults.tell(AWAY if self._shared.away else str(fault))

    # Queries

    def _begin(self, answering: Answering, queries: list[zenoh.Query]) -> None:
        for query in queries:
            if len(self._answering) >= MOST_QUERIES:
                with query:
                    _refuse(query, f"{MOST_QUERIES} queries are being answered already: put several values into one")
                continue
            task = asyncio.create_task(self._answer(answering, query))
            self._answering.add(task)
            task.add_done_callback(self._answering.discard)

    async def _answer(self, answering: Answering, query: zenoh.Query) -> None:
        payload = query.payload.to_bytes() if query.payload is not None else b""
        with query:
            try:
                answers = await answering(query.key_expr, payload)
            except (UnityLinkError, UnicodeDecodeError) as error:
                _refuse(query, AWAY if self._shared.away and not isinstance(error, ArgumentError) else str(error))
                return
            for name, value in answers.items():
                query.reply(f"{self._prefix}/{name}", msgspec.json.encode(value), encoding=JSON)
            self.answered += 1

    async def _info(self, _: zenoh.KeyExpr, __: bytes) -> dict[str, object]:
        return {"info": describe(self._robot, self._prefix) | {"written": self.written}}

    async def _write(self, key: zenoh.KeyExpr, payload: bytes) -> dict[str, object]:
        if not _names(key, "write") or (_is_pattern(key) and not payload):
            # A query for all keys must not write.
            return {}
        return {"write": await self._write_objects(self._reader.read(payload))}

    async def _write_objects(self, objects: Objects) -> dict[str, int]:
        for error in await write_in_order(objects, posted=False):
            raise error
        count = sum(map(len, objects))
        self.written += count
        return {"written": count}

    async def _read(self, key: zenoh.KeyExpr, payload: bytes) -> dict[str, object]:
        if payload:
            if not _names(key, "read"):
                return {}
            try:
                paths = msgspec.json.decode(payload, type=list[str])
            except (msgspec.DecodeError, RecursionError) as error:
                raise ArgumentError(f'a list of paths was expected, as in ["j1.cpos"]: {error}') from None
        else:
            paths = [proxy.path for proxy in self._robot.signals if isinstance(proxy, Readable)]
        if not paths:
            return {"read": {}}
        values = await self._group(tuple(dict.fromkeys(self._robot[path] for path in paths))).get()
        return {"read": {path: values[self._robot[path]] for path in paths}}

    async def _signals(self, key: zenoh.KeyExpr, payload: bytes) -> dict[str, object]:
        found = {name: proxy for name, proxy in self._by_name.items() if key.intersects(_key(f"{self._prefix}/{name}"))}
        if payload:
            # A query of `**` with a payload for `read` or `write` also matches signals: the payload is not for them.
            if "/signals/" not in str(key) or (_is_pattern(key) and not found):
                return {}
            return await self._write_signal(key, found, payload)
        readable = {name: proxy for name, proxy in found.items() if isinstance(proxy, Readable)}
        if not readable:
            if _is_pattern(key):
                # The wildcards select keys of another handler of this bridge, or of another bridge.
                return {}
            one = next(iter(found.values()), None)
            raise ArgumentError(
                f"there is no signal at {key}" if one is None else f"{one.path} cannot be read through Zenoh"
            )
        values = await self._group(tuple(readable.values())).get()
        return {name: values[proxy] for name, proxy in readable.items()}

    async def _write_signal(
        self, key: zenoh.KeyExpr, found: dict[str, Proxy[Any]], payload: bytes
    ) -> dict[str, object]:
        if len(found) != 1:
            raise ArgumentError(f"{key} is {len(found)} signals, and a value is for one: write several at /write")
        ((name, proxy),) = found.items()
        if not isinstance(proxy, Writable):
            raise ArgumentError(f"{proxy.path} can only be read")
        return {name: await self._write_objects(self._reader.read_one(proxy, payload))}

    @staticmethod
    def _make_group(proxies: tuple[Proxy[Any], ...]) -> Group:
        return Group(*proxies)


def _is_pattern(key: zenoh.KeyExpr) -> bool:
    """Return whether a key has wildcards: it may select keys of several handlers and bridges."""
    return "*" in str(key)


def _names(key: zenoh.KeyExpr, name: str) -> bool:
    """Return whether the last level of a key is this name, not a wildcard."""
    return str(key).rpartition("/")[2] == name


@functools.lru_cache(4096)
def _key(text: str) -> zenoh.KeyExpr:
    import zenoh

    return zenoh.KeyExpr(text)


def _refuse(query: zenoh.Query, text: str) -> None:
    query.reply_err(msgspec.json.encode({"error": text}), encoding=JSON)
