"""Bench: a gateway with 256 groups of 255 addresses sets, starts, samples and publishes its last group."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING

import cocotb

from gateware.bench.unity_link.gateway import Gateway, checked

if TYPE_CHECKING:
    from cocotb.handle import SimHandleBase


@cocotb.test
async def the_last_group_has_as_many_addresses_as_the_first(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    rng = random.Random(1)
    memory = {address: rng.getrandbits(8) for address in range(256)}
    await gateway.ask(b"WM00" + b"".join(b"%02X" % memory[address] for address in range(255)))
    await gateway.ask(b"WFF%02X" % memory[255])
    lists = {group: rng.choices(range(256), k=255) for group in (0, 128, 255)}
    for group, addresses in lists.items():
        settings = b"GS%02X000001FF" % group + bytes(addresses).hex().upper().encode()
        assert await gateway.ask(settings) == b"GS%02X" % group
    for group, addresses in lists.items():
        words = b"".join(b"%02X" % memory[address] for address in addresses)
        expected = checked(b"P%02X00" % group + words) + checked(b"GP%02X" % group)
        assert await gateway.answer(checked(b"GP%02X" % group), count=2) == expected
    assert await gateway.ask(b"GP01") == b"X06"


@cocotb.test
async def all_groups_are_published_periodically(dut: SimHandleBase) -> None:
    gateway = Gateway(dut)
    await gateway.begin()
    for group in range(256):
        gateway.send(checked(b"GS%02X21000101%02X" % (group, group)) + checked(b"GN%02X" % group))
    # At least two base ticks after the last group was started.
    await gateway.quiet(300)
    await gateway.cycles(25_000)
    frames = gateway.take().splitlines(keepends=True)
    samples = [frame for frame in frames if frame.startswith(b"P")]
    assert {int(frame[1:3], 16) for frame in samples} == set(range(256))
    assert len(frames) - len(samples) == 2 * 256
    for group in (0, 255):
        own = [frame for frame in samples if frame.startswith(b"P%02X" % group)]
        assert [int(frame[3:5], 16) for frame in own] == list(range(len(own)))
