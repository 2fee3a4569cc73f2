"""Inside the simulator: four generated gateways on one pair of wires, and the host's sessions, which take turns.

The pair is one signal. Its drivers are checked in every cycle in which one of them changes: the host, and each gateway
by
its `uart_de`. Frames and turns are those of the product; the bench is independent of the VHDL.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, Any

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, FallingEdge, Timer
from cocotb.utils import get_sim_time

from unity_link.protocol.host.events import Interrupted
from unity_link.protocol.host.requests import Request
from unity_link.protocol.host.session import Session
from unity_link.spec import compile_text
from unity_link.transport.turns import Line

if TYPE_CHECKING:
    from unity_link.protocol.host.events import Sampled
    from unity_link.transport.turns import Seat

NODES = (1, 2, 5, 0xFE)
CLOCK_HZ, BAUD = 10_000_000, 2_500_000
PERIOD_NS = 10**9 // CLOCK_HZ
BIT_NS = 10**9 // BAUD
LAMP = compile_text("public lamp() { @level = 0x10: unsigned READWRITE(); @other = 0x11: unsigned READWRITE(); }")
PAIR = f"""\
library ieee;
  use ieee.std_logic_1164.all;

entity pair is
  port (
    clk : in std_logic;
    rst : in std_logic_vector(0 to 3);
    host : in std_logic;
    host_drives : in std_logic;
    pair : out std_logic;
    drivers : out std_logic_vector(0 to 3)
  );
end entity pair;

architecture test of pair is
  type node_numbers_t is array (0 to 3) of integer;
  constant node_numbers : node_numbers_t := ({", ".join(map(str, NODES))});
  signal wire : std_logic;
  signal txd : std_logic_vector(0 to 3);
  signal enabled : std_logic_vector(0 to 3);
begin
  -- The bias keeps the wire at 1 while no station drives it.
  wire <= (host or not host_drives) and (txd(0) or not enabled(0)) and (txd(1) or not enabled(1))
          and (txd(2) or not enabled(2)) and (txd(3) or not enabled(3));
  pair <= wire;
  drivers <= enabled;
  each : for place in 0 to 3 generate
    gateway : entity work.lamp_gateway
      generic map (
        physical => "uart", half_duplex => true, node => node_numbers(place),
        clock_hz => {CLOCK_HZ}, baud => {BAUD}
      )
      port map (
        clk => clk, rst => rst(place), uart_rxd => wire, uart_txd => txd(place), uart_de => enabled(place),
        to_hardware => open
      );
  end generate each;
