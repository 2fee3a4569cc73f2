"""The meaning of a spec: the paper's figure, and each further word of the language."""

from pathlib import Path

import msgspec
import pytest

from support.spec_examples import FIGURE_1, interface_of
from unity_link.errors import ArgumentError
from unity_link.spec import (
    Access,
    ComponentArray,
    ComponentSpec,
    GroupSpec,
    Interface,
    Joint,
    Parameter,
    ParameterReference,
    Sensor,
    Signal,
    SpecError,
    compile_file,
    compile_text,
)

EXAMPLES = Path(__file__).parents[2] / "examples"


def addresses(interface: Interface) -> dict[str, int]:
    return {path: signal.address for path, signal in interface.signals.items()}


def signal(declaration: str, outside: str = "") -> Signal:
    (only,) = interface_of(declaration, outside=outside).signals.values()
    return only


def group(interface: Interface, name: str) -> GroupSpec:
    return next(one for one in interface.groups if one.name == name)


# Figure 1


def test_figure_1_of_the_paper_is_valid_unchanged() -> None:
    scara = compile_text(FIGURE_1).interface()
    assert scara.name == "scara"
    assert scara.parameters == (Parameter("ctrl"), Parameter("comm"))
    assert addresses(scara) == {
        f"j{number + 1}.{name}": base + number
        for number in range(4)
        for name, base in (("cpos", 0x88), ("spd", 0x80), ("pos_sp", 0x8C), ("spd_sp", 0x94))
    }
    (module,) = scara.modules
    assert (module.type, module.base, module.name) == ("TOSNET", 0, None)
    assert module.arguments == {"CTRL": ParameterReference("ctrl"), "COMM": ParameterReference("comm")}


def test_the_signals_of_figure_1_are_as_in_the_paper() -> None:
    signals = compile_text(FIGURE_1).interface().signals
    cpos, spd, pos_sp, spd_sp = (signals[f"j2.{name}"] for name in ("cpos", "spd", "pos_sp", "spd_sp"))
    assert [one.id for one in (cpos, spd, pos_sp)] == ["joint 2:cpos", "joint 2:spd", "joint 2:pos_sp"]
    assert [str(one.kind) for one in (cpos, spd, pos_sp, spd_sp)] == [
        "signed 32", "unsigned 32", "signed 32", "unsigned 32",
    ]  # fmt: skip
    assert [one.access for one in (cpos, spd_sp)] == [Access.READ, Access.WRITE]
    assert cpos.decode(0xFFFF_FFFE) == -2
    assert spd.decode(0xFFFF_FFFE) == 0xFFFF_FFFE
    assert pos_sp.encode(-1200) == (0x1_0000_0000 - 1200,)


def test_publish_of_figure_1_makes_one_group_of_all_joints() -> None:
    (only,) = compile_text(FIGURE_1).interface().groups
    assert (only.name, only.number, only.divisor) == ("group_1", 1, 10)
    assert only.signals[:3] == ("j1.cpos", "j1.spd", "j2.cpos")
    assert only.addresses == (0x88, 0x80, 0x89, 0x81, 0x8A, 0x82, 0x8B, 0x83)


# The examples


def test_the_walker_has_18_joints_and_72_values_in_23_lines() -> None:
    path = EXAMPLES / "walker.ul"
    walker = compile_file(path).interface()
    assert len(path.read_text().splitlines()) <= 23
    assert len(walker.signals) == 72
    (state,) = walker.groups
    assert len(state.joints) == 18
    assert state.joints[0] == Joint(
        name="legs[0].coxa",
        position="legs[0].coxa.cpos",
        velocity="legs[0].coxa.spd",
        set_position="legs[0].coxa.pos_sp",
        set_velocity="legs[0].coxa.spd_sp",
    )
    assert sorted(addresses(walker).values()) == list(range(0x10, 0x10 + 72))


