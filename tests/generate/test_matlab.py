"""The generated class for MATLAB, run by GNU Octave against `unity-link simulate` on real media.

Octave takes a second to start, so a script asks for many things at once and prints what it got, ``LABEL<TAB>TEXT`` a
line; the tests look at the lines. Numbers are printed so that no bit is lost (`show` in `_PRELUDE`).
"""

from __future__ import annotations

import contextlib
import functools
import math
import re
import shutil
import socket
import struct
import subprocess
import threading
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest

from generate.every_kind import WORD_BITS, bad_values, every_kind, good_values
from generate.peers import MEDIA, FaultyLine, Medium, damage, lose, replace, simulate
from spec_examples import FIGURE_1
from unity_link.generate import generate, write
from unity_link.generate.matlab.names import KEYWORDS, identifiers
from unity_link.spec import Access, KindName, compile_file, compile_text
from unity_link.wire.crc import Crc
from unity_link.wire.frames import Framing

if TYPE_CHECKING:
    from collections.abc import Iterator

    from unity_link.spec import Signal, Spec, Value

EXAMPLES = Path(__file__).parents[2] / "examples"
_PRELUDE = """\
1;
function show(label, value)
  if iscell(value)
    text = strjoin(cellfun(@describe, value, 'UniformOutput', false), ' ');
  else
    text = describe(value);
  end
  printf('%s\\t%s\\n', label, text);
  fflush(stdout);
end
function text = describe(value)
  if ischar(value)
    text = value;
  elseif isa(value, 'double')
    text = strjoin(cellstr(num2hex(value(:))).', ' ');
  elseif isa(value, 'uint64') || isa(value, 'int64')
    text = strtrim(sprintf('%08x%08x ', flipud(reshape(typecast(value(:).', 'uint32'), 2, []))));
  else
    text = strtrim(sprintf('%d ', value));
  end
  if ~ischar(value)
    text = strtrim([class(value), ' ', text]);
  end
end
function attempt(label, action)
  try
    action();
    show(label, 'no error');
  catch reason
    show(label, [reason.identifier, ' ', reason.message]);
  end
end
"""


@functools.cache
def _why_not() -> str:
    """Say what is missing for these tests; empty where nothing is."""
    octave = shutil.which("octave-cli")
    if octave is None:
        return "octave-cli is not installed (Debian: apt install octave)"
    found = subprocess.run([octave, "--eval", "pkg('load', 'instrument-control')"], capture_output=True, check=False)
    if found.returncode:
        return "Octave's instrument-control is not installed (Debian: apt install octave-instrument-control)"
    return ""


@pytest.fixture(autouse=True)
def _octave() -> None:
    if _why_not():
        pytest.skip(_why_not())


class Octave:
    """Octave in a folder with generated code."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def generate(self, spec: Spec) -> None:
        """Add the class of a spec."""
        write(generate("matlab", spec), self.folder)

    def start(self, script: str) -> subprocess.Popen[str]:
        """Run a script."""
        (self.folder / "script.m").write_text(f"{_PRELUDE}{script}\nexit(0);\n", encoding="utf-8")
        return subprocess.Popen(
            ["octave-cli", "--no-init-file", "--quiet", "script.m"],
            cwd=self.folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run(self, script: str) -> dict[str, str]:
        """Run a script to its end, and give what it showed, by its labels."""
        with self.start(script) as process:
            output, errors = process.communicate(timeout=120)
        assert process.returncode == 0, f"{output}\n{errors}"
        return dict(line.split("\t", 1) for line in output.splitlines())


@pytest.fixture
def octave(tmp_path: Path) -> Octave:
    return Octave(tmp_path)


def doubles(*values: float) -> str:
    """Give what `show` prints for doubles."""
    return " ".join(["double", *(struct.pack(">d", value).hex() for value in values)])


def words(*values: float, kind: str = "uint64") -> str:
    """Give what `show` prints for whole numbers of 64 bits."""
    return " ".join([kind, *(f"{int(value) & (1 << 64) - 1:016x}" for value in values)])


def numbers(text: str) -> list[float]:
    """Read what `show` printed for doubles."""
    kind, *values = text.split()
    assert kind == "double"
    return [struct.unpack(">d", bytes.fromhex(value))[0] for value in values]


@contextlib.contextmanager
def gateway(medium: Medium, *arguments: str) -> Iterator[str]:
    with simulate(medium, *arguments) as url:
        yield url


# Words

_WORDS = """\
link = unity_link.Link('{url}');
link.write(10, 42);
show('read', link.read(10));
show('masked', link.write_masked(10, 5, 15));
show('after masked', link.read(10));
link.write_block(32, [1 2 2^32 - 1]);
show('block', link.read_block(32, 3));
show('many', link.read_many([33 32; 10 34]));
link.write_many([40 41], [7 8]);
show('written many', link.read_block(40, 2));
link.write_queue(50, [1 2 3]);
show('queue', link.read_queue(50, 2));
for number = 1:300
  link.post(60, number);
