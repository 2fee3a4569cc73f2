"""The gateware of a spec: which configuration follows from it, and where its C++ comes from.

One that an installation has is taken. Any other one is made by GHDL and Yosys when it is wanted for the first time, and
its C++ is kept in the user's cache, under a hash of all that it was made from.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import os
import sys
import time
from typing import TYPE_CHECKING

from unity_link.errors import ConnectError
from unity_link.gateware.limits import check_generics
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.protocol.crc import USUAL_POLYNOMIALS
from unity_link.virtual.generics import FEATURES, generics_of, info_of
from unity_link.virtual.rtl.compiling import cache_folder, compiler, running
from unity_link.virtual.rtl.configurations import Configuration, configurations

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Iterator, Mapping
    from pathlib import Path

    from unity_link.spec import Interface

log = logging.getLogger("unity_link.rtl")
_LEAST_CLOCK_HZ = 500_000
"""A clock that a PC keeps pace with."""
_ROUND_CYCLES = 8
"""Clock cycles of a base tick beside one for each group (gateware/rtl/application/ul_subscription_manager.vhd)."""
_KINDS = {
    **FEATURES,
    "flow_control": Feature.FLOW_CONTROL,
    "fingerprint": Feature.FINGERPRINT,
    "half_duplex": Feature.HALF_DUPLEX,
}
_FIFOS = {"receive_fifo_bytes": "rx_fifo_depth", "transmit_fifo_bytes": "tx_fifo_depth"}


def with_clock(generics: Mapping[str, int]) -> dict[str, int]:
    """Return generics with the slowest clock that their groups allow: a PC simulates a million cycles a second."""
    base_hz = generics["base_frequency_millihertz"] / 1000
    ticks = max(1, -(-_LEAST_CLOCK_HZ // base_hz), generics["groups"] + _ROUND_CYCLES)
    return {"clock_hz": round(base_hz * ticks), **generics}


def configuration_of(interface: Interface, fields: Mapping[str, int], node: int | None) -> Configuration:
    """Return the configuration of an interface: one that there is, or one that is to be made.

    Args:
        interface: of a spec.
        fields: of `GatewayInfo` that are to be otherwise.
        node: its number on a medium that several share, None for a medium of its own.

    Raises:
        ArgumentError: for a configuration that the gateware does not have.
    """
    generics = with_clock({**generics_of(interface), **_as_generics(fields), "node": -1 if node is None else node})
    if node is None:
        del generics["node"]
    check_generics(generics)
    info = info_of(generics)
    for known in configurations().values():
        if (known.info, known.node) == (info, node):
            return known
    return Configuration(interface.name, info, "", node, json.dumps(generics, sort_keys=True))


def configuration_of_node(info: GatewayInfo, node: int) -> Configuration:
    """Return the configuration of a node on a medium that several share, which is to be made.

    Raises:
        ArgumentError: for a configuration that the gateware does not have.
    """
    fields = {name: getattr(info, name) for name in GatewayInfo.__struct_fields__ if name != "protocol_version"}
    generics = {**_as_generics(fields), "node": node}
    check_generics(generics)
    return Configuration(f"node_{node}", info_of(generics), "", node, json.dumps(generics, sort_keys=True))


def _as_generics(fields: Mapping[str, int]) -> dict[str, int]:
    generics = {_FIFOS.get(name, name): value for name, value in fields.items() if name != "features"}
    if fields.get("crc_bits") in USUAL_POLYNOMIALS:
        generics.setdefault("crc_polynomial", USUAL_POLYNOMIALS[fields["crc_bits"]])
    if "features" in fields:
        features = Feature(fields["features"])
        generics |= {generic: feature in features for generic, feature in _KINDS.items()}
    return generics


def made(configuration: Configuration) -> Configuration:
    """Return a configuration with its C++, which is made unless there is some.

    Raises:
        ConnectError: where a tool is missing, or refuses the gateware, or the result cannot be kept.
    """
    path = _path_of(configuration)
    if path is None:
        return configuration
    if not path.exists():
        with _making(configuration, path) as process:
            _check(configuration, process, process.communicate()[1])
    return configuration.made(path)


async def make_beside(configuration: Configuration) -> Configuration:
    """Do what `made` does while the event loop goes on; cancellation ends the tools.

    Raises:
        ConnectError: as `made`.
    """
    path = _path_of(configuration)
    if path is None:
        return configuration
    if not path.exists():
        with _making(configuration, path) as process:
            # A thread waits, for processes of asyncio need a loop that watches children.
            _check(configuration, process, (await asyncio.to_thread(process.communicate))[1])
    return configuration.made(path)


def _path_of(configuration: Configuration) -> Path | None:
    """Return where the C++ of a configuration is, or is to be; None for one that is part of the installation."""
    if not configuration.generics:
        return None
    from unity_link.virtual.rtl.making import origin

    return cache_folder() / f"{configuration.name}-{origin(json.loads(configuration.generics))}.cc"


@contextlib.contextmanager
def _making(configuration: Configuration, path: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Run what makes the C++ of a configuration, and tell how long that has taken."""
    # What is missing at the end is told at the beginning.
    compiler()
    log.warning("building the gateware of %s: once, this takes half a minute or so", configuration.name)
    began = time.monotonic()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ConnectError(
            f"the gateware of {configuration.name} can't be kept in {path.parent} ({error.strerror}): name another "
            "folder in XDG_CACHE_HOME"
        ) from error
    command = [sys.executable, "-m", "unity_link.virtual.rtl.making", configuration.name, configuration.generics]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    with running([*command, str(path)], environment) as process:
        yield process
    log.warning("the gateware of %s was built in %.0f s", configuration.name, time.monotonic() - began)


def _check(configuration: Configuration, process: subprocess.Popen[bytes], said: bytes) -> None:
    if process.returncode:
        lines = said.decode(errors="replace").strip().splitlines() or ["no reason given"]
        reason = lines[-1] if "Traceback" in lines[0] else "\n".join(lines)
        raise ConnectError(f"the gateware of {configuration.name} cannot be built: {reason}")