def test_the_scara_of_the_examples_has_the_map_of_the_virtual_one() -> None:
    from unity_link.virtual.scara import JOINTS, Scara

    scara = compile_file(EXAMPLES / "scara.ul").interface()
    assert sorted(addresses(scara).values()) == sorted(Scara().addresses())
    for number, joint in enumerate(JOINTS):
        set_point = scara.signals[f"j{number + 1}.pos_sp"]
        assert set_point.kind.scale == pytest.approx(1 / joint.counts_per_unit)
        low, high = (set_point.encode(limit)[0] for limit in set_point.limits)
        assert [word - (word >> 31 << 32) for word in (low, high)] == [joint.lowest, joint.highest]


# Kinds and bits


def test_a_kind_without_a_width_takes_all_bits_of_its_field() -> None:
    assert [str(signal(f"@x = 1: {kind} READ();").kind) for kind in ("", "signed", "float", "bool")] == [
        "unsigned 32", "signed 32", "float 32", "bool",
    ]  # fmt: skip
    assert str(signal("@x = 1[11:4]: signed READ();").kind) == "signed 8"
    assert str(signal("@x = 1[15:0]: float READ();").kind) == "float 16"
    (narrow,) = interface_of("@x = 1: signed READ();", data_bits=16).signals.values()
    assert str(narrow.kind) == "signed 16"


def test_bit_fields_share_a_word_and_are_written_masked() -> None:
    interface = interface_of(
        "@enable = 0x40[0]: bool READWRITE();",
        "@gain = 0x40[11:4]: unsigned READWRITE();",
        "@alone = 0x41[3:0]: WRITE();",
    )
    enable, gain, alone = interface.signals.values()
    assert (gain.lowest_bit, gain.width, gain.mask, gain.is_field) == (4, 8, 0xFF0, True)
    assert enable.is_field
    assert not alone.is_field
    assert gain.decode(0x1234_5678) == 0x67
    assert gain.encode(0xAB) == (0xAB0,)


def test_a_read_and_a_written_signal_may_share_an_address() -> None:
    interface = interface_of("@status = 1: READ();", "@command = 1: WRITE();")
    assert not interface.signals["command"].is_field


def test_a_signal_wider_than_a_word_takes_several_with_the_low_one_first() -> None:
    wide = signal("@x = 0x10: unsigned 64 READWRITE();")
    assert wide.words == 2
    assert list(wide.addresses) == [0x10, 0x11]
    assert wide.decode([2, 1]) == 0x1_0000_0002
    assert wide.encode(0x1_0000_0002) == (2, 1)
    with pytest.raises(ArgumentError, match="x has 2 words, and 1 were given"):
        wide.decode([1])


def test_values_are_scaled_and_have_a_unit() -> None:
    angle = signal('@x = 1: signed 16 READWRITE(SCALE=360 / 4096, OFFSET=-90, UNIT="deg", MIN=-90, MAX=90);')
    assert angle.decode(2048) == 90.0
    assert angle.encode(90) == (2048,)
    assert (angle.unit, angle.limits) == ("deg", (-90, 90))


def test_a_fixed_has_the_stated_number_of_fraction_bits() -> None:
    fixed = signal("@x = 1: fixed 16.16 READWRITE();")
    assert fixed.decode(0xFFFF_8000) == -0.5
    assert signal("@x = 1: ufixed 8.8 READ();").decode(0x0180) == 1.5


def test_an_enumeration_continues_from_the_value_before() -> None:
    enumerated = signal("@x = 1[3:0]: mode READ();", "enum mode { off, manual = 4, auto }").kind.enumeration
    assert enumerated is not None
    assert [(value.name, value.value) for value in enumerated.values] == [("off", 0), ("manual", 4), ("auto", 5)]


# Addresses, components, arrays


def test_arguments_and_addresses_of_an_array_may_use_its_index() -> None:
    interface = interface_of(
        'legs[2]: leg("leg " + (i + 1)) @(0x10 + 8 * i);',
        outside="leg(name): @(base) { joints[3]: joint(name + i) @(base + i); }\n"
        "joint(name): @(pos) { @pos: READ(ID=name); }",
    )
    assert addresses(interface)["legs[1].joints[2].pos"] == 0x1A
    assert interface.signals["legs[1].joints[2].pos"].id == "leg 22"
    (legs,) = interface.root.parts
    assert isinstance(legs, ComponentArray)
    assert [leg.index for leg in legs.items] == [0, 1]
    assert legs.items[1].arguments == {"name": "leg 2"}


