"""SystemRDL out and in again, and SystemRDL of others in."""

import re
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import HealthCheck, given, settings

from support.searching import examples
from support.spec_examples import interface_of, specs
from unity_link.errors import UnsupportedError
from unity_link.spec import Interface, SpecError, compile_file, compile_text
from unity_link.spec.printer import print_file
from unity_link.spec.syntax import File
from unity_link.spec.systemrdl import export_text, import_file

EXAMPLES = Path(__file__).parents[2] / "examples"

FOREIGN = """
enum mode_e { off = 0 { desc = "Not at all."; }; on = 1; };
reg ctrl_t {
  desc = "Control.";
  field { sw = rw; hw = r; encode = mode_e; } mode[1:0] = 0;
  field { sw = r; hw = w; onread = rclr; } busy[7:7];
};
regfile channel {
  ctrl_t ctrl;
  reg { field { sw = r; hw = w; desc = "The value."; } v[31:0]; } value;
  reg { field { sw = w; hw = r; } d[15:0]; } data[4];
};
addrmap chip {
  desc = "A chip.";
  default regwidth = 32;
  ctrl_t main @ 0x0;
  channel ch[3] @ 0x100 += 0x40;
  external mem { mementries = 16; memwidth = 32; } ram @ 0x400;
};
"""


def seen(interface: Interface) -> dict[int, list[Any]]:
    """Return what must survive: everything of a signal but the names of its components and where it was written."""
    words: dict[int, list[Any]] = {}
    for signal in interface.signals.values():
        kind = signal.kind
        encoded = None if kind.enumeration is None else [(one.name, one.value) for one in kind.enumeration.values]
        words.setdefault(signal.address, []).append((
            signal.lowest_bit, signal.name, kind.name, kind.width, kind.fraction, kind.scale, kind.offset, encoded,
            signal.access, signal.fifo, signal.fifo_words, signal.unit, signal.minimum, signal.maximum, signal.group,
            signal.groups, signal.poll_hz, signal.doc, signal.is_field,
            signal.id if signal.id != signal.path else None,
        ))  # fmt: skip
    return {address: sorted(signals, key=repr) for address, signals in words.items()}


def returned(interface: Interface, folder: Path) -> Interface:
    """Export an interface and import it again."""
    path = folder / "out.rdl"
    path.write_text(export_text(interface), encoding="utf-8")
    return compile_text(import_file(path)).interface()


@pytest.mark.parametrize("name", ["scara", "walker"])
def test_an_example_comes_back_whole(name: str, tmp_path: Path) -> None:
    interface = compile_file(EXAMPLES / f"{name}.ul").interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert [(one.name, one.number, one.divisor, one.timestamps, len(one.joints)) for one in back.groups] == [
        (one.name, one.number, one.divisor, one.timestamps, len(one.joints)) for one in interface.groups
    ]


def test_the_tree_comes_back_and_arrays_as_single_components(tmp_path: Path) -> None:
    walker = compile_file(EXAMPLES / "walker.ul").interface()
    assert "legs_3.femur.pos_sp" in returned(walker, tmp_path).signals


def test_everything_that_systemrdl_has_no_word_for_comes_back(tmp_path: Path) -> None:
    interface = interface_of(
        '@a = 1[3:0]: mode READWRITE(ID="a \\"quoted\\" \\\\ path\\\\", UNIT="\N{DEGREE SIGN}C");',
        "@b = 1[15:8]: signed READWRITE(SCALE=0.1, OFFSET=-3, MIN=-1, MAX=1.5);",
        "@c = 2: unsigned 64 READ(PUBLISH(g), GROUP(h));",
        "@d = 4: READ(FIFO(16), POLL(2.5));",
        "@e = 4: WRITE(FIFO);",
        "@f = 5: ufixed 4.12 READ(PUBLISH(3, 7));",
        '/// A line.\n/// Another "one"; two \\\\ at \\ the end \\\\\n@g = 6: float 16 WRITE();',
        outside="enum mode { off, on = 3 }\ngroup g(RATE=100.5, TRIGGER, ON_CHANGE);\ngroup h;",
    )  # fmt: skip
    assert seen(returned(interface, tmp_path)) == seen(interface)


