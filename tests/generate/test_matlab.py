"""The generated class for MATLAB, run by GNU Octave with `unity-link simulate`."""

from __future__ import annotations

import contextlib
import math
import re
import struct
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest

from generate.every_kind import WORD_BITS, bad_values, every_kind, good_values
from generate.octave import Octave, doubles, words
from generate.peers import serve, simulate
from unity_link.generate import generate
from unity_link.generate.matlab.names import FUNCTIONS, KEYWORDS, MEMBERS, identifiers
from unity_link.spec import Access, KindName, compile_file, compile_text
from unity_link.virtual.build import simulated
from unity_link.virtual.simulated import SimulatedRobot

if TYPE_CHECKING:
    from unity_link.spec import Signal, Value


EXAMPLES = Path(__file__).parents[2] / "examples"

# Values


def literals(signal: Signal, values: list[Value]) -> str:
    """Return values as a column, exactly: those that a double cannot represent are composed of two halves."""
    if shown_values(signal, values).startswith("double"):
        return "hex2num({" + " ".join(f"'{struct.pack('>d', value).hex()}'" for value in values) + "})"
    if signal.kind.name is KindName.BOOL:
        return f"[{'; '.join(str(bool(value)).lower() for value in values)}]"
    halves = (f"{int(value) & 0xFFFFFFFF} {int(value) >> 32 & 0xFFFFFFFF}" for value in values)
    return f"typecast(uint32([{' '.join(halves)}]), '{'int64' if signal.kind.is_signed else 'uint64'}').'"


def shown_values(signal: Signal, values: list[Value]) -> str:
    """Return the text that `show` prints for values of a signal."""
    kind = signal.kind
    if kind.name is KindName.BOOL:
        return " ".join(["logical", *(str(int(value)) for value in values)])
    if not kind.is_float and kind.width > 53:
        return words(*values, kind="int64" if kind.is_signed else "uint64")
    return doubles(*values)


def in_matlab(path: str) -> str:
    components = re.sub(r"\[(\d+)\]\.", lambda match: f"({int(match[1]) + 1}).", path)
    return re.sub(r"\[(\d+)\]$", lambda match: f"{{{int(match[1]) + 1}}}", components)


@pytest.mark.slow
def test_values_of_every_kind_are_encoded_and_decoded_as_by_the_model(octave: Octave) -> None:
    with contextlib.ExitStack() as stack:
        script, expected = [], {}
        for bits in WORD_BITS:
            spec = every_kind(bits)
            # One class for each word width.
            spec = msgspec.structs.replace(
                spec, interfaces=(msgspec.structs.replace(spec.interface(), name=f"robot_{bits}"),)
            )
            octave.generate(spec)
            url = stack.enter_context(simulate("tcp", "--set", f"data_bits={bits}"))
            script.append(f"robot = robot_{bits}('{url}');")
            for signal in spec.interface().signals.values():
                here = f"robot.{in_matlab(signal.path)}"
                label, values = f"{bits} {signal.path}", good_values(signal)
                encoded = [signal.encode(value) for value in values]
                script.append(f"words = {here}.encode({literals(signal, values)});")
                script.append(f"show('{label} words', words.'); show('{label} values', {here}.decode(words));")
                expected[f"{label} words"] = words(*(word for row in encoded for word in row))
                expected[f"{label} values"] = shown_values(signal, [signal.decode(row) for row in encoded])
                if signal.access is Access.READWRITE:
                    script.append(f"{here}.set({literals(signal, values[-1:])}); show('{label} read', {here}.get());")
                    expected[f"{label} read"] = shown_values(signal, [signal.decode(encoded[-1])])
                for number, bad in enumerate(bad_values(signal)):
                    script.append(f"attempt('{label} refused {number}', @() {here}.encode({bad!r}));")
                    expected[f"{label} refused {number}"] = "refused"
        shown = octave.run("\n".join(script))
    assert shown.keys() == expected.keys()
    wrong = {
        label: (shown[label], text)
        for label, text in expected.items()
        if shown[label] != text and not (text == "refused" and shown[label].startswith("unity_link:argumentError "))
    }
    assert not wrong