end architecture test;
"""


def clock() -> float:
    return get_sim_time("ns") * 1e-9


class HostLink:
    """A session and its slot on the pair, which sends in its turn."""

    def __init__(self, node: int, seat: Seat) -> None:
        self.session = Session(node, lambda: random.Random(node).getrandbits(16))
        self.seat = seat
        self.session.connect(clock(), 0.003, takes_turns=True, byte_time=10 / BAUD)
        self.events: list[Any] = []

    def step(self) -> bytes:
        """Return the bytes to send now."""
        session, seat = self.session, self.seat
        if session.deadline is not None and session.deadline <= clock():
            self.events += session.expire(clock())
        if not session.is_owed_an_answer and (seat.has_begun or not session.wants_turn):
            seat.give_back()
        if not session.wants_turn or not seat.ask():
            return b""
        self.events += session.take_turn(clock())
        seat.begin(session.longest_turn)
        return session.take_output()

    def ask(self, command: str, fields: bytes, digits: int | None) -> Request:
        request = Request(self.session.codec, command, fields, digits)
        self.events += self.session.submit(request, clock())
        return request


class Pair:
    """The pair of wires with its four nodes, and the host's end."""

    def __init__(self, dut: Any) -> None:
        self.dut = dut
        self.received = bytearray()
        self.most = 0
        line = Line("the pair", clock)
        self.links = [HostLink(node, line.join(node)) for node in NODES]

    async def begin(self) -> None:
        dut = self.dut
        dut.host.value, dut.host_drives.value, dut.rst.value = 1, 0, 0b1111
        Clock(dut.clk, PERIOD_NS, unit="ns").start()
        await ClockCycles(dut.clk, 4)
        dut.rst.value = 0
        await ClockCycles(dut.clk, 20)
        for watched in (self._receive(), self._watch(dut.drivers), self._watch(dut.host_drives)):
            cocotb.start_soon(watched)

    async def _watch(self, signal: Any) -> None:
        while True:
            await signal.value_change
            await Timer(1, "ps")
            driving = str(self.dut.drivers.value).count("1") + int(self.dut.host_drives.value)
            self.most = max(self.most, driving)
            assert driving <= 1, "two drivers at a time"

    async def _receive(self) -> None:
        while True:
            await FallingEdge(self.dut.pair)
            if int(self.dut.host_drives.value):
                continue
            await Timer(BIT_NS // 2, "ns")
            byte = 0
            for index in range(8):
                await Timer(BIT_NS, "ns")
                byte |= int(self.dut.pair.value) << index
            cocotb.start_soon(self._hand_on(byte))

    async def _hand_on(self, byte: int) -> None:
        """Deliver a byte after its stop bit, with the delay of an adapter and a program."""
        await Timer(2 * BIT_NS, "ns")
        self.received.append(byte)

    async def _send(self, data: bytes) -> None:
        self.dut.host_drives.value = 1
        for byte in data:
            for bit in (0, *(byte >> index & 1 for index in range(8)), 1):
                self.dut.host.value = bit
                await Timer(BIT_NS, "ns")
        self.dut.host_drives.value = 0

    async def until(self, done: Any) -> None:
        """Let the links take turns until a condition is true."""
        patience = clock() + 0.02
        while clock() < patience:
            for link in self.links:
                data = link.step()
                if data:
                    await self._send(data)
            if done():
                return
            await Timer(BIT_NS, "ns")
            if self.received.endswith(b"\n"):
                data, self.received = bytes(self.received), bytearray()
                for link in self.links:
                    if link.seat.has_turn:
                        link.events += link.session.receive(data, clock())
                        break
        raise AssertionError("the condition did not become true")


@cocotb.test
async def four_nodes_take_turns_on_one_pair_of_wires(dut: Any) -> None:
    pair = Pair(dut)
    await pair.begin()
    links = pair.links
    await pair.until(lambda: all(link.session.is_open for link in links))
    assert [link.session.codec.framing.prefix for link in links] == [b"Z01", b"Z02", b"Z05", b"ZFE"]

    asked = [link.ask("W", b"10%08X" % (100 + place), 0) for place, link in enumerate(links)]
    asked += [link.ask("WM", b"10%08X%08X" % (place, 7), 0) for place, link in enumerate(links)]
    reads = [link.ask("RM", b"1002", 16) for link in links]
    await pair.until(lambda: all(request.done for request in (*asked, *reads)))
    assert [request.error for request in (*asked, *reads)] == [None] * 12
    assert [list(request.answer) for request in reads] == [[place, 7] for place in range(4)]

    # Each node runs a group, and one node is reset: the others do not notice.
    for link in links:
        codec = link.session.codec
        settings = codec.fields("GS", 0, 0, 1, 1, [0x10])[2:]
        group = link.session.groups.hold(settings, codec.head_sizes["GP"] + 12, link)
        link.events += link.session.start(group, clock())
    await pair.until(lambda: not any(link.session.window.in_flight or link.session.wants_turn for link in links))
    polls = [link.ask("GP", b"00", 0) for link in links]
    await pair.until(lambda: all(request.done for request in polls))
    samples: list[Sampled] = [event for link in links for event in link.events if type(event).__name__ == "Sampled"]
    assert [sample.body for sample in samples] == [b"P0000%08X" % place for place in range(4)]

    dut.rst.value = 0b0100
    await ClockCycles(dut.clk, 4)
    dut.rst.value = 0
    more = [link.ask("W", b"11%08X" % 9, 0) for link in links]
    await pair.until(lambda: all(request.done for request in more) and all(link.session.is_open for link in links))
    assert [request.error is None for request in more] == [True, False, True, True]
    assert [any(isinstance(event, Interrupted) for event in link.events) for link in links] == [
        False,
        True,
        False,
        False,
    ]
    assert pair.most == 1