def test_arguments_and_addresses_may_be_given_by_name_and_have_defaults() -> None:
    outside = 'c(a="x", b=2): @(p=3, q=4) { @p: READ(ID=a + b); @q: READ(ID=a + "q"); }'
    interface = interface_of("one: c(b=7) @(q=9);", 'two: c("y", 1) @(5, q=6);', outside=outside)
    assert addresses(interface) == {"one.p": 3, "one.q": 9, "two.p": 5, "two.q": 6}
    assert [one.id for one in interface.signals.values()] == ["x7", "xq", "y1", "yq"]


def test_a_default_may_use_the_parameters_before_it() -> None:
    outside = 'c(a, b=a + 1, d="x" + b): @(p, q=p + b, r=q + 1) { @p: READ(ID=d); @q: READ(); @r: READ(); }'
    interface = interface_of("one: c(2) @(8); two: c(2, 5) @(16);", outside=outside)
    assert addresses(interface) == {
        "one.p": 8,
        "one.q": 11,
        "one.r": 12,
        "two.p": 16,
        "two.q": 21,
        "two.r": 22,
    }
    assert [one.id for one in interface.signals.values() if one.name == "p"] == ["x3", "x5"]
    public = compile_text("public x(base=0x20, next=base + 4) { @a = next: READ(); }").interface()
    assert addresses(public) == {"a": 0x24}


@pytest.mark.parametrize(("width", "bits"), [("12", 12), ("64", 64), ("none", 32)])
def test_a_parameter_is_the_width_of_a_kind(width: str, bits: int) -> None:
    outside = "c(size=none): @(x) { @x: signed size READWRITE(MAX=3); }"
    (one,) = interface_of(f"c: c({width}) @(4);", outside=outside).signals.values()
    assert (one.kind.name, one.kind.width) == ("signed", bits)


def test_a_width_may_be_a_parameter_of_an_enumeration_or_unused_component() -> None:
    outside = "enum mode { off, on } c(size): @(x) { @x: mode size READ(); } unused(n): @(x) { @x: unsigned n READ(); }"
    (one,) = interface_of("c: c(3) @(4);", outside=outside).signals.values()
    assert (one.kind.name, one.kind.width) == ("enum", 3)


def test_an_argument_of_none_counts_as_left_out() -> None:
    outside = """
        group state(RATE=100, TIMESTAMPS=true, TRIGGER=false, ON_CHANGE=none);
        d(): @(x) { @x: signed READWRITE(UNIT=none, SCALE=none, PUBLISH(none, 3), POLL(RATE=none), MAX=none); }
    """
    nothing = "unit=none, scale=none, among=none, rate=none, max=none"
    outside += (
        f"e({nothing}): @(x) {{ @x: signed READWRITE(UNIT=unit, SCALE=scale, PUBLISH(among), POLL(rate), MAX=max); }}"
    )
    members = 'a: e("m", 2, state, max=5) @(1); b: e(rate=10) @(2); c: d() @(3); d: e() @(4);'
    interface = interface_of(members, outside=outside)
    found = interface.signals.values()
    assert [(one.unit, one.kind.scale, one.group, one.poll_hz, one.maximum) for one in found] == [
        ("m", 2, "state", None, 5),
        ("", 1, None, 10, None),
        *[("", 1, None, None, None)] * 2,
    ]
    state = group(interface, "state")
    assert (state.timestamps, state.trigger, state.on_change) == (True, False, False)


def test_none_for_a_parameter_with_a_default_is_the_default() -> None:
    outside = 'c(unit="rad"): @(x) { @x: READ(UNIT=unit); } d(unit=none): @(x) { c: c(unit) @(x); }'
    interface = interface_of('a: d() @(1); b: d("deg") @(2);', outside=outside)
    assert [one.unit for one in interface.signals.values()] == ["rad", "deg"]


