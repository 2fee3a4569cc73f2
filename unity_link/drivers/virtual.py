"""``sim:`` and ``sim:scara``: a virtual gateway in this process, for tests and demonstrations without hardware.

Options choose its configuration, by the names of `GatewayInfo` (``sim:?data_bits=16&id_digits=3``), and what the line
does to the bytes of both directions: ``loss``, ``flip``, ``double`` (probabilities for each byte, a ``seed`` chooses
which), and ``bytes_per_second``.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.virtual.build import CHANCES, CONFIGURATION, build_gateway
from unity_link.virtual.serving import connect_gateway

if TYPE_CHECKING:
    import asyncio

    from unity_link.drivers import DriverUrl

OPTIONS = frozenset({*CONFIGURATION, *CHANCES, "seed", "bytes_per_second"})


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Build a gateway and connect to it.

    Raises:
        ArgumentError: for a robot or an option that does not exist, or a value that no gateway can have.
    """
    if url.host:
        raise ArgumentError(f"{url.text} has a host: sim: or sim:NAME was expected")
    gateway = build_gateway(
        url.path,
        {name: url.integer(name, 0) for name in CONFIGURATION if name in url.options},
        node=url.node,
        chances={name: url.number(name) for name in CHANCES if name in url.options},
        seed=url.integer("seed", 0),
        bytes_per_second=url.number("bytes_per_second") if "bytes_per_second" in url.options else None,
    )
    return await connect_gateway(gateway, protocol)
