"""SystemRDL that is exported and imported again, and SystemRDL of other tools."""

import re
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import pytest
from hypothesis import HealthCheck, given, settings

from support.searching import examples
from support.spec_examples import interface_of, specs
from unity_link.errors import UnsupportedError
from unity_link.spec import Effect, Interface, SpecError, compile_file, compile_text
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
    """Return everything of the signals that must survive, except the names of components and source positions."""
    words: dict[int, list[Any]] = {}
    for signal in interface.signals.values():
        kind, name = signal.kind, signal.label.replace("[", "_").rstrip("]")
        encoded = None if kind.enumeration is None else [(one.name, one.value) for one in kind.enumeration.values]
        words.setdefault(signal.address, []).append((
            signal.lowest_bit, name, kind.name, kind.width, kind.fraction, kind.scale, kind.offset, encoded,
            signal.access, signal.fifo, signal.fifo_words, signal.unit, signal.minimum, signal.maximum, signal.group,
            signal.groups, signal.poll_hz, signal.doc, signal.is_field, signal.effect, signal.reset,
            signal.id if signal.id != signal.path else None,
        ))  # fmt: skip
    return {address: sorted(signals, key=repr) for address, signals in words.items()}


def returned(interface: Interface, folder: Path) -> Interface:
    """Export an interface and import it again."""
    path = folder / "out.rdl"
    path.write_text(export_text(interface), encoding="utf-8")
    return compile_text(import_file(path).text).interface()


@pytest.mark.parametrize("name", ["scara", "walker"])
def test_an_exported_example_is_imported_completely(name: str, tmp_path: Path) -> None:
    interface = compile_file(EXAMPLES / f"{name}.ul").interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert [(one.name, one.number, one.divisor, one.timestamps, len(one.joints)) for one in back.groups] == [
        (one.name, one.number, one.divisor, one.timestamps, len(one.joints)) for one in interface.groups
    ]


def test_the_tree_is_imported_with_arrays_as_single_components(tmp_path: Path) -> None:
    walker = compile_file(EXAMPLES / "walker.ul").interface()
    assert "legs_3.femur.pos_sp" in returned(walker, tmp_path).signals


def test_properties_that_systemrdl_lacks_are_imported_again(tmp_path: Path) -> None:
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


def test_an_enumeration_wider_than_a_word_is_imported_again(tmp_path: Path) -> None:
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


def test_the_width_of_addresses_is_imported_again(tmp_path: Path) -> None:
    interface = compile_text("public x() { GATEWAY(ADDRESS_BITS=12); @a = 1: READ(); }").interface()
    assert returned(interface, tmp_path).address_bits == 12


def in_groups(interface: Interface) -> list[tuple[str, ...]]:
    """Return names, doc strings and ordered signals of all groups; elements of arrays count as single components."""
    flat = re.compile(r"\[(\d+)\]")
    return [(one.name, one.doc, *(flat.sub(r"_\1", path) for path in one.signals)) for one in interface.groups]


def test_the_order_of_signals_in_groups_is_imported_again(tmp_path: Path) -> None:
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


def test_a_queue_of_values_narrower_than_a_word_is_imported_again(tmp_path: Path) -> None:
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
        "state: part() @(1);", "MEMORY: part() @(2);", "mode: part() @(3);", "@a = 4: mode READ(GROUP(state));",
        outside="enum mode { off }\ngroup state;\npart(): @(base) { @b = base: READ(GROUP(state)); }",
    )  # fmt: skip
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert in_groups(back) == in_groups(interface)


def test_an_interface_without_signals_is_refused() -> None:
    with pytest.raises(UnsupportedError, match="SystemRDL knows no map without registers and memories"):
        export_text(interface_of())


