"""`rtl:` with a user's core: valid VHDL runs, warnings are logged, and a refusal names the user's file."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING

import pytest

import unity_link
from unity_link.errors import ConnectError
from unity_link.gateware.convert import ConversionError
from unity_link.spec import compile_file
from unity_link.virtual.build import simulate
from unity_link.virtual.rtl.making import make
from unity_link.virtual.rtl.specs import configuration_of

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.rtl
SPEC = "public one() { mix: MIX() @(0x10); }\n"
MAP = """\
/// A core of a user's.
MIX(): @(BASE) {
  ENTITY("mix");
  @given = BASE: signed 12 READWRITE();
  /// The upper part of a product.
  @scaled = BASE + 1: signed 12 READ();
  /// Each bit with all bits below it.
  @gray = BASE + 2: unsigned 12 READ();
}
"""
CORE = """\
library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity mix is
  generic (axes : positive := 1; clock_hz : positive := 50_000_000);
  port (
    clk, rst : in std_logic;
    given : in std_logic_vector(axes * 12 - 1 downto 0);
    given_written : in std_logic_vector(axes - 1 downto 0);
    scaled, gray : out std_logic_vector(axes * 12 - 1 downto 0)
  );
end entity;
architecture rtl of mix is
  signal product, shifted : signed(35 downto 0);
  signal bits : std_logic_vector(11 downto 0);
begin
  product <= signed(given(11 downto 0)) * to_signed(100 + 2 ** 24, 24);
  shifted <= shift_right(product, 3);
  bits(11) <= given(11);
  bits(10 downto 0) <= bits(11 downto 1) xor given(10 downto 0);
  process (clk) begin if rising_edge(clk) then
    scaled(11 downto 0) <= std_logic_vector(shifted(11 downto 0));
    gray(11 downto 0) <= bits;
  end if; end process;
end architecture;
"""


def written(folder: Path, core: str) -> Path:
    """Write a spec with the core; return its path."""
    (folder / "cores" / "mix").mkdir(parents=True)
    (folder / "cores" / "mix" / "mix.ul").write_text(MAP)
    (folder / "cores" / "mix" / "mix.vhd").write_text(core)
    (folder / "one.ul").write_text(SPEC)
    return folder / "one.ul"


def made(spec: Path, *, unchecked: bool = False) -> tuple[bytes, tuple[str, ...]]:
    """Return the C++ of a spec, and the warnings about its cores."""
    configuration = configuration_of(compile_file(spec).interface(), {}, None, unchecked=unchecked)
    return make(configuration.name, json.loads(configuration.generics), configuration.design)


@pytest.mark.slow
@pytest.mark.asyncio
async def test_a_core_with_a_multiplication_and_a_chain_of_bits_runs(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The warnings are part of a build, and a cached design is not built again.
    monkeypatch.setattr("unity_link.virtual.rtl.specs.cache_folder", lambda: tmp_path / "cache")
    spec = written(tmp_path, CORE)
    one = unity_link.load(spec)
    async with unity_link.connect(simulate(spec, rtl=True)) as link:
        mix = one(link).mix
        for given in (0, 1, -1, 100, -777, 2047, -2048):
            await mix.given.set(given)
            assert await mix.scaled.get() == (given * 100 // 8 + 2048) % 4096 - 2048
            bits = gray = given & 0xFFF
            while bits := bits >> 1:
                gray ^= bits
            assert await mix.gray.get() == gray
    warnings = [record.getMessage() for record in caplog.records if "truncated" in record.getMessage()]
    assert len(warnings) == 1
    assert re.match(r".*cores/mix/mix\.vhd:15:43: .*vector truncated", warnings[0])


def test_a_wrong_conversion_is_refused_with_the_users_file(tmp_path: Path) -> None:
    spec = written(tmp_path, CORE.replace("shift_right(product, 3)", "product mod 8"))
    with pytest.raises(ConversionError, match=r"^\S+cores/mix/mix\.vhd:16:22: GHDL makes another circuit of mod of"):
        made(spec)


@pytest.mark.slow
def test_a_core_is_compared_with_its_simulation_unless_disabled(tmp_path: Path) -> None:
    spec = written(
        tmp_path, CORE.replace("shift_right(product, 3)", "product when signed(given(3 downto 0)) > 9 else -product")
    )
    with pytest.raises(
        ConversionError, match=r"^\S+cores/mix/mix\.vhd: GHDL makes another circuit of the entity mix: "
    ):
        made(spec)
    text, remarks = made(spec, unchecked=True)
    assert b"#define UL_FEEDBACK" in text
    assert len(remarks) == 1
    interface = compile_file(spec).interface()
    paths = {configuration_of(interface, {}, None, unchecked=unchecked) for unchecked in (False, True)}
    assert len(paths) == 2


def test_falling_edges_are_refused_with_the_name_of_the_users_file(tmp_path: Path) -> None:
    spec = written(tmp_path, CORE.replace("rising_edge", "falling_edge"))
    with pytest.raises(
        ConversionError, match=r"^\S+mix\.vhd: a register uses falling edges of a clock, and rtl: supports"
    ):
        made(spec)
    (tmp_path / "cores" / "mix" / "mix.vhd").write_text(CORE.replace("given(11)", "giver(11)"))
    with pytest.raises(ConnectError) as raised:
        simulate(spec, rtl=True)
    reason = r'cannot be built: \S+cores/mix/mix\.vhd:17:15: no declaration for "giver"$'
    assert re.search(reason, str(raised.value))