def test_an_id_that_is_left_out_is_the_path() -> None:
    assert interface_of("c[1]: c();", outside="c() { @x = 1: READ(); }").signals["c[0].x"].id == "c[0].x"


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ("1 + 2 * 3", 7), ("(1 + 2) * 3", 9), ("10 - 4 - 3", 3), ("1 << 4 | 1", 17), ("0xFF & ~0x0F", 0xF0),
        ("7 / 7", 1), ("9 % 4", 1), ("0b1010_1010", 170), ("-1 + 2", 1), ("6 ^ 3", 5), ("1_0", 10), ("2 * 8 / 4", 4),
        ("max(3, min(9, 7), 5)", 7), ("ceil(7 / 2)", 4), ("floor(-7 / 2) + 9", 5), ("1 << floor(log2(100))", 64),
    ],
)  # fmt: skip
def test_expressions_are_computed_with_the_usual_precedence(expression: str, value: int) -> None:
    assert signal(f"@x = {expression}: READ();").address == value


def test_the_parameters_of_an_interface_have_values_or_are_given_later() -> None:
    interface = compile_text("public x(comm, base=0x20) { @a = base + 1: READ(); }").interface()
    assert interface.parameters == (Parameter("comm", None), Parameter("base", 0x20))
    assert addresses(interface) == {"a": 0x21}


def test_names_are_imported_from_other_files_each_once(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "robot.ul").write_text(
        'import "lib/joint.ul";\nimport "lib/kinds.ul";\npublic r() { j: joint() @(1); }'
    )
    (tmp_path / "lib" / "joint.ul").write_text('import "kinds.ul";\njoint(): @(m) { @m: mode READ(); }')
    (tmp_path / "lib" / "kinds.ul").write_text("enum mode { off, on }\npublic other() {}")
    spec = compile_file(tmp_path / "robot.ul")
    assert [interface.name for interface in spec.interfaces] == ["r"]
    assert [Path(source.name).name for source in spec.sources] == ["robot.ul", "joint.ul", "kinds.ul"]
    assert [one.name for one in spec.interface().enumerations] == ["mode"]


# Modules


def test_addresses_in_a_module_are_relative_to_its_base() -> None:
    interface = interface_of(
        "TOSNET(BASE=0x100) {",
        "  TOSNET_NODE(NODE=2) { @x = 1: READ(); }",
        "  @y = 2: READ();",
        "}",
        "@z = 3: READ();",
        address_bits=16,
    )
    assert addresses(interface) == {"x": 0x181, "y": 0x102, "z": 3}
    tosnet, node = interface.modules
    assert (node.base, node.words, node.parent, node.arguments) == (0x180, 64, 0, {"NODE": 2})
    assert [one.module for one in interface.signals.values()] == [1, 0, None]
    assert tosnet.words is None


def test_a_module_without_a_block_contains_the_whole_interface() -> None:
    interface = interface_of(
        "@x = 1: READ();", "c: c();", "MEMORY(BASE=0x10, SIZE=16);", outside="c() { @y = 2: READ(); }"
    )
    assert addresses(interface) == {"x": 0x11, "c.y": 0x12}


def test_modules_have_names_parameters_and_arrays() -> None:
    interface = interface_of(
        "/// Two tables.", "tables[2]: MEMORY(BASE=0x40 + 4 * i, SIZE=4);", "c: c();",
        outside="c() { log: FIFO(BASE=0x20, WORDS=8) { @p = 0: READ(); } }",
    )  # fmt: skip
    assert [(one.type, one.path, one.base, one.words) for one in interface.modules] == [
        ("MEMORY", "tables[0]", 0x40, 4), ("MEMORY", "tables[1]", 0x44, 4), ("FIFO", "c.log", 0x20, None),
    ]  # fmt: skip
    assert interface.root.modules == (0, 1)
    assert interface.modules[0].doc == "Two tables."
    assert addresses(interface) == {"c.p": 0x20}


