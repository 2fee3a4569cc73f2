"""A URL creates a gateway, or causes one clear error."""

from __future__ import annotations

import asyncio

import pytest

from support.simulated_time import run_simulated
from unity_link.errors import ArgumentError
from unity_link.transport import load_driver, parse_url
from unity_link.virtual.build import build_gateway
from unity_link.virtual.transport import GatewayTransport


class Silent(asyncio.Protocol):
    """A protocol that ignores all events."""


def open_url(text: str) -> GatewayTransport:
    async def connect() -> asyncio.Transport:
        url = parse_url(text)
        return await load_driver(url.scheme).connect(url, Silent())

    transport = run_simulated(connect())
    assert isinstance(transport, GatewayTransport)
    return transport


def answer(text: str, request: bytes) -> bytes:
    sent: bytes = open_url(text).get_extra_info("gateway").receive(request, 0.0)
    return sent


def test_sim_is_a_gateway_of_the_default_build_with_plain_memory() -> None:
    assert answer("sim:", b"W8001\rR80\r") == b"W80\r\nR8000000001\r\n"
    assert open_url("sim:").get_extra_info("gateway").info.data_bits == 32


def test_sim_scara_has_the_robot_on_its_bus() -> None:
    assert answer("sim:scara", b"W8001\r") == b"X04\r\n"


def test_options_set_the_configuration() -> None:
    info = open_url("sim:?data_bits=16&id_digits=3&crc_bits=16&clock_hz=100000000").get_extra_info("gateway").info
    assert (info.data_bits, info.id_digits, info.clock_hz) == (16, 3, 100_000_000)
    assert (info.crc_bits, info.crc_polynomial) == (16, 0x1021)
    assert answer("sim:?node=0x1A", b"Z1AH\r") == b"Z1AH\r\n"


def test_options_set_the_noise_and_its_seed() -> None:
    request = b"RM00FF\r" * 20
    spoiled = [answer(f"sim:?flip=0.01&loss=0.01&double=0.01&seed={seed}", request) for seed in (1, 1, 2)]
    assert spoiled[0] == spoiled[1] != spoiled[2]


def test_an_option_sets_a_slow_line() -> None:
    gateway = open_url("sim:?bytes_per_second=1000").get_extra_info("gateway")
    assert gateway.receive(b"H\r", 0.0) == b""
    assert gateway.next_due == pytest.approx(0.003)
    assert gateway.advance(0.0031) == b"H\r\n"


@pytest.mark.parametrize(
    ("url", "words"),
    [
        ("sim:delta", "no robot 'delta' is known: one of scara, tosnet, walker was expected, or the path"),
        ("sim:?data_bits=7", "data_bits = 7, expected 8 to 64"),
        ("sim:?bytes_per_second=nan", "is not a number"),
        ("sim:?receive_fifo_bytes=65536", "receive_fifo_bytes = 65536, expected 0 to 65535"),
        ("sim:?data_bits=wide", "not a whole number"),
        ("sim:?loss=much", "not a number"),
        ("sim:?loss=2", "loss=2.0 is no probability"),
        ("sim:?bytes_per_second=0", "no rate"),
        ("sim:?bytes_per_second=inf", "is not a number"),
        ("sim:?colour=red", "unknown option 'colour'"),
        ("sim:?node=255", "not from 0 to 254"),
        ("sim:scara?data_bits=16", "the SCARA needs words of at least 32 bits"),
        ("sim://host/scara", "has a host"),
    ],
)
def test_an_impossible_gateway_causes_one_clear_error(url: str, words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        open_url(url)


def test_the_two_directions_have_independent_noise() -> None:
    gateway = build_gateway(chances={"loss": 0.5}, seed=1)
    assert gateway.receive(b"H\r" * 50, 0.0) != build_gateway(chances={"loss": 0.5}, seed=2).receive(b"H\r" * 50, 0.0)