_KINDS = """\
robot = robot('{url}');
robot.mode.set('manual');
show('mode', robot.mode.get());
show('name', robot.mode.name_of(4));
show('no name', robot.mode.name_of(3));
show('number', robot.mode.number_of('end'));
attempt('wrong name', @() robot.mode.set('automatic'));
attempt('text', @() robot.number.set('1'));
attempt('fraction', @() robot.number.set(1.5));
attempt('two', @() robot.number.set([1 2]));
attempt('read only', @() robot.status.set(1));
attempt('write only', @() robot.command.get());
attempt('no post', @() robot.mode.post(1));
attempt('no queue', @() robot.number.take(1));
attempt('limits', @() robot.angle.set(7));
robot.number.post(-5);
robot.link.fence();
show('posted', robot.number.get());
robot.number.set(int8(-6));
show('integer', robot.number.get());
robot.port.append(1:5);
show('taken', robot.port.take(2));
show('one', robot.port.get());
robot.groups.all.set(struct('number', 11, 'mode', 'end', 'angle', 3));
values = robot.groups.all.get();
show('all', [values.number, values.mode, values.angle, values.large == 0]);
robot.groups.all.set(struct('large', intmax('uint64') - 1));
values = robot.groups.all.get();
show('large', values.large);
attempt('not in the group', @() robot.groups.all.set(struct('number', 1, 'nunber', 2)));
attempt('value in the group', @() robot.groups.all.set(struct('number', 12, 'angle', 99)));
show('nothing sent', robot.number.get());
attempt('not published', @() robot.groups.all.subscribe());
samples = robot.groups.all.subscribe('rate_hz', 500);
data = samples.take(3);
show('sampled', data.values.large);
show('about', {{robot.angle.unit, robot.angle.id, robot.angle.kind, robot.angle.minimum}});
"""


def test_signals_work_within_their_kind_access_and_place(octave: Octave) -> None:
    spec = """\
group all;
enum modes { off, manual = 4, end }
public robot() {
  @mode = 0x40[3:0]: modes READWRITE(GROUP(all));
  @rest = 0x40[31:4]: READWRITE();
  @number = 0x41: signed READWRITE(GROUP(all));
  @status = 0x42: READ();
  @command = 0x43: WRITE();
  @angle = 0x44: signed READWRITE(ID="the 'angle'", SCALE=0.5, UNIT="°", MIN=-5, MAX=5, GROUP(all));
  @large = 0x45: unsigned 64 READWRITE(GROUP(all));
  @port = 0x47: READWRITE(FIFO);
}
"""
    octave.generate(compile_text(spec))
    with simulate("tcp") as url:
        shown = octave.run(_KINDS.format(url=url))
    assert shown["mode"] == doubles(4)
    assert shown["name"] == "manual"
    assert shown["no name"] == ""
    assert shown["number"] == doubles(5)
    assert shown["wrong name"] == (
        "unity_link:argumentError mode: 'automatic' is no value of modes 4: off, manual, end, a number"
    )
    assert shown["limits"] == "unity_link:argumentError angle: 7 is outside of its limits, -5 to 5 °"
    labels = ["text", "fraction", "two", "read only", "write only", "no post", "no queue", "limits"]
    for label in [*labels, "not in the group", "value in the group", "not published"]:
        assert shown[label].startswith("unity_link:argumentError "), shown[label]
    assert shown["posted"] == doubles(-5)
    assert shown["integer"] == doubles(-6)
    # The gateway has plain memory at the port: each read returns the last written word.
    assert shown["taken"] == doubles(5, 5)
    assert shown["one"] == doubles(5)
    assert shown["all"] == doubles(11, 5, 3, 1)
    assert shown["large"] == words(2**64 - 2)
    assert shown["nothing sent"] == doubles(11)
    assert shown["sampled"] == words(*3 * [2**64 - 2])
    assert shown["about"] == f"° the 'angle' signed 32 {doubles(-5)}"


_LIMITS = """\
robot = robot('{url}');
attempt('below in a small class', @() robot.far.encode(uint8(255)));
attempt('least', @() robot.far.encode(uint16(500)));
attempt('above in a class without sign', @() robot.negative.encode(uint8(0)));
attempt('most', @() robot.negative.encode(int8(-1)));
attempt('above by a fraction', @() robot.part.encode(int64(3)));
attempt('most of a fraction', @() robot.part.encode(single(2)));
attempt('below by one', @() robot.large.encode(int64(2) ^ 53));
attempt('no less', @() robot.large.encode(int64(2) ^ 53 + 1));
attempt('scaled', @() robot.scaled.encode(uint8(255)));
attempt('scaled least', @() robot.scaled.encode(int16(500)));
"""


