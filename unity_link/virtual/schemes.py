"""``sim:`` and ``rtl:``: a virtual gateway in this process, for tests and demonstrations without hardware.

``sim:`` is a model of the gateware, ``rtl:`` the gateware itself, compiled; ``sim:scara`` and ``rtl:scara`` have the
robot behind their bus, ``tosnet`` in place of ``scara`` has it behind the double buffers of a TosNet network;
``sim:robot.ul`` and ``rtl:robot.ul`` have that of a spec, with a model of it by ``?model=my.py:Rover``, faults
(``fault=``) and triggers (``trigger=state:10``).

Options choose its configuration, by the names of `GatewayInfo` (``sim:?data_bits=16&id_digits=3``), and what the line
does to the bytes of both directions: ``loss``, ``flip``, ``double`` (probabilities for each byte, a ``seed`` chooses
which), and ``bytes_per_second``. A model can have any configuration, the gateware those that were compiled.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.virtual.build import CHANCES, CONFIGURATION, ROBOT_OPTIONS, Wanted, build_gateway, compile_gateway

if TYPE_CHECKING:
    import asyncio

    from unity_link.transport import DriverUrl

OPTIONS = frozenset({*CONFIGURATION, *CHANCES, *ROBOT_OPTIONS, "seed", "bytes_per_second"})
RTL = "rtl"


async def prepare(url: DriverUrl) -> None:
    """Compile the gateware, if it is wanted for the first time.

    Raises:
        ArgumentError: for a configuration that was not compiled.
        ConnectError: where it can't be compiled here.
    """
    if url.scheme == RTL:
        await compile_gateway(_wanted(url))


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Build a gateway and connect to it.

    Raises:
        ArgumentError: for a robot or an option that does not exist, or a value that no gateway can have.
        SpecError: with everything that is wrong with a spec.
    """
    gateway = build_gateway(
        _wanted(url),
        chances={name: url.number(name) for name in CHANCES if name in url.options},
        seed=url.integer("seed", 0),
        bytes_per_second=url.number("bytes_per_second") if "bytes_per_second" in url.options else None,
    )
    return await gateway.open(protocol)


def _wanted(url: DriverUrl) -> Wanted:
    if url.host:
        raise ArgumentError(
            f"{url.text} has a host: {url.scheme}:, {url.scheme}:NAME or {url.scheme}:robot.ul was expected"
        )
    return Wanted.of_url(url, url.path, rtl=url.scheme == RTL)