def test_a_gateway_declaration_sets_the_widths() -> None:
    interface = interface_of("GATEWAY(ADDRESS_BITS=16, DATA_BITS=24);", "@x = 0x1000: READ();")
    assert (interface.address_bits, interface.data_bits) == (16, 24)
    assert str(interface.signals["x"].kind) == "unsigned 24"


def test_a_caller_may_set_the_widths_of_the_gateway() -> None:
    assert interface_of("@x = 0x1000: READ();", address_bits=16).address_bits == 16


# Publishing


def test_a_fifo_port_has_its_depth() -> None:
    assert (signal("@x = 1: READ(FIFO);").fifo, signal("@x = 1: READ(FIFO);").fifo_words) == (True, None)
    assert signal("@x = 1: READWRITE(FIFO(512));").fifo_words == 512


def test_a_signal_may_be_polled() -> None:
    assert signal("@x = 1: READ(POLL(20));").poll_hz == 20


def test_groups_have_names_and_get_the_free_numbers() -> None:
    interface = interface_of(
        "@a = 1: READ(PUBLISH(fast));", "@b = 2: READ(PUBLISH(0, 7));", "@c = 3: READ(PUBLISH(slow, 5));",
        "@d = 4: READ(PUBLISH(2));", "@e = 5: WRITE(GROUP(targets));", "@f = 6: READ(PUBLISH(slow), GROUP(targets));",
        outside="/// Quick.\ngroup fast(RATE=1000, TIMESTAMPS, IMMEDIATE);\ngroup slow(ON_CHANGE);\n"
        "group named(2, 9);\ngroup targets;\ngroup unused(5, 5);",
    )  # fmt: skip
    assert {one.name: one.number for one in interface.groups} == {
        "fast": 1, "group_0": 0, "slow": 3, "named": 2, "targets": None,
    }  # fmt: skip
    fast = group(interface, "fast")
    assert (fast.rate_hz, fast.timestamps, fast.immediate, fast.on_change, fast.doc) == (
        1000,
        True,
        True,
        False,
        "Quick.",
    )
    assert (group(interface, "slow").divisor, group(interface, "slow").on_change) == (5, True)
    assert group(interface, "named").signals == ("d",)
    assert group(interface, "targets").signals == ("e", "f")
    assert interface.signals["f"].groups == ("slow", "targets")
    assert interface.signals["e"].group is None


def test_fields_of_one_word_are_one_word_of_a_sample() -> None:
    interface = interface_of("@a = 1[3:0]: READ(PUBLISH(1, 2));", "@b = 1[7:4]: READ(PUBLISH(1));")
    assert interface.groups[0].addresses == (1,)


@pytest.mark.parametrize("number", [3, 31, 511])
def test_a_limit_may_be_the_written_end_of_a_scaled_kind(number: int) -> None:
    width, written = number.bit_length(), number * 3 / 10
    wanted = signal(f"@x = 1: unsigned {width} READWRITE(SCALE=0.3, MAX={written});")
    assert wanted.kind.range[1] < written == wanted.maximum
    assert wanted.encode(written) == (number,)
    with pytest.raises(SpecError, match="is outside of"):
        signal(f"@x = 1: unsigned {width} READWRITE(SCALE=0.3, MAX={written + 0.2});")


def test_a_numbered_group_differs_from_a_declared_group_of_its_name() -> None:
    interface = interface_of(
        "@a = 1: READ(PUBLISH(1, 20));", "@b = 2: READ(PUBLISH(group_1));", outside="group group_1(5, 20);"
    )
    groups = [(group.name, group.number, group.signals) for group in interface.groups]
    assert groups == [("group_1_", 1, ("a",)), ("group_1", 5, ("b",))]