def test_limits_hold_for_values_of_any_class(octave: Octave) -> None:
    spec = """public robot() {
  @far = 1: unsigned 16 READWRITE(MIN=500);
  @negative = 2: signed 8 READWRITE(MIN=-5, MAX=-1);
  @part = 3: signed 8 READWRITE(MIN=-2.5, MAX=2.5);
  @large = 4: unsigned 64 READWRITE(MIN=0x20000000000001);
  @scaled = 6: unsigned 16 READWRITE(SCALE=0.5, MIN=500);
}
"""
    octave.generate(compile_text(spec))
    with simulate("tcp") as url:
        shown = octave.run(_LIMITS.format(url=url))
    said = {label: text.partition(" ")[2] for label, text in shown.items()}
    assert said == {
        "below in a small class": "far: 255 is outside of its limits, at least 500",
        "least": "error",
        "above in a class without sign": "negative: 0 is outside of its limits, -5 to -1",
        "most": "error",
        "above by a fraction": "part: 3 is outside of its limits, -2.5 to 2.5",
        "most of a fraction": "error",
        "below by one": "large: 9007199254740992 is outside of its limits, at least 9007199254740993",
        "no less": "error",
        "scaled": "scaled: 255 is outside of its limits, at least 500",
        "scaled least": "error",
    }


@pytest.mark.slow
def test_results_are_as_on_the_page(octave: Octave) -> None:
    guide = (EXAMPLES.parent / "docs" / "how-to" / "matlab.md").read_text(encoding="utf-8")
    lines = [
        line
        for block in re.findall(r"^```matlab\n(.*?)^```$", guide, re.DOTALL | re.MULTILINE)
        # The SCARA has no lease.
        if "robot.drive" not in block
        for line in block.splitlines()
    ]
    octave.generate(compile_file(EXAMPLES / "scara.ul"))
    script, told = [], {}
    with simulate("tcp", "--robot", "scara") as url:
        for number, line in enumerate(lines):
            if found := re.fullmatch(r"(\S.*?) +% gives (.*)", line):
                script.append(f"value = {found[1]}; if ~ischar(value), value = num2str(value, 5); end")
                script.append(f"show('{number}', regexprep(value, ' +', ' '));")
                told[str(number)] = found[2]
            elif not line.startswith(("addpath", "plot")):
                script.append(line.replace("tcp://127.0.0.1:7001", url))
        shown = octave.run("\n".join(script))
    assert len(told) > 10
    assert shown == told


# Names and texts


def test_arrays_keywords_and_names_of_the_class_are_reached(octave: Octave) -> None:
    octave.generate(compile_file(EXAMPLES / "walker.ul"))
    long_name = 70 * "n"
    octave.generate(
        compile_text(f"""\
public classdef() {{
  @end = 1: READWRITE();
  @_hidden = 2: READWRITE();
  @{long_name} = 3: READWRITE();
  @{long_name}2 = 4: READWRITE();
  @close = 5: READWRITE();
  @link_ = 6: READWRITE();
  link: for() @(7);
  arrays[2]: for() @(8 + i);
}}
for(): @(while) {{ @while: READWRITE(PUBLISH(if)); }}
group if(1, 10);
""")
    )
    with simulate("tcp") as url:
        shown = octave.run(f"""\
robot = walker('{url}');
robot.legs(6).tibia.pos_sp.set(1);
show('leg', robot.link.read(hex2dec('10') + 5 * 12 + 8 + 2));
show('path', robot.legs(6).tibia.pos_sp.path);
values = robot.groups.state.get();
show('group', size(values.legs));
samples = robot.groups.state.subscribe();
data = samples.take(2);
show('samples', size(data.values.legs(6).tibia.spd));
robot.close();
robot = classdef_('{url}');
robot.end_.set(10);
robot.x_hidden.set(20);
robot.{63 * "n"}.set(30);
robot.{62 * "n"}1.set(40);
robot.close_.set(50);
robot.link_.set(60);
robot.link__.while_.set(70);
robot.arrays(1).while_.set(80);
robot.arrays(2).while_.set(90);
show('words', robot.link.read_block(1, 9));
values = robot.groups.if_.get();
show('values', [values.link__.while_, values.arrays.while_]);
""")
    assert shown["leg"] == doubles(round(65536 / (2 * math.pi)))
    assert shown["path"] == "legs(6).tibia.pos_sp"
    assert shown["group"] == doubles(1, 6)
    assert shown["samples"] == doubles(2, 1)
    assert shown["words"] == doubles(*range(10, 100, 10))
    assert shown["values"] == doubles(70, 80, 90)