@pytest.mark.slow
@settings(max_examples=examples(15), suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
@given(specs())
def test_any_valid_spec_is_imported_as_it_was_exported(tmp_path: Path, file: File) -> None:
    interface = compile_text(print_file(file)).interface()
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert in_groups(back) == in_groups(interface)


def test_foreign_systemrdl_keeps_its_tree(tmp_path: Path) -> None:
    path = tmp_path / "chip.rdl"
    path.write_text(FOREIGN)
    chip = compile_text(import_file(path).text).interface()
    assert (chip.name, chip.doc, chip.data_bits) == ("chip", "A chip.", 32)
    assert chip.signals["main.mode"].address == 0
    assert chip.signals["main.mode"].kind.enumeration is not None
    assert chip.signals["main.busy"].doc == "Reading it has an effect: rclr."
    assert chip.signals["ch[2].value"].address == (0x100 + 2 * 0x40 + 4) // 4
    assert chip.signals["ch[1].data[3].d"].address == (0x100 + 0x40 + 8 + 12) // 4
    assert chip.signals["ch[1].data[3].d"].access == "WRITE"
    assert [(one.name, one.base, one.words) for one in chip.modules] == [("ram", 0x100, 16)]
    assert "Control." in import_file(path).text


def test_a_map_is_chosen_by_its_name(tmp_path: Path) -> None:
    path = tmp_path / "two.rdl"
    path.write_text("".join(f"addrmap {name} {{ reg {{ field {{}} f[31:0]; }} only; }};" for name in ("one", "two")))
    assert "public one()" in import_file(path, top="one").text
    assert "public two()" in import_file(path).text
    with pytest.raises(SpecError):
        import_file(path, top="three")


def test_invalid_systemrdl_is_refused_with_its_position(tmp_path: Path) -> None:
    path = tmp_path / "bad.rdl"
    path.write_text("addrmap top {\n  reg { field {} a; } b\n};\n")
    with pytest.raises(SpecError) as caught:
        import_file(path)
    first = caught.value.diagnostics[0]
    assert (first.span.file, first.code) == (str(path), "systemrdl")
    assert "Parse aborted" not in str(caught.value)
    with pytest.raises(SpecError):
        import_file(tmp_path / "nothing.rdl")


@pytest.mark.slow
def test_systemrdl_that_is_nested_too_deeply_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "deep.rdl"
    path.write_text(f"addrmap top {{ reg {{ field {{}} a[8] = {'(' * 5000}0{')' * 5000}; }} one; }};")
    with pytest.raises(SpecError, match="it is nested too deeply"):
        import_file(path)


def test_perl_is_refused_with_its_line_unless_it_is_enabled(tmp_path: Path) -> None:
    path = tmp_path / "perl.rdl"
    path.write_text("addrmap top { // <% no Perl %>\n  <% my $n = 3; %>reg { field {} a[8] = <%=$n%>; } one;\n};\n")
    with pytest.raises(SpecError, match=r"run only by `import rdl --perl`") as caught:
        import_file(path)
    (found,) = caught.value.diagnostics
    assert (str(found.span), found.text) == (f"{path}:2:3", path.read_text().splitlines()[1])
    assert "public top()" in import_file(path, perl=True).text


def test_perl_of_an_included_file_is_refused_with_its_line(tmp_path: Path) -> None:
    path, inner = tmp_path / "outer.rdl", tmp_path / "inner.rdl"
    inner.write_text("\n\n <%=1%>")
    path.write_text('`include "inner.rdl"\naddrmap top { reg { field {} a[8] = 0; } one; };\n')
    with pytest.raises(SpecError) as caught:
        import_file(path)
    assert str(caught.value.diagnostics[0].span) == f"{inner}:3:2"


def test_perl_in_systemrdl_opens_no_file_and_starts_no_process(tmp_path: Path) -> None:
    path, started = tmp_path / "perl.rdl", tmp_path / "started"
    for text in (f"system('touch {started}')", f"open(my $f, '>', '{started}')"):
        path.write_text(f"<% {text}; %>addrmap top {{ reg {{ field {{}} a[8] = 0; }} one; }};")
        with pytest.raises(SpecError, match="trapped by operation mask"):
            import_file(path, perl=True)
    assert not started.exists()


def test_widths_that_systemrdl_does_not_have_are_refused() -> None:
    with pytest.raises(UnsupportedError, match="registers of 8, 16, 32 or 64 bits, and robot has 24"):
        export_text(interface_of("@a = 1: READ();", data_bits=24))


def test_registers_without_a_word_address_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "odd.rdl"
    path.write_text(
        "addrmap top { reg { regwidth = 8; field {} f[7:0]; } a @ 0x1;"
        " reg { regwidth = 32; field {} f[31:0]; } b @ 0x4; };"
    )
    assert compile_text(import_file(path).text).interface().data_bits == 8
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


# Features that a spec does not have, or expresses in another way


def imported(tmp_path: Path, text: str, **options: Any) -> tuple[Interface, str]:
    """Import a text; return the interface and the warnings."""
    path = tmp_path / "given.rdl"
    path.write_text(text)
    found = import_file(path, **options)
    return compile_text(found.text).interface(), "\n".join(one.render() for one in found.warnings)


def refusal(tmp_path: Path, text: str) -> str:
    """Return the refusal of a text; assert that each of its faults quotes a line of the text."""
    path = tmp_path / "given.rdl"
    path.write_text(text)
    with pytest.raises(SpecError) as caught:
        import_file(path)
    assert all(one.span.file == str(path) and one.text in text.splitlines() for one in caught.value.diagnostics)
    return str(caught.value)


REFUSED = {
    "msb0": ("msb0; reg { field {} gain[0:7]; } ctrl;", "chip.ctrl: its fields count bits from the most significant"),
    "msb0 by the order of bits": ("reg { field {} gain[0:7]; } ctrl;", "(msb0): write them as [high:low]"),
    "bigendian": (
        "bigendian; reg { regwidth = 64; accesswidth = 32; field {} t[63:0]; } t; reg { field {} f[31:0]; } o;",
        "chip.t: its 64 bits are several words of 32, the highest first (bigendian)",
    ),
    "a register of 128 bits": ("reg { regwidth = 128; field {} f[31:0]; } key;", "accessed 128 bits at a time"),
    "a field of 96 bits": (
        "reg { regwidth = 128; accesswidth = 32; field {} f[95:0]; } key;", "it has 96 bits, and a signal has at",
    ),
    "several widths": (
        "reg { regwidth = 8; field {} f[7:0]; } a; reg { regwidth = 32; field {} f[11:4]; } b;",
        "chip.b.f: it goes over the end of a word of 8 bits",
    ),
    "a place between words": (
        "reg { field {} f[31:0]; } a; external mem { mementries = 3; memwidth = 8; } n @ 0x21;",
        "chip.n: byte 0x21 is not at the beginning of a word of 32 bits",
    ),
    "a bridge": (
        "bridge; addrmap { reg { field {} f[31:0]; } q; } a @ 0; addrmap { reg { field {} f[31:0]; } q; } b @ 0;",
        "the maps of a bridge lie over each other",
    ),
    "widths of a fixed-point number": (
        "reg { field { intwidth = 4; fracwidth = 5; } f[7:0]; } q;", "intwidth=4 and fracwidth=5 are not the",
    ),
    "a signed enumeration": (
        "reg { enum e { a = 0; }; field { is_signed; encode = e; } f[7:0]; } q;", "an enumeration is neither signed",
    ),
    "a place beyond all addresses": ("reg { field {} f[31:0]; } q @ 0x800000000;", "a gateway has at most 0x100000000"),
    "a large array": ("reg { field {} f[31:0]; } q[70000];", "an array of 70000 was found"),
    "what check refuses": (
        "reg { field { sw = w; } a[7:0]; field { sw = r; hw = w; } b[7:0]; field { sw = rw; } c[8:8]; } q;",
        "q.a is one of several fields written at address 0x0",
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", REFUSED)
def test_features_that_a_spec_does_not_have_are_refused_with_their_line(what: str, tmp_path: Path) -> None:
    body, expected = REFUSED[what]
    said = refusal(tmp_path, f"addrmap chip {{\n  {body}\n}};\n")
    assert expected in said
    assert "given.rdl:2:" in said or what == "a bridge" or "at most 0x1" in said


def test_all_refused_features_are_reported_at_once(tmp_path: Path) -> None:
    said = refusal(tmp_path, "addrmap chip {\n reg { field {} a[0:7]; } x;\n reg { field {} b[0:7]; } y;\n};\n")
    assert "chip.x: " in said
    assert "chip.y: " in said


def test_big_endian_registers_of_one_word_are_imported_as_others(tmp_path: Path) -> None:
    chip, _ = imported(tmp_path, "addrmap chip { bigendian; reg { field {} f[15:8]; } q @ 4; };")
    assert (chip.signals["q"].address, chip.signals["q"].lowest_bit) == (1, 8)


def test_wide_registers_that_are_accessed_in_words_are_imported(tmp_path: Path) -> None:
    text = "reg { regwidth = 128; accesswidth = 32; field {} low[31:0]; field {} high[127:64]; } key;"
    chip, _ = imported(tmp_path, f"addrmap chip {{ {text} }};")
    assert chip.data_bits == 32
    assert (chip.signals["key.high"].address, chip.signals["key.high"].width) == (2, 64)


def test_registers_of_several_widths_are_imported_if_no_field_is_cut(tmp_path: Path) -> None:
    text = "reg { regwidth = 8; field {} f[7:0]; } a; reg {\nregwidth = 32; field {} f[31:0]; } b @ 4;"
    chip, said = imported(tmp_path, f"addrmap chip {{ {text} }};")
    assert [(one.path, one.address, one.width) for one in chip.signals.values()] == [("a", 0, 8), ("b", 4, 32)]
    assert "given.rdl:2:" in said
    assert "chip.b: its accesswidth is 32, and it is read and written in words of 8 bits" in said


def test_names_that_differ_in_case_or_are_keywords_are_changed_and_reported(tmp_path: Path) -> None:
    words = ["GPIO", "PWM", "FIFO", "COUNTER", "MEMORY", "GATEWAY", "bridge_", "import", "group", "public", "pi", "i"]
    words += ["READ", "base", "signed_", "PUBLISH", "TOSNET", "QUADRATURE", "float", "fixed"]
    parts = "".join(f"regfile {one} {{ reg {{ field {{}} {one}[7:0]; }} {one}[2]; }}; {one} {one};\n" for one in words)
    chip, said = imported(
        tmp_path,
        f"""
enum PWM_e {{ MRO = 0; mro = 1; _x = 2; X = 3; x = 4; }};
enum import_e {{ import = 0; public = 1; }};
addrmap public {{
  {parts}
  reg {{ field {{}} A[7:0]; field {{}} a[15:8]; field {{}} a_2[23:16]; }} R;
  reg {{ field {{ encode = PWM_e; }} f[7:0]; field {{ encode = import_e; }} g[15:8]; }} q;
}};
""",
    )
    assert [chip.signals[path].lowest_bit for path in ("R.A", "R.a_2", "R.a_2_2")] == [0, 8, 16]
    assert "R.a is called a_2" in said
    assert "public.import is called import_" in said
    assert chip.signals["import_.import_[1].import_"].address == 2 * words.index("import") + 1
    assert "q.f" in chip.signals


def test_an_unused_name_causes_no_warning(tmp_path: Path) -> None:
    chip, said = imported(
        tmp_path,
        """addrmap chip {
  reg { field { sw = rw; } import[8]; } alone;
  reg { field { sw = rw; } import[8]; } several[2];
  reg { field { sw = rw; } import[8]; field { sw = rw; } other[8]; } both;
};""",
    )
    assert list(chip.signals) == [
        "alone", "several[0].import_", "several[1].import_", "both.import_", "both.other"
    ]  # fmt: skip
    assert [line.split(":")[-2].strip() for line in said.splitlines() if " is called " in line] == [
        "chip.several.import is called import_", "chip.both.import is called import_"
    ]  # fmt: skip


def test_properties_of_peakrdl_need_no_declaration(tmp_path: Path) -> None:
    fields = """
      reg { field { is_signed; } f[15:0]; } a; reg { field { intwidth = 8; fracwidth = 8; } f[15:0]; } b;
      reg { field { intwidth = 4; is_signed; } f[11:0]; } c; reg { field { fracwidth = 12; } f[7:0]; } d;
      reg { field { intwidth = 10; is_signed; } f[7:0]; } e; reg { field { is_signed = false; } f[7:0]; } g;
    """
    declared = "".join(
        f"property {name} {{ component = field; type = {kind}; }};"
        for name, kind in (
            ("is_signed", "boolean"),
            ("intwidth", "longint unsigned"),
            ("fracwidth", "longint unsigned"),
        )
    )
    expected = [
        ("a", "signed 16", 1), ("b", "ufixed 8.8", 1), ("c", "fixed 4.8", 1), ("d", "unsigned 8", 2**-12),
        ("e", "signed 8", 4), ("g", "unsigned 8", 1),
    ]  # fmt: skip
    for text in (fields, fields.replace("is_signed;", "is_signed = true;")):
        before = declared if "= true" in text else ""
        chip, _ = imported(tmp_path, f"{before} addrmap chip {{ {text} }};")
        assert [(one.path, str(one.kind), one.kind.scale) for one in chip.signals.values()] == expected


READING = ("rclr", "rset", "onread = ruser")
WRITING = ("woset", "woclr", *(f"onwrite = {one}" for one in ("wclr", "wset", "wot", "wzs", "wzc", "wzt", "wuser")))
OTHERS = ("sw = rw1", "sw = w1", "swacc", "swmod", "sw = w")


@pytest.mark.parametrize("effect", [*READING, *WRITING, *OTHERS])
def test_an_unsupported_side_effect_causes_a_warning_with_its_line(effect: str, tmp_path: Path) -> None:
    fields = f"field {{ hw = na; {effect}; }} flag[0:0] = 0;\nfield {{}} other[1:1];"
    text = f"addrmap chip {{ external reg {{\n{fields}\n}} q; }};"
    _, said = imported(tmp_path, text)
    assert "given.rdl:2:" in said
    assert effect.rsplit(maxsplit=1)[-1] in said
    assert "a write of other writes back" in said or effect not in WRITING
    assert "given.rdl:3:" not in said


EFFECTS = {
    "sw = r; rclr": ("READ", Effect.CLEAR_ON_READ),
    "sw = rw; woclr": ("READWRITE", Effect.WRITE_1_TO_CLEAR),
    "sw = w; singlepulse": ("WRITE", Effect.PULSE),
    "sw = rw; singlepulse": ("READWRITE", Effect.PULSE),
}


@pytest.mark.parametrize("properties", EFFECTS)
def test_effects_of_specs_are_imported_and_exported_as_systemrdl_properties(properties: str, tmp_path: Path) -> None:
    chip, said = imported(tmp_path, f"addrmap chip {{ reg {{ field {{ {properties}; }} flag[3:3] = 0; }} q; }};")
    (flag,) = chip.signals.values()
    assert (said, flag.access, flag.effect, flag.doc) == ("", *EFFECTS[properties], "")
    word = properties.rpartition(" ")[2]
    written = re.sub(r"\s+ul_\w+ = [^;]*;", "", export_text(chip))
    assert word in re.findall(r"\w+", written)
    # A tool without our properties reads the same effects.
    back, _ = imported(tmp_path, re.sub(r"property ul_[^\n]*\n", "", written))
    assert (back.signals["q"].access, back.signals["q"].effect) == (flag.access, flag.effect)


def test_fields_that_only_written_ones_change_may_share_a_register(tmp_path: Path) -> None:
    fields = "field { woclr; } a[0:0] = 1; field { woclr; } b[7:4] = 2; field { sw = w; singlepulse; } c[8:8] = 0;"
    chip, said = imported(tmp_path, f"addrmap chip {{ reg {{ {fields} }} q; }};")
    assert said == ""
    assert [(one.effect, one.reset, one.is_field) for one in chip.signals.values()] == [
        (Effect.WRITE_1_TO_CLEAR, 1, False),
        (Effect.WRITE_1_TO_CLEAR, 2, False),
        (Effect.PULSE, 0, False),
    ]


def test_a_register_cleared_by_reads_is_one_signal_that_documents_its_fields(tmp_path: Path) -> None:
    fields = """field { sw = r; rclr; desc = "Too many."; } over[3:3]; field { sw = r; rclr; } codes[11:8];"""
    text = f"""reg events {{ desc = "What has happened."; {fields} }};
addrmap chip {{ events one; events many[2] @ 0x10; reg {{ field {{ sw = r; }} f[31:0]; }} last; }};"""
    chip, said = imported(tmp_path, text)
    signals = sorted(chip.signals.values(), key=lambda one: one.address)
    assert [(one.path, one.address, one.lowest_bit, one.width, one.effect) for one in signals] == [
        ("one", 0, 3, 9, Effect.CLEAR_ON_READ),
        ("many[0].bits", 4, 3, 9, Effect.CLEAR_ON_READ),
        ("many[1].bits", 5, 3, 9, Effect.CLEAR_ON_READ),
        ("last", 6, 0, 32, None),
    ]
    assert chip.signals["one"].doc == "What has happened.\nbit 0: over. Too many.\nbits 8:5: codes."
    assert said.count("a read clears all of its fields, which are one signal of the spec") == 2


@pytest.mark.parametrize(
    ("fields", "word"),
    [
        ("field { sw = r; rclr; } a[0:0]; field { sw = r; } b[1:1];", "rclr"),
        ("field { sw = r; rclr; } a[0:0]; field { sw = w; } b[1:1];", "rclr"),
        ("field { sw = rw; rclr; } a[0:0];", "rclr"),
        ("field { sw = r; rclr; is_signed; } a[7:0];", "rclr"),
        ("field { woclr; } a[0:0]; field {} b[1:1];", "woclr"),
        ("field { sw = w; woclr; } a[0:0];", "woclr"),
        ("field { woclr; rclr; } a[0:0];", "woclr"),
        ("field { woclr; intwidth = 4; fracwidth = 4; } a[7:0];", "woclr"),
    ],
)
def test_an_effect_that_is_impossible_in_its_word_causes_a_warning(fields: str, word: str, tmp_path: Path) -> None:
    chip, said = imported(tmp_path, f"addrmap chip {{ external reg {{ default hw = na; {fields} }} q; }};")
    assert f"({word})" in said
    assert all(signal.effect is None for signal in chip.signals.values())


def test_plain_fields_cause_no_warning(tmp_path: Path) -> None:
    _, said = imported(tmp_path, "addrmap chip { reg { field {} a[7:0]; field { sw = r; hw = w; } b[8:8]; } q; };")
    assert said == ""


def test_memories_in_components_and_registers_in_memories_are_imported(tmp_path: Path) -> None:
    chip, _ = imported(
        tmp_path,
        """
mem table { mementries = 16; memwidth = 32; reg { field {} lo[15:0]; field {} hi[31:16]; } row[4]; };
addrmap bank { reg { field {} f[31:0]; } q; external table t @ 0x40; };
addrmap chip { bank banks[2] @ 0x100; external table many[2] @ 0x1000; };
""",
    )
    found = sorted((one.path, one.base, one.words) for one in chip.modules)
    assert found == [("banks[0].t", 0x50, 16), ("banks[1].t", 0x70, 16), ("many", 0x400, 32)]
    assert chip.signals["banks[1].t_entries.row[3].hi"].address == 0x73
    assert chip.signals["many_entries[1].row[2].lo"].address == 0x412


def test_memories_alone_are_exported_and_imported_again(tmp_path: Path) -> None:
    spec = """public store() {
  GATEWAY(ADDRESS_BITS=16, DATA_BITS=16);
  /// Samples.
  pool: MEMORY(BASE=0x100, SIZE=256);
  side: part();
}
part() { pool: MEMORY(BASE=0x200, SIZE=3); }"""
    interface = compile_text(spec).interface()
    back = returned(interface, tmp_path)
    assert [(one.path, one.base, one.words, one.doc) for one in back.modules] == [
        (one.path, one.base, one.words, one.doc) for one in interface.modules
    ]
    assert (back.address_bits, back.data_bits) == (16, 16)


def test_memories_are_imported_again_unless_they_contain_signals(tmp_path: Path) -> None:
    interface = interface_of(
        "@a = 1: READ();", "m: MEMORY(BASE=0x40, SIZE=8);", "MEMORY(BASE=0x20, SIZE=8) { @b = 1: READ(); }",
    )  # fmt: skip
    back = returned(interface, tmp_path)
    assert seen(back) == seen(interface)
    assert [(one.path, one.base, one.words) for one in back.modules] == [("m", 0x40, 8)]


def test_files_include_others_and_use_earlier_ones(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "reg.rdl").write_text("reg one { field {} f[31:0]; };")
    (tmp_path / "first.rdl").write_text("regfile two { reg { field {} f[31:0]; } q; };")
    top = tmp_path / "top.rdl"
    top.write_text('`include "reg.rdl"\naddrmap chip { one a; two b; };')
    text = import_file(tmp_path / "first.rdl", top, include=[tmp_path / "parts"]).text
    assert list(compile_text(text).interface().signals) == ["a", "b.q"]
    with pytest.raises(SpecError):
        import_file(top)


def test_an_imported_spec_that_differs_from_the_parsed_tree_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "chip.rdl"
    path.write_text(FOREIGN)
    text, wrong = import_file(path).text, "unity_link.spec.format_text"
    for before, after in (
        ("base[1:0]", "base[2:1]"), ("READWRITE", "READ"), ("base + 0x1", "base + 0x2"), ("SIZE=16", "SIZE=15"),
        ("on = 1", "on = 2"), ("mode 2", "unsigned 2"), ("@busy", "@busi"), ("unsigned 16", "signed 16"),
    ):  # fmt: skip
        assert before in text
        monkeypatch.setattr(wrong, lambda _, before=before, after=after: text.replace(before, after))
        with pytest.raises(SpecError, match=r"of the spec|the memories are at"):
            import_file(path)