def test_an_enumeration_wider_than_a_word_comes_back(tmp_path: Path) -> None:
    interface = compile_text("""
enum mode { off, /// Quick.
  high = 70000 }
enum small { none, some = 3 }
public e() {
  GATEWAY(DATA_BITS=16);
  @mode = 0: mode 32 READ();
  @again = 2: mode 17 READWRITE();
  @narrow = 4: small 2 READ();
  @wide = 5: small 64 READ();
}
""").interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert back.fingerprint == interface.fingerprint


def test_the_width_of_addresses_comes_back(tmp_path: Path) -> None:
    interface = compile_text("public x() { GATEWAY(ADDRESS_BITS=12); @a = 1: READ(); }").interface()
    assert returned(interface, tmp_path).address_bits == 12


def in_groups(interface: Interface) -> list[tuple[str, ...]]:
    """Return the names of all groups, their doc strings and their signals in order, arrays as single components."""
    flat = re.compile(r"\[(\d+)\]")
    return [(one.name, one.doc, *(flat.sub(r"_\1", path) for path in one.signals)) for one in interface.groups]


def test_the_order_of_signals_in_groups_comes_back(tmp_path: Path) -> None:
    interface = compile_text("""
/// All that moves.
///
/// In its own order.
group state(1, 10);
group few(2, 10);
public robot() {
  @last = 19: READ(PUBLISH(state));
  legs[2]: leg() @(14 - 5 * i);
  @middle = 3: READ(PUBLISH(state));
  @alone = 20: READ();
  hip: joint() @(1);
  @first = 0: READ(PUBLISH(few), GROUP(state));
}
leg(): @(base) { knee: joint() @(base - 1); @angle = base - 2: READ(PUBLISH(state)); }
joint(): @(base) { @vel = base + 1: READ(PUBLISH(few)); @pos = base: READ(PUBLISH(state)); }
""").interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert in_groups(back) == in_groups(interface)


def test_a_queue_of_values_narrower_than_a_word_comes_back(tmp_path: Path) -> None:
    interface = interface_of("@a = 1: bool READWRITE(FIFO);", "@b = 2: signed 12 READ(FIFO(4));")
    assert seen(returned(interface, tmp_path)) == seen(interface)


def test_signals_parts_and_values_may_have_names_of_kinds(tmp_path: Path) -> None:
    interface = interface_of(
        "@signed = 1: signed READ();", "@float = 2: on READ();", "bool: fixed() @(3);",
        outside="enum on { unsigned, bool }\nfixed(): @(base) { @ufixed = base: READ(); }",
    )  # fmt: skip
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert list(back.signals) == list(interface.signals)


def test_parts_may_have_names_of_groups_enumerations_and_modules(tmp_path: Path) -> None:
    interface = interface_of(
        "state: part() @(1);", "PWM: part() @(2);", "mode: part() @(3);", "@a = 4: mode READ(GROUP(state));",
        outside="enum mode { off }\ngroup state;\npart(): @(base) { @b = base: READ(GROUP(state)); }",
    )  # fmt: skip
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert in_groups(back) == in_groups(interface)


def test_an_interface_without_signals_is_refused() -> None:
    with pytest.raises(UnsupportedError, match="SystemRDL knows no map without registers, and robot has no signals"):
        export_text(interface_of())


