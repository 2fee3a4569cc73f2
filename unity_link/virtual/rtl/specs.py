"""The compiled gateware of a spec: its design, its configuration, and its C++.

The design is the output of `generate vhdl`, the gateway with the register bank of the spec, with a top without records.
GHDL and Yosys convert it at first use. The C++ is stored in the user's cache under a hash of all of its inputs.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import logging
import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from unity_link.errors import ArgumentError, ConnectError
from unity_link.gateware.cache import is_whole
from unity_link.gateware.external import FolderError, running, temporary_folder
from unity_link.gateware.limits import check_generics
from unity_link.generate import Templates
from unity_link.generate.verilog import flat_design
from unity_link.generate.verilog.flat import FIFO, flat_ports, triggers
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.folder import read_vhdl
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import USUAL_POLYNOMIALS
from unity_link.spec.model import Way
from unity_link.spec.rates import base_millihertz
from unity_link.virtual.generics import FEATURES, generics_of, info_of
from unity_link.virtual.rtl.compiling import cache_folder, compiler
from unity_link.virtual.rtl.configurations import Configuration, Design

if TYPE_CHECKING:
    import subprocess
    from collections.abc import Iterator, Mapping

    from unity_link.spec import Interface

log = logging.getLogger("unity_link.rtl")
_LEAST_CLOCK_HZ = 500_000
"""Clock frequency in Hz that a PC simulates in real time if idle cycles are skipped."""
_CLOCK_OF_CORES_HZ = 200_000
"""Clock frequency in Hz that a PC simulates in real time with cores, for which each cycle is computed."""
_MOST_CLOCK_HZ = 100_000_000
"""Clock frequency in Hz above which the search for a suitable clock stops."""
_LEAST_CYCLES = 16
"""Least number of clock cycles in a period of a core's frequency (a generic in Hz), as the resolution of a pulse."""
_USUAL_BASES = tuple(digit * 10**power for power in range(7, 2, -1) for digit in (10, 5, 2))
"""Base frequencies in mHz, highest first: the gateware's default, and round fractions of it."""
_ROUND_CYCLES = 8
"""Clock cycles that a base tick needs in addition to one for each group (ul_subscription_manager.vhd)."""
_OF_THE_BANK = frozenset({"address_bits", "data_bits", "wb_pipelined", "fingerprint"})
"""Generics that the generated gateway sets itself."""
_FIFOS = {"receive_fifo_bytes": "rx_fifo_depth", "transmit_fifo_bytes": "tx_fifo_depth"}