def test_every_word_of_octave_is_a_keyword(octave: Octave) -> None:
    words = octave.run("show('words', iskeyword());")["words"].split()
    assert "while" in words
    assert {word for word in words if not word.startswith("__")} <= KEYWORDS


def test_every_function_that_is_called_is_one_that_no_class_hides(octave: Octave) -> None:
    specs = (every_kind(64), compile_file(EXAMPLES / "walker.ul"))
    texts = [file.text for spec in specs for file in generate("matlab", spec) if file.name.endswith(".m")]
    code = re.sub(r"%.*|'[^'\n]*'", "", "\n".join(texts))
    called = ", ".join(f"'{name}'" for name in sorted(set(re.findall(r"(?<![.\w])([A-Za-z]\w*)\(", code))))
    shown = octave.run(f"""\
called = {{{called}}};
for index = 1:numel(called)
  show(called{{index}}, exist(called{{index}}));
end
""")
    functions = {name for name, kind in shown.items() if kind in (doubles(2), doubles(5))}
    assert {"numel", "strjoin"} <= functions
    assert functions <= {*FUNCTIONS, *KEYWORDS, *MEMBERS}


@pytest.mark.slow
@pytest.mark.parametrize("name", ["struct", "numel", "link", "size"])
def test_interface_may_have_the_name_of_a_function_or_of_a_class_member(name: str, octave: Octave) -> None:
    octave.generate(compile_text(f"public {name}() {{ @a = 1: signed 16 READWRITE(PUBLISH(g)); }}\ngroup g(1, 10);"))
    with simulate("tcp") as url:
        shown = octave.run(f"""\
robot = {name}_('{url}');
robot.a.set(-2);
show('read', robot.groups.g.get().a);
""")
    assert shown["read"] == doubles(-2)


def test_a_parameter_that_is_no_identifier_is_given_by_another_name(octave: Octave) -> None:
    octave.generate(
        compile_text("public nets(end, _comm) { TOSNET(CTRL=end, COMM=_comm, SIZE=16) { @a = 1: READWRITE(); } }")
    )
    text = (octave.folder / "nets.m").read_text(encoding="utf-8")
    assert set(re.findall(r"given\.(\w+)", text)) == {"end_", "x_comm"}
    with simulate("tcp") as url:
        shown = octave.run(
            f"robot = nets('{url}', 'end_', 32, 'x_comm', 33);\nshow('networks', numel(robot.networks));"
        )
    assert shown["networks"] == doubles(1)


def test_identifiers_are_unique_and_those_that_can_stay() -> None:
    assert identifiers(["ans"]) == {"ans": "ans_"}
    made = identifiers(["end", "end_", "_a", "x_a", 80 * "b", 63 * "b", 63 * "b" + "c"], ["x_a_"])
    assert made["end_"] == "end_"
    assert made["x_a"] == "x_a"
    assert made[63 * "b"] == 63 * "b"
    assert len(set(made.values())) == len(made)
    assert all(name.isidentifier() and len(name) <= 63 and name[0] != "_" for name in made.values())


def test_the_text_is_one_that_matlab_shows_whole() -> None:
    files = generate("matlab", compile_file(EXAMPLES / "walker.ul"))
    assert {file.name for file in files} >= {"walker.m", "+unity_link/Link.m", "+unity_link/Signal.m"}
    for file in [file for file in files if file.name.endswith(".m")]:
        assert max(map(len, file.text.splitlines())) <= 132, file.name
        # In MATLAB, double quotes do not make char arrays.
        assert '"' not in file.text, file.name