end
link.fence();
show('posted', link.read(60));
show('long block', sum(link.read_block(0, 256)));
link.send_immediate('always');
attempt('bus error', @() link.write(136, 1));
attempt('block error', @() link.write_block(135, [1 2]));
link.post(137, 1);
link.post(138, 1);
attempt('posted error', @() link.fence());
attempt('error told once', @() link.fence());
attempt('word too large', @() link.write(10, 2^32));
attempt('fraction', @() link.write(10, 1.5));
attempt('address too large', @() link.read(256));
attempt('negative', @() link.read(-1));
attempt('past the end', @() link.read_block(255, 2));
attempt('no words', @() link.read_block(1, 0));
show('still there', link.read(10));
link.close();
link.close();
attempt('closed', @() link.read(10));
"""


@pytest.mark.parametrize("medium", MEDIA)
def test_words_are_read_written_and_posted_and_errors_have_identifiers(octave: Octave, medium: Medium) -> None:
    octave.generate(compile_text(FIGURE_1))
    with gateway(medium, "--robot", "scara") as url:
        shown = octave.run(_WORDS.format(url=url))
    assert shown["read"] == doubles(42)
    assert shown["masked"] == doubles(42)
    assert shown["after masked"] == doubles(37)
    assert shown["block"] == doubles(1, 2, 0xFFFFFFFF)
    # MATLAB's order is by columns.
    assert shown["many"] == doubles(2, 37, 1, 0xFFFFFFFF)
    assert shown["written many"] == doubles(7, 8)
    assert shown["queue"] == doubles(3, 3)
    assert shown["posted"] == doubles(300)
    assert numbers(shown["long block"])[0] > 0xFFFFFFFF
    assert shown["bus error"] == "unity_link:busError write of address 88 (hexadecimal): the bus refused the access"
    assert shown["block error"].startswith("unity_link:busError block write of address 87")
    assert shown["posted error"] == (
        "unity_link:busError posted write of address 89 (hexadecimal) (and 1 more posted writes): "
        "the bus refused the access"
    )
    assert shown["error told once"] == "no error"
    for label in ("word too large", "fraction", "address too large", "negative", "past the end", "no words"):
        assert shown[label].startswith("unity_link:argumentError "), shown[label]
    assert shown["still there"] == doubles(37)
    assert shown["closed"] == "unity_link:linkLost the link was closed; the request is known not to be executed"


_CONFIGURATIONS: dict[str, tuple[str, ...]] = {
    "long ids": ("id_digits=3",),
    "a crc of 16 bits": ("crc_bits=16",),
    "a crc of 32 bits": ("crc_bits=32", "address_bits=21", "data_bits=17"),
    "no flow control": ("features=0x6f", "receive_fifo_bytes=64"),
    "short blocks": ("block_words=3",),
    "words of 64 bits": ("data_bits=64",),
}


def test_gateways_of_other_builds_are_spoken_to(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    script = """\
link = unity_link.Link('{url}');
words = [1:20, 2^16 + 1];
link.write_block(16, words);
show('{name}: block', all(double(link.read_block(16, 21)).' == words));
for number = 1:50
  link.post(100 + number, number);
end
link.fence();
show('{name}: many', all(double(link.read_many(101:150)) == 1:50));
"""
    wide = "link.write(5, intmax('uint64') - 1);\nshow('wide', link.read(5));\n"
    with contextlib.ExitStack() as stack:
        parts = []
        for name, settings in _CONFIGURATIONS.items():
            options = [option for setting in settings for option in ("--set", setting)]
            url = stack.enter_context(simulate("tcp", *options))
            parts.append(script.format(url=url, name=name))
        shown = octave.run("".join(parts) + wide)
    for name in _CONFIGURATIONS:
        assert shown[f"{name}: block"] == "logical 1"
        assert shown[f"{name}: many"] == "logical 1"
    assert shown["wide"] == words(2**64 - 2)


@contextlib.contextmanager
def hanging_up() -> Iterator[str]:
    """Give the URL of a server that ends the one connection that it takes."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def hang_up() -> None:
            server.accept()[0].close()

        thread = threading.Thread(target=hang_up, daemon=True)
        thread.start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}"
        thread.join()


def test_urls_and_gateways_that_do_not_fit_are_told(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp", "--set", "data_bits=16", "--set", "features=0") as url, hanging_up() as closing:
        shown = octave.run(f"""\
attempt('url', @() unity_link.Link('telnet://here'));
attempt('option', @() unity_link.Link('serial:/dev/ttyX?bits=7'));
attempt('node', @() unity_link.Link('tcp://localhost:1?node=255'));
attempt('nobody', @() unity_link.Link('tcp://127.0.0.1:1'));
attempt('silent', @() unity_link.Link('{url}?node=5', 0.3));
attempt('hung up', @() unity_link.Link('{closing}'));
attempt('widths', @() scara('{url}'));
link = unity_link.Link('{url}');
attempt('groups', @() link.subscribe(1, 'rate_hz', 100));
attempt('masked', @() link.write_masked(1, 1, 1));
attempt('queue', @() link.read_queue(1, 1));
""")
    assert shown["url"].startswith("unity_link:argumentError 'telnet://here' is no URL of a gateway")
    assert shown["option"].startswith("unity_link:argumentError 'bits=7'")
    assert shown["node"].startswith("unity_link:argumentError node=255")
    assert shown["nobody"].startswith("unity_link:connectError tcp://127.0.0.1:1 cannot be opened")
    assert shown["silent"].startswith("unity_link:connectError no gateway answered")
    assert shown["hung up"].startswith("unity_link:connectError tcp://127.0.0.1:")
    assert shown["widths"].startswith("unity_link:unsupported the gateway has words of 16 bits")
    for label in ("groups", "masked", "queue"):
        assert shown[label].startswith("unity_link:unsupported the gateway was built without"), shown[label]


# Lost frames

_LOST = """\
robot = robot('{url}');
link = robot.link;
link.write(10, 1);
show('read', link.read(10));
link.write(11, 2);
show('masked', link.write_masked(12, 255, 15));
attempt('masked, answer lost', @() link.write_masked(12, 255, 240));
show('after masked', link.read(12));
robot.field.set(3);
show('field', robot.field.get());
for number = 1:20
  link.post(13, number);
end
link.fence();
show('posted', link.read(13));
show('many', link.read_many(10:13));
link.write_queue(14, [5 6]);
attempt('queue, answer lost', @() link.read_queue(14, 1));
show('repetitions', link.statistics.repetitions > 0);
"""


def test_lost_and_damaged_frames_give_the_right_result_exactly_once(octave: Octave) -> None:
    octave.generate(
        compile_text("public robot() { @field = 15[3:0]: READWRITE(); @other = 15[7:4]: READWRITE(); }", name="r.ul")
    )
    replies = [lose("^w00"), lose("^r01"), lose("^wk04"), lose("^wk06"), lose("^h")]
    replies += [damage("^r..000000FF"), lose("^r..00000002"), lose("^rq")]
    requests = [lose("^w02"), damage("^wk03"), lose("^ws"), damage("^ws"), lose("^wq")]
    with simulate("tcp") as url, FaultyLine(url, "pty", replies, requests) as line:
        shown = octave.run(_LOST.format(url=line.url))
        sent = list(line.requests)
    assert shown["read"] == doubles(1)
    assert shown["masked"] == doubles(0)
    assert shown["masked, answer lost"].startswith("unity_link:answerLost masked write of address C")
    assert shown["after masked"] == doubles(255)
    assert shown["field"] == doubles(3)
    assert shown["posted"] == doubles(20)
    assert shown["many"] == doubles(1, 2, 255, 20)
    assert shown["queue, answer lost"].startswith("unity_link:answerLost queue read of address E")
    assert shown["repetitions"] == "logical 1"
    for beginning in ("w00", "r01", "w02", "wk03", "wk04", "wk06"):
        assert sum(frame.startswith(beginning) for frame in sent) == 2, beginning


def test_errors_of_the_gateway_have_their_identifiers(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    codes = {5: "busTimeout", 6: "outOfRange", 8: "answerLost", 0x42: "gatewayError"}
    framing = Framing(Crc())
    replies = [
        replace(f"^r{number:02X}", framing.checked(b"x%02X%02X" % (number, code))) for number, code in enumerate(codes)
    ]
    replies.append(replace("^r04", framing.checked(b"X02"), times=3))
    with simulate("tcp") as url, FaultyLine(url, "tcp", replies) as line:
        shown = octave.run(
            f"link = unity_link.Link('{line.url}');\n"
            + "".join(f"attempt('{code}', @() link.read(1));\n" for code in codes)
            + "attempt('2', @() link.read(1));\nlink.write(1, 9);\nshow('after', link.read(1));\n"
        )
    for code, name in codes.items():
        assert shown[str(code)].startswith(f"unity_link:{name} read of address 1 (hexadecimal): ")
    assert shown["2"].startswith("unity_link:unsupported read of address 1")
    assert shown["after"] == doubles(9)


def test_writes_over_a_noisy_line_are_all_there(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp", "--loss", "0.002", "--flip", "0.002", "--double", "0.001", "--seed", "3") as url:
        shown = octave.run(f"""\
link = unity_link.Link('{url}', 30);
for number = 0:99
  link.post(number, 1000 + number);
end
link.fence();
link.write_block(100, 1:10);
show('posted', isequal(link.read_many(0:99), 1000:1099));
same = true;
for number = 1:20
  link.write(200, number);
  same = same && link.read(200) == number;
end
show('one by one', same);
show('block', isequal(link.read_block(100, 10).', 1:10));
show('repetitions', link.statistics.repetitions > 0);
""")
    assert shown == dict.fromkeys(("posted", "one by one", "block", "repetitions"), "logical 1")


@pytest.mark.parametrize("medium", MEDIA)
def test_a_gateway_that_went_away_is_a_lost_link(octave: Octave, medium: Medium) -> None:
    octave.generate(compile_text(FIGURE_1))
    with contextlib.ExitStack() as stack:
        url = stack.enter_context(simulate(medium))
        script = f"""\
link = unity_link.Link('{url}');
show('open', link.read(1));
fgetl(stdin);
attempt('lost', @() link.write(1, 1));
attempt('again', @() link.read(1));
"""
        process = octave.start(script)
        assert process.stdout is not None
        assert process.stdout.readline().startswith("open")
    output, _ = process.communicate("\n", timeout=60)
    lost, again = output.splitlines()
    assert lost.startswith("lost\tunity_link:linkLost the connection was lost (")
    assert lost.endswith("; the request is perhaps executed")
    assert again.startswith("again\tunity_link:linkLost the connection was lost (")
    assert again.endswith("; the request is known not to be executed")


@pytest.mark.parametrize(
    ("settings", "most"), [(("features=0x6f", "receive_fifo_bytes=64"), 8), ((), 128)], ids=["a small FIFO", "all IDs"]
)
def test_no_more_is_in_flight_than_the_gateway_takes(octave: Octave, settings: tuple[str, ...], most: int) -> None:
    octave.generate(compile_text(FIGURE_1))
    options = [option for setting in settings for option in ("--set", setting)]
    with simulate("tcp", *options) as url, FaultyLine(url, "tcp", [lose("^r", times=most)]) as line:
        shown = octave.run(f"link = unity_link.Link('{line.url}'); show('words', sum(link.read_many(0:199)));")
        sent = [frame for frame in line.requests if frame.startswith("r")]
    assert shown["words"] == doubles(0)
    # The answers to all that the first turn sends are lost, so what follows is the first one again.
    assert sent.index(sent[0], 1) == most


# Subscriptions

_SAMPLES = """\
robot = scara('{url}');
robot.j1.spd_sp.set(5);
robot.j1.pos_sp.set(100);
samples = robot.groups.state.subscribe();
show('rate', samples.rate_hz);
data = samples.take(50);
show('sequence', isequal(data.sequence, (0:49).'));
show('lost', sum(data.lost));
steps = diff(data.time);
show('steps', [min(steps), max(steps)]);
show('sizes', [size(data.words), size(data.values.j4.spd)]);
show('decoded', isequal(data.values.j1.cpos, data.words(:, 1) * 0.0018));
show('moving', data.values.j1.cpos(end) > data.values.j1.cpos(1));
again = robot.groups.state.subscribe('divisor', 50);
show('again', [again.rate_hz, again.take(1).lost, again.group ~= samples.group]);
attempt('group in use', @() robot.link.subscribe(1, 'group', again.group));
clear again
samples.close();
samples.close();
attempt('closed', @() samples.take(1));
other = robot.link.subscribe([140 10], 'rate_hz', 1000, 'timestamps', false, 'buffer', 20);
robot.link.write(10, 7);
data = other.take(5);
show('ad hoc', data.words(:, 1).' == robot.link.read(140));
show('no time', isempty(data.time));
began = tic;
while toc(began) < 0.1
  robot.link.read(0);
end
last = data.sequence(end);
data = other.take();
show('dropped', [data.lost(1) > 0, data.sequence(1) == last + 1 + data.lost(1), numel(data.sequence) == 20]);
show('counted', other.received + other.lost == data.sequence(end) + 1);
clear other
one = robot.link.subscribe(10);
show('none by itself', numel(one.take(1, 0.01).sequence));
one.publish();
one.publish();
data = one.take(2);
show('asked for', data.words.');
change = robot.link.subscribe(10, 'rate_hz', 1000, 'on_change', true);
robot.link.write(10, 8);
data = change.take(2);
show('changes', data.words.');
attempt('bad rate', @() robot.link.subscribe(10, 'rate_hz', 0.1));
attempt('both', @() robot.link.subscribe(10, 'rate_hz', 10, 'divisor', 10));
attempt('option', @() robot.link.subscribe(10, 'speed', 10));
attempt('address', @() robot.link.subscribe(256, 'rate_hz', 10));
values = robot.groups.state.get();
show('group', [strjoin(fieldnames(values).', ' '), sprintf(' %d', isscalar(values.j4.cpos))]);
"""


@pytest.mark.parametrize("medium", MEDIA)
def test_samples_of_groups_and_addresses_come_with_their_numbers_times_and_values(
    octave: Octave, medium: Medium
) -> None:
    octave.generate(compile_file(EXAMPLES / "scara.ul"))
    with simulate(medium, "--robot", "scara") as url:
        shown = octave.run(_SAMPLES.format(url=url))
    assert shown["rate"] == doubles(1000)
    assert shown["sequence"] == "logical 1"
    assert shown["lost"] == doubles(0)
    assert numbers(shown["steps"]) == pytest.approx([0.001, 0.001], rel=1e-6)
    assert shown["sizes"] == doubles(50, 8, 50, 1)
    assert shown["decoded"] == "logical 1"
    assert shown["moving"] == "logical 1"
    assert shown["again"] == doubles(2000, 0, 1)
    assert shown["group in use"].startswith("unity_link:argumentError group 254 of the gateway is in use")
    assert shown["closed"].startswith("unity_link:argumentError the subscription is closed")
    assert shown["ad hoc"] == "logical 1 1 1 1 1"
    assert shown["no time"] == "logical 1"
    assert shown["dropped"] == "logical 1 1 1"
    assert shown["counted"] == "logical 1"
    assert shown["none by itself"] == doubles(0)
    assert shown["asked for"] == doubles(7, 7)
    assert shown["changes"] == doubles(7, 8)
    for label in ("bad rate", "both", "option", "address"):
        assert shown[label].startswith("unity_link:argumentError "), shown[label]
    assert shown["group"] == "j1 j2 j3 j4 1"


def test_lost_samples_are_counted(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url, FaultyLine(url, "tcp", [lose("^P..02"), damage("^P..03"), lose("^P..FF")]) as line:
        shown = octave.run(f"""\
link = unity_link.Link('{line.url}');
samples = link.subscribe(1, 'rate_hz', 10000, 'timestamps', false);
data = samples.take(600);
show('lost', find(data.lost).' - 1);
show('how many', data.lost(data.lost > 0).');
show('sequence', data.sequence([1:3, 254]).');
show('total', samples.lost);
show('damaged', link.statistics.damaged_frames);
""")
    assert shown["lost"] == doubles(2, 253)
    assert shown["how many"] == doubles(2, 1)
    assert shown["sequence"] == doubles(0, 1, 4, 256)
    assert shown["total"] == doubles(3)
    assert shown["damaged"] == doubles(1)


def test_a_lost_answer_is_asked_for_again_while_samples_arrive(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url, FaultyLine(url, "tcp", [lose("^r")]) as line:
        shown = octave.run(f"""\
link = unity_link.Link('{line.url}');
link.write(1, 5);
samples = link.subscribe(1, 'rate_hz', 5000);
show('read', link.read(1));
show('samples', mean(samples.take(10).words));
""")
        assert line.count("^r") == 2
    assert shown == {"read": doubles(5), "samples": doubles(5)}


# Values


def literals(signal: Signal, values: list[Value]) -> str:
    """Write values as a column, exactly: those that a double does not hold are put together from halves."""
    if shown_values(signal, values).startswith("double"):
        return "hex2num({" + " ".join(f"'{struct.pack('>d', value).hex()}'" for value in values) + "})"
    if signal.kind.name is KindName.BOOL:
        return f"[{'; '.join(str(bool(value)).lower() for value in values)}]"
    halves = (f"{int(value) & 0xFFFFFFFF} {int(value) >> 32 & 0xFFFFFFFF}" for value in values)
    return f"typecast(uint32([{' '.join(halves)}]), '{'int64' if signal.kind.is_signed else 'uint64'}').'"


def shown_values(signal: Signal, values: list[Value]) -> str:
    """Give what `show` prints for values of a signal."""
    kind = signal.kind
    if kind.name is KindName.BOOL:
        return " ".join(["logical", *(str(int(value)) for value in values)])
    if not kind.is_float and kind.width > 53:
        return words(*values, kind="int64" if kind.is_signed else "uint64")
    return doubles(*values)


def in_matlab(path: str) -> str:
    return path.replace("[0]", "(1)").replace("[1]", "(2)")


def test_values_of_every_kind_are_encoded_and_decoded_as_by_the_model(octave: Octave) -> None:
    with contextlib.ExitStack() as stack:
        script, expected = [], {}
        for bits in WORD_BITS:
            spec = every_kind(bits)
            # One class for each width.
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


def test_signals_do_what_their_kind_access_and_place_allow(octave: Octave) -> None:
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
    # Behind the port there is plain memory.
    assert shown["taken"] == doubles(5, 5)
    assert shown["one"] == doubles(5)
    assert shown["all"] == doubles(11, 5, 3, 1)
    assert shown["large"] == words(2**64 - 2)
    assert shown["nothing sent"] == doubles(11)
    assert shown["sampled"] == words(*3 * [2**64 - 2])
    assert shown["about"] == f"° the 'angle' signed 32 {doubles(-5)}"


def test_the_guide_says_what_happens(octave: Octave) -> None:
    guide = (EXAMPLES.parent / "docs" / "how-to" / "matlab.md").read_text(encoding="utf-8")
    lines = [
        line
        for block in re.findall(r"^```matlab\n(.*?)^```$", guide, re.DOTALL | re.MULTILINE)
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


# Names, and the text


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


def test_identifiers_are_unique_and_those_that_can_stay() -> None:
    made = identifiers(["end", "end_", "_a", "x_a", 80 * "b", 63 * "b", 63 * "b" + "c"], ["x_a_"])
    assert made["end_"] == "end_"
    assert made["x_a"] == "x_a"
    assert made[63 * "b"] == 63 * "b"
    assert len(set(made.values())) == len(made)
    assert all(name.isidentifier() and len(name) <= 63 and name[0] != "_" for name in made.values())


def test_the_text_names_its_source_and_is_the_same_each_time() -> None:
    files, again = (generate("matlab", compile_file(EXAMPLES / "walker.ul")) for _ in range(2))
    assert files == again
    assert {file.name for file in files} >= {"walker.m", "+unity_link/Link.m", "+unity_link/Signal.m"}
    for file in files:
        first = file.text.splitlines()[0]
        assert first.startswith("% Generated by `unity-link generate matlab` from walker.ul, SHA-256 "), file.name
        assert max(map(len, file.text.splitlines())) <= 132, file.name
        # In MATLAB these are no char arrays.
        assert '"' not in file.text, file.name


def test_the_text_is_matlab_and_nothing_of_octave_alone(octave: Octave) -> None:
    """Octave itself tells where a file uses more than MATLAB has."""
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
