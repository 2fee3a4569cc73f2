"""A gateway as a program, ``noting_gateway.py SOCKET NOTES``: it appends each word written to 0x20 to a file.

It samples the signals of `SPEC`; its bus refuses every access to 0x21.
"""

from __future__ import annotations

import asyncio
import os
import sys

from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.messages import ErrorCode
from unity_link.virtual import AccessError, VirtualGateway
from unity_link.virtual.serving import serve_unix

SPEC = """
group state(1, 1, TIMESTAMPS);
public plain() {
  @value = 0x10: unsigned READ(PUBLISH(state));
  @target = 0x20: unsigned WRITE(MAX=1000000);
  @refused = 0x21: unsigned WRITE();
  @angle = 0x22: signed WRITE(SCALE=0.5);
}
"""
NOTED, REFUSED = 0x20, 0x21


class Noting:
    """A device that appends each written word to a file at once, so that no word is lost if the program is killed."""

    def __init__(self, notes: str) -> None:
        self._file = os.open(notes, os.O_WRONLY | os.O_APPEND | os.O_CREAT)

    def read(self, offset: int, now: float) -> int:
        return 0

    def write(self, offset: int, value: int, now: float) -> None:
        os.write(self._file, b"%d\n" % value)


class Refusing:
    """A device that refuses every access."""

    def read(self, offset: int, now: float) -> int:
        raise AccessError(ErrorCode.BUS_ERROR)

    def write(self, offset: int, value: int, now: float) -> None:
        raise AccessError(ErrorCode.BUS_ERROR)


def noting_gateway(notes: str) -> VirtualGateway:
    gateway = VirtualGateway(GatewayInfo(base_frequency_millihertz=200_000))
    gateway.bus.attach(Noting(notes), [NOTED])
    gateway.bus.attach(Refusing(), [REFUSED])
    return gateway


async def main(place: str, notes: str) -> None:
    async with serve_unix(noting_gateway(notes), place):
        print("ready", flush=True)  # noqa: T201
        await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:]))
