"""Builds a virtual gateway from what a user says, in a URL or on the command line: robot, widths, faults."""

from __future__ import annotations

from typing import TYPE_CHECKING

from unity_link.errors import ArgumentError, UnsupportedError
from unity_link.protocol.configuration import Feature, GatewayInfo
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.gateway import BareGateway, Gateway, VirtualGateway
from unity_link.virtual.line import SlowLine
from unity_link.virtual.scara import Scara
from unity_link.virtual.tosnet import ScaraOnTosnet
from unity_link.virtual.walker import Walker

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

ROBOTS: dict[str, Callable[[BareGateway], object]] = {
    "": lambda _: None,
    "scara": Scara.attach,
    "tosnet": ScaraOnTosnet.attach,
    "walker": Walker.attach,
}
"""What can stand behind the bus, by name; the empty name is plain memory."""
CHANCES = ("loss", "flip", "double")
"""Probabilities of `Noise` that a user can choose."""
CONFIGURATION = tuple(name for name in GatewayInfo.__struct_fields__ if name != "protocol_version")
"""Fields of `GatewayInfo` that a user can choose."""
_POLYNOMIALS = {8: 0x07, 16: 0x1021, 32: 0x04C11DB7}


def build_gateway(
    robot: str = "",
    configuration: Mapping[str, int] | None = None,
    *,
    rtl: bool = False,
    node: int | None = None,
    chances: Mapping[str, float] | None = None,
    seed: int = 0,
    bytes_per_second: float | None = None,
) -> Gateway:
    """Build a gateway.

    Args:
        robot: a name from `ROBOTS`.
        configuration: fields of `GatewayInfo` that are not as in the gateware's default build.
        rtl: take the compiled gateware, of the configurations that there are, instead of the model.
        node: its number on a shared medium.
        chances: probabilities of `CHANCES`, for each byte in both directions.
        seed: chooses the course of the noise; both directions have their own.
        bytes_per_second: rate of a line with the FIFOs of the configuration, None for one without limit.

    Raises:
        ArgumentError: for an unknown robot, a value that no gateway can have, or one that was not compiled.
        ConnectError: where the gateware can't be compiled here.
    """
    if robot not in ROBOTS:
        known = ", ".join(name for name in ROBOTS if name)
        raise ArgumentError(f"no robot {robot!r} is known: one of {known} was expected, or none for plain memory")
    bare = _compiled(configuration or {}, node) if rtl else VirtualGateway(_info(configuration or {}), node=node)
    ROBOTS[robot](bare)
    gateway: Gateway = bare
    if bytes_per_second is not None:
        gateway = SlowLine(bare, bytes_per_second)
    if chances:
        gateway = NoisyLine(gateway, Noise(2 * seed, **chances), Noise(2 * seed + 1, **chances))
    return gateway


async def compile_gateway(configuration: Mapping[str, int], node: int | None = None) -> None:
    """Compile what `build_gateway` will take for `rtl`, if it is wanted for the first time, while the loop goes on.

    Raises:
        ArgumentError: for a configuration that there is not.
        ConnectError: where the gateware can't be compiled here.
    """
    from unity_link.virtual.rtl import choose
    from unity_link.virtual.rtl.compiling import compile_beside

    await compile_beside(choose(configuration, node))


def _compiled(configuration: Mapping[str, int], node: int | None) -> BareGateway:
    from unity_link.virtual.rtl import RtlGateway, choose

    return RtlGateway(choose(configuration, node).name)


def _info(configuration: Mapping[str, int]) -> GatewayInfo:
    values = dict(configuration)
    if "crc_bits" in values and values["crc_bits"] in _POLYNOMIALS:
        values.setdefault("crc_polynomial", _POLYNOMIALS[values["crc_bits"]])
    if "features" in values:
        values["features"] = Feature(values["features"])
    info = GatewayInfo(**values)  # type: ignore[arg-type]
    try:
        info.check()
    except UnsupportedError as error:
        raise ArgumentError(f"no such gateway can be built: {error}") from None
    return info