@settings(max_examples=examples(15), suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(specs())
def test_any_valid_spec_comes_back(tmp_path: Path, file: File) -> None:
    interface = compile_text(print_file(file)).interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert in_groups(back) == in_groups(interface)


def test_foreign_systemrdl_keeps_its_tree(tmp_path: Path) -> None:
    path = tmp_path / "chip.rdl"
    path.write_text(FOREIGN)
    chip = compile_text(import_file(path)).interface()
    assert (chip.name, chip.doc, chip.data_bits) == ("chip", "A chip.", 32)
    assert chip.signals["main.mode"].address == 0
    assert chip.signals["main.mode"].kind.enumeration is not None
    assert chip.signals["main.busy"].doc == "Reading it has an effect: rclr."
    assert chip.signals["ch[2].value"].address == (0x100 + 2 * 0x40 + 4) // 4
    assert chip.signals["ch[1].data[3].d"].address == (0x100 + 0x40 + 8 + 12) // 4
    assert chip.signals["ch[1].data[3].d"].access == "WRITE"
    assert [(one.name, one.base, one.words) for one in chip.modules] == [("ram", 0x100, 16)]
    assert "Control." in import_file(path)


def test_a_map_is_chosen_by_its_name(tmp_path: Path) -> None:
    path = tmp_path / "two.rdl"
    path.write_text("".join(f"addrmap {name} {{ reg {{ field {{}} f[31:0]; }} only; }};" for name in ("one", "two")))
    assert "public one()" in import_file(path, "one")
    assert "public two()" in import_file(path)
    with pytest.raises(SpecError):
        import_file(path, "three")


def test_what_is_no_systemrdl_is_refused_with_its_place(tmp_path: Path) -> None:
    path = tmp_path / "bad.rdl"
    path.write_text("addrmap top {\n  reg { field {} a; } b\n};\n")
    with pytest.raises(SpecError) as caught:
        import_file(path)
    first = caught.value.diagnostics[0]
    assert (first.span.file, first.code) == (str(path), "systemrdl")
    assert "Parse aborted" not in str(caught.value)
    with pytest.raises(SpecError):
        import_file(tmp_path / "nothing.rdl")


def test_what_is_nested_too_deeply_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "deep.rdl"
    path.write_text(f"addrmap top {{ reg {{ field {{}} a[8] = {'(' * 5000}0{')' * 5000}; }} one; }};")
    with pytest.raises(SpecError, match="it is nested too deeply"):
        import_file(path)


def test_perl_is_refused_with_its_line_unless_it_is_asked_for(tmp_path: Path) -> None:
    path = tmp_path / "perl.rdl"
    path.write_text("addrmap top { // <% no Perl %>\n  <% my $n = 3; %>reg { field {} a[8] = <%=$n%>; } one;\n};\n")
    with pytest.raises(SpecError, match=r"run only by `import rdl --perl`") as caught:
        import_file(path)
    (found,) = caught.value.diagnostics
    assert (str(found.span), found.text) == (f"{path}:2:3", path.read_text().splitlines()[1])
    assert "public top()" in import_file(path, perl=True)


def test_perl_of_a_file_that_is_included_is_refused_with_its_line(tmp_path: Path) -> None:
    path, inner = tmp_path / "outer.rdl", tmp_path / "inner.rdl"
    inner.write_text("\n\n <%=1%>")
    path.write_text('`include "inner.rdl"\naddrmap top { reg { field {} a[8] = 0; } one; };\n')
    with pytest.raises(SpecError) as caught:
        import_file(path)
    assert str(caught.value.diagnostics[0].span) == f"{inner}:3:2"


def test_perl_in_systemrdl_opens_and_starts_nothing(tmp_path: Path) -> None:
    path, started = tmp_path / "perl.rdl", tmp_path / "started"
    for text in (f"system('touch {started}')", f"open(my $f, '>', '{started}')"):
        path.write_text(f"<% {text}; %>addrmap top {{ reg {{ field {{}} a[8] = 0; }} one; }};")
        with pytest.raises(SpecError, match="trapped by operation mask"):
            import_file(path, perl=True)
    assert not started.exists()


def test_widths_that_systemrdl_does_not_know_are_refused() -> None:
    with pytest.raises(UnsupportedError, match="registers of 8, 16, 32 or 64 bits, and robot has 24"):
        export_text(interface_of("@a = 1: READ();", data_bits=24))


def test_registers_that_no_word_address_has_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "odd.rdl"
    path.write_text(
        "addrmap top { reg { regwidth = 8; field {} f[7:0]; } a @ 0x1;"
        " reg { regwidth = 32; field {} f[31:0]; } b @ 0x4; };"
    )
    assert compile_text(import_file(path)).interface().data_bits == 8
    path.write_text("addrmap top { default alignment = 1; reg { regwidth = 32; field {} f[31:0]; } a @ 0x2; };")
    with pytest.raises((UnsupportedError, SpecError)):
        import_file(path)


@given(st.text(max_size=20))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(20))
def test_garbage_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "garbage.rdl"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(SpecError):
        import_file(path)
