"""``sim:`` and ``rtl:``: a virtual gateway in this process, for tests and demonstrations without hardware.

``sim:`` is a model of the gateware, and ``rtl:`` the compiled gateware. ``sim:scara`` and ``rtl:scara`` have the SCARA
robot on their bus; with ``tosnet`` it has the double buffers of a TosNet network. ``sim:robot.ul`` and ``rtl:robot.ul``
have the robot of a spec, optionally with a model (``?model=my.py:Rover``), faults (``fault=``) and triggers
(``trigger=state:10``).

Options select the configuration by the fields of `GatewayInfo` (``sim:?data_bits=16&id_digits=3``), and faults and the
rate of the line: ``loss``, ``flip`` and ``double`` (probabilities for each byte, with a ``seed``), and
``bytes_per_second``. The model supports all configurations, ``rtl:`` those in this installation or of a spec.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError
from unity_link.virtual.build import (
    CHANCES,
    CONFIGURATION,
    ROBOT_OPTIONS,
    Wanted,
    build_gateway,
    compile_gateway,
    find_interface,
)

if TYPE_CHECKING:
    import asyncio

    from unity_link.transport import DriverUrl

OPTIONS = frozenset({*CONFIGURATION, *CHANCES, *ROBOT_OPTIONS, "seed", "bytes_per_second"})
RTL = "rtl"


async def prepare(url: DriverUrl) -> None:
    """Compile the gateware of an ``rtl:`` URL, unless it is in the cache; read the spec of a ``sim:`` URL.

    On a slow computer, importing the compiler of specs takes longer than the time limit of a connection.

    Raises:
        ArgumentError: if the spec does not exist, or this installation does not have the configuration.
        ConnectError: if the gateware cannot be compiled on this machine.
        SpecError: if the spec has faults; the error lists all of them.
    """
    wanted = _wanted(url)
    if url.scheme == RTL:
        await compile_gateway(wanted)
    elif wanted.has_spec:
        find_interface(wanted.robot, wanted.interface)


async def connect(url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
    """Build a gateway and connect to it.

    Raises:
        ArgumentError: if a robot or an option does not exist, or no gateway can have one of the values.
        SpecError: if the spec has faults; the error lists all of them.
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