def test_generated_text_is_valid_in_matlab_and_not_only_in_octave(octave: Octave) -> None:
    """Octave warns if a file uses a feature that MATLAB lacks."""
    octave.generate(compile_file(EXAMPLES / "scara.ul"))
    files = sorted(str(path.relative_to(octave.folder)) for path in octave.folder.rglob("*.m"))
    extended = "classdef extended\nmethods\nfunction f(obj)\nx = 1;\nx += 1;\nend\nend\nend\n"
    (octave.folder / "extended.m").write_text(extended, encoding="utf-8")
    with octave.start(f"""\
warning('on', 'Octave:language-extension');
files = {{{", ".join(f"'{file}'" for file in [*files, "extended.m"])}}};
for index = 1:numel(files)
  __parse_file__(files{{index}});
end
warning('off', 'Octave:language-extension');
""") as process:
        _, warnings = process.communicate(timeout=60)
    told = [line for line in warnings.splitlines() if "language extension" in line]
    assert len(told) == 1, told
    assert told[0].endswith("extended.m")


# Leases


def test_a_lease_is_armed_kicked_and_disarmed_and_its_end_is_an_error(octave: Octave) -> None:
    spec = compile_text("""
    public leased() {
      GATEWAY(ADDRESS_BITS=12);
      arms[1]: part() @(0xC0);
      drive: LEASE(TIMEOUT=20) @(0xE0);
      @speed = 0x10: signed READWRITE(SAFE(0, drive));
      @bit = 0x11[3]: bool READWRITE(SAFE(false, drive));
      @other = 0x11[7:4]: unsigned 4 READWRITE(SAFE(0, drive));
      @free = 0x12: READWRITE();
    }
    part(): @(at) { lift: LEASE(TIMEOUT=0.2) @(at); }
    """)
    octave.generate(spec)
    with serve(simulated(spec.interface(), SimulatedRobot)) as url:
        shown = octave.run(f"""\
robot = leased('{url}');
attempt('never', @() robot.speed.set(5));
robot.speed.post(5);
attempt('posted', @() robot.link.fence());
attempt('field', @() robot.bit.set(true));
attempt('raw', @() robot.link.write(16, 5));
lease = unity_link.Lease(robot.link, robot.drive);
attempt('too early', @() lease.kick());
attempt('no time', @() lease.arm(0));
attempt('too long', @() lease.arm(100));
lease.arm(15);
lease.kick();
robot.speed.set(5);
show('moves', robot.speed.get());
other = unity_link.Lease(robot.link, robot.drive);
attempt('again', @() other.arm(15));
other.disarm();
show('stopped', robot.speed.get());
attempt('over', @() lease.kick());
attempt('disarmed', @() robot.speed.set(5));
% As another program arms.
robot.drive.arm.set(bitor(bitshift(uint64(77), 40), robot.drive.clock.get() + 500000000));
attempt('another', @() other.arm(15));
attempt('of another', @() lease.kick());
lift = unity_link.Lease(robot.link, robot.arms(1).lift);
lift.arm(0.15);
while robot.arms(1).lift.armed.get()
end
attempt('silent', @() lift.kick());
show('state', robot.arms(1).lift.state.name_of(robot.arms(1).lift.state.get()));
""")
    error, never = "unity_link:busError", "drive is not armed: nobody has armed it since the reset"
    refused = "the bus refused the access"
    assert shown["never"] == f"{error} speed: {refused}: {never}"
    assert shown["posted"] == f"{error} posted write of address 10 (hexadecimal): {refused}: {never}"
    assert shown["field"] == f"{error} bit: {refused}: {never}"
    assert shown["raw"] == f"{error} write of address 10 (hexadecimal): {refused}"
    assert shown["too early"] == f"{error} drive.armed: it was not armed by this program: call arm"
    assert shown["no time"] == "unity_link:argumentError a lease lasts more than 0 s, and less than 3600"
    assert shown["too long"].startswith(f"{error} drive.armed: it was not armed: the line takes longer than the lease")
    assert (shown["moves"], shown["stopped"]) == (doubles(5), doubles(0))
    assert shown["again"] == f"{error} drive.armed: it cannot be armed: this program has armed it already"
    assert shown["another"] == f"{error} drive.armed: it cannot be armed: another program has armed it"
    assert shown["over"] == f"{error} drive.armed: drive is not armed: it was disarmed"
    assert shown["disarmed"] == f"{error} speed: {refused}: drive is not armed: it was disarmed"
    assert shown["of another"] == f"{error} drive.armed: it has ended, and another program has armed it since"
    lift = re.escape(f"{error} arms(1).lift.armed: arms(1).lift is not armed: no kick came before its end")
    assert re.fullmatch(rf"{lift}, at \d+\.\d{{6}} s of the gateway's clock", shown["silent"])
    assert shown["state"] == "fault"