def with_clock(generics: Mapping[str, int], least_hz: int = _LEAST_CLOCK_HZ) -> dict[str, int]:
    """Return generics with the slowest clock that the groups allow, because a PC simulates only about 1 MHz."""
    base_hz = generics["base_frequency_millihertz"] / 1000
    ticks = max(1, -(-least_hz // base_hz), generics["groups"] + _ROUND_CYCLES)
    return {"clock_hz": round(base_hz * ticks), **generics}


def _least_clock_of(interface: Interface) -> int:
    """Return the lowest useful clock frequency of an interface, in Hz."""
    if not interface.cores:
        return _LEAST_CLOCK_HZ
    generics = [item for part in interface.cores if part.core is not None for item in part.core.generics.items()]
    rates = [int(value) for name, value in generics if name.endswith("_hz")]
    return max([_CLOCK_OF_CORES_HZ, *(_LEAST_CYCLES * rate for rate in rates)])


def _base_of(interface: Interface, clock_hz: int, groups: int) -> int:
    """Return the base frequency of an interface in mHz, low enough for the cycles of all groups between two ticks."""
    most = clock_hz * 1000 // (groups + _ROUND_CYCLES)
    usual = next((base for base in _USUAL_BASES if base <= most), _USUAL_BASES[-1])
    return base_millihertz(interface.groups, usual)


def _clocked(
    interface: Interface, given: Mapping[str, int], fields: Mapping[str, int], least_hz: int
) -> dict[str, int]:
    """Return the generics of an interface with its clock: the given one, or the slowest that its cores allow."""
    while True:
        generics = dict(given)
        if "base_frequency_millihertz" not in fields and ("clock_hz" in fields or interface.cores):
            base = _base_of(interface, fields.get("clock_hz", least_hz), generics["groups"])
            generics["base_frequency_millihertz"] = base
        generics = with_clock(generics, least_hz)
        is_given = "clock_hz" in fields or least_hz > _MOST_CLOCK_HZ
        if is_given or not interface.beyond_limits(generics["clock_hz"]):
            return generics
        least_hz += least_hz // 4


def configuration_of(
    interface: Interface, fields: Mapping[str, int], node: int | None, *, unchecked: bool = False
) -> Configuration:
    """Return the configuration of an interface, a gateway with a register bank, whose C++ must still be made.

    Args:
        interface: interface of a spec.
        fields: fields of `GatewayInfo` that differ from the spec's defaults.
        node: node number on a shared medium; None if the medium is not shared.
        unchecked: True if the user's VHDL is not compared with its Verilog.

    Raises:
        ArgumentError: if the gateware does not support the configuration.
        UnsupportedError: if the addresses of two modules overlap.
    """
    for name in ("address_bits", "data_bits"):
        if fields.get(name, getattr(interface, name)) != getattr(interface, name):
            raise ArgumentError(
                f"{name} is {fields[name]}: the register bank of {interface.name} has the {getattr(interface, name)} "
                "of its spec; GATEWAY(...) in the spec changes it"
            )
    given = {**generics_of(interface), **_as_generics(fields), "node": -1 if node is None else node}
    generics = _clocked(interface, given, fields, _least_clock_of(interface))
    if not generics["fingerprint"] and "build_id" not in fields:
        generics["build_id"] = 0
    # The generated gateway computes this generic in the same way.
    generics["fingerprint"] = generics["build_id"] == interface.fingerprint
    generics["description"] = bool(generics["description"] and interface.is_described)
    check_generics(generics)
    interface.check_clock(generics["clock_hz"])
    design = _design_of(interface, generics, unchecked=unchecked)
    return Configuration(
        interface.name, info_of(generics), "", node, json.dumps(generics, sort_keys=True), design=design
    )


def _design_of(interface: Interface, generics: Mapping[str, int], *, unchecked: bool) -> Design:
    """Return the gateway of an interface with its register bank and a FIFO, with the given defaults of generics.

    Raises:
        UnsupportedError: if the addresses of two modules overlap.
    """
    given = {"physical": 'string := "fifo"', "flow_control": "boolean := true"}
    left = _OF_THE_BANK if interface.is_described else _OF_THE_BANK | {"description"}
    given |= {name: _declared(name, value) for name, value in generics.items() if name not in left}
    files = flat_design(
        interface, Templates("verilog", None, {}), given, [*FIFO, triggers(generics["groups"])], has_pads=True
    )
    bank = Bank(interface)
    masters = tuple((port.name, port.first) for port in bank.ports)
    own = tuple((path, read_vhdl(Path(path))) for path in interface.vhdl)
    sources = tuple((file.name, file.text) for file in files)
    return Design(sources, masters, own, bank.wiring.own_instances(generics["clock_hz"]), unchecked)


def ports_of(interface: Interface) -> dict[str, dict[str, str]]:
    """Return the names of each signal's ports in the design of an interface, by path of the signal and kind of port.

    The ports of a register at pins are the pins; no port shows that such a register was written.
    """
    found: dict[str, dict[str, str]] = {}
    bank = Bank(interface)
    for port in flat_ports(bank, [*FIFO, triggers(0)]):
        found.setdefault(port.path, {})[port.pin] = port.name
    for pin in bank.wiring.pins:
        if pin.path in interface.signals:
            found[pin.path] = {"given" if pin.way is Way.IN else "got": pin.name}
    return found


def _declared(name: str, value: int) -> str:
    """Return the VHDL type and default of a generic."""
    if name in ("crc_polynomial", "build_id"):
        return f'std_logic_vector(31 downto 0) := x"{value:08X}"'
    return f"boolean := {str(value).lower()}" if isinstance(value, bool) else f"integer := {value}"


def configuration_of_node(info: GatewayInfo, node: int) -> Configuration:
    """Return the configuration of a node on a shared medium, whose C++ must still be made.

    Raises:
        ArgumentError: if the gateware does not support the configuration.
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
        generics |= {generic: feature in features for generic, feature in FEATURES.items()}
    return generics


def made(configuration: Configuration) -> Configuration:
    """Return a configuration with its C++; make the C++ if neither the installation nor the cache has it.

    Raises:
        ConnectError: if a tool is missing or refuses the gateware, or the C++ cannot be stored.
    """
    path = _path_of(configuration)
    if path is None:
        return configuration
    if not is_whole(path):
        with _making(configuration, path) as process:
            _check(configuration, process, process.communicate()[1])
    return configuration.made(path)


async def make_beside(configuration: Configuration) -> Configuration:
    """Return a configuration as `made` does, without blocking the event loop; cancellation ends the tools.

    Raises:
        ConnectError: as for `made`.
    """
    path = _path_of(configuration)
    if path is None:
        return configuration
    if not is_whole(path):
        with _making(configuration, path) as process:
            # Wait in a thread, because not all event loops support processes of asyncio.
            _check(configuration, process, (await asyncio.to_thread(process.communicate))[1])
    return configuration.made(path)


def _path_of(configuration: Configuration) -> Path | None:
    """Return the path of a configuration's C++ in the cache; None for a configuration of the installation."""
    if not configuration.generics:
        return None
    from unity_link.virtual.rtl.making import origin

    named = origin(json.loads(configuration.generics), configuration.design)
    return cache_folder() / f"{configuration.name}-{named}.cc"


@contextlib.contextmanager
def _making(configuration: Configuration, path: Path) -> Iterator[subprocess.Popen[bytes]]:
    """Run the tools that make the C++ of a configuration, and log the duration."""
    # Report a missing C++ compiler before the tools run.
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
    environment = {"PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    try:
        with temporary_folder() as scratch:
            wanted = scratch / "configuration.json"
            wanted.write_bytes(msgspec.json.encode(configuration))
            command = [sys.executable, "-m", "unity_link.virtual.rtl.making", str(wanted), str(path)]
            with running(command, scratch, environment=environment) as process:
                yield process
    except FolderError as error:
        raise ConnectError(f"the gateware of {configuration.name} cannot be built: {error}") from error
    log.warning("the gateware of %s was built in %.0f s", configuration.name, time.monotonic() - began)


def _check(configuration: Configuration, process: subprocess.Popen[bytes], said: bytes) -> None:
    """Log the tools' messages about the user's files; raise `ConnectError` if the tools have failed."""
    lines = said.decode(errors="replace").strip().splitlines()
    if not process.returncode:
        for line in lines:
            log.warning("%s", line)
        return
    reason = "\n".join(lines[-1:] if lines and "Traceback" in lines[0] else lines) or "no reason given"
    raise ConnectError(f"the gateware of {configuration.name} cannot be built: {reason}")