def test_the_joints_of_a_group_are_the_components_with_the_named_signals() -> None:
    interface = interface_of(
        "j[2]: j() @(2 * i, 2 * i + 1);", "@extra = 9: READ(PUBLISH(s));",
        outside="group s(1, 2, JOINTS(POSITION=p, EFFORT=e));\n"
        "j(): @(p, e) { @p: READ(PUBLISH(s)); @e: READ(PUBLISH(s)); }",
    )  # fmt: skip
    assert interface.groups[0].joints == (
        Joint(name="j[0]", position="j[0].p", effort="j[0].e"), Joint(name="j[1]", position="j[1].p", effort="j[1].e"),
    )  # fmt: skip


def test_the_set_points_of_joints_are_the_writable_signals_beside_them() -> None:
    interface = interface_of(
        "a: j() @(0);", "b: fixed() @(4);",
        outside="group s(1, 2, JOINTS(POSITION=p, SET_POSITION=p, SET_EFFORT=e));\n"
        "j(): @(p) { @p: READWRITE(PUBLISH(s)); @e = p + 1: WRITE(); }\n"
        "fixed(): @(p) { @p: READ(PUBLISH(s)); }",
    )  # fmt: skip
    assert interface.groups[0].joints == (
        Joint(name="a", position="a.p", set_position="a.p", set_effort="a.e"), Joint(name="b", position="b.p"),
    )  # fmt: skip


def test_sensors_of_a_group_are_components_with_the_named_signals() -> None:
    interface = interface_of(
        "a: chip() @(0);", "b: chip() @(8);", "@far = 16: READ(PUBLISH(s));",
        outside="group s(1, 2, IMU(ANGULAR_VELOCITY=gyro), RANGEFINDER(DISTANCE=far, FIELD_OF_VIEW=0.5, INFRARED));\n"
        "chip(): @(p) { @gyro[3] = p + i: READ(PUBLISH(s)); }",
    )  # fmt: skip
    gyros = [{"ANGULAR_VELOCITY": tuple(f"{name}.gyro[{axis}]" for axis in range(3))} for name in "ab"]
    assert interface.groups[0].sensors == (
        Sensor(word="IMU", name="a", signals=gyros[0]),
        Sensor(word="IMU", name="b", signals=gyros[1]),
        Sensor(word="RANGEFINDER", name="", signals={"DISTANCE": ("far",)}, field_of_view=0.5, infrared=True),
    )


# The model


def test_doc_strings_are_in_the_model() -> None:
    interface = compile_text(
        "/// The robot.\n///\n/// All of it.\npublic r() {\n/// A led.\n@led = 1: READ();\n"
        "/// The first.\nc: c();\nd: c();\n}\n"
        "/// Any.\nc() {}\n"
    ).interface()
    assert interface.doc == "The robot.\n\nAll of it."
    assert interface.signals["led"].doc == "A led."
    assert [part.doc for part in interface.root.parts] == ["The first.", "Any."]
    first, _ = interface.root.parts
    assert isinstance(first, ComponentSpec)
    assert first.type_doc == "Any."


def test_the_model_is_immutable_and_can_be_written_as_json() -> None:
    spec = compile_file(EXAMPLES / "walker.ul")
    with pytest.raises(AttributeError):
        spec.interfaces[0].signals["legs[0].coxa.cpos"].address = 5  # type: ignore[misc]
    assert msgspec.json.decode(msgspec.json.encode(spec), type=type(spec)) == spec


def test_an_interface_is_selected_by_its_name_or_as_the_only_one() -> None:
    spec = compile_text("public a() {}\npublic b() {}")
    assert spec.interface("b").name == "b"
    with pytest.raises(ArgumentError, match="the spec has 2 public interfaces: name one of a, b"):
        spec.interface()
    with pytest.raises(ArgumentError, match="the spec has no public interface 'c': a, b was expected"):
        spec.interface("c")
    for name in (None, "c"):
        with pytest.raises(ArgumentError, match=r"^the spec has no public interface: it begins as in `public robot"):
            compile_text("part() {}").interface(name)


def test_the_model_has_the_hash_of_its_source() -> None:
    first, second = (compile_text(text).sources[0].sha256 for text in ("public a() {}", "public a() { }"))
    assert first != second
