"""The link of the generated code for MATLAB, run by GNU Octave on real media: words, faults, samples."""

from __future__ import annotations

import asyncio
import contextlib
import random
import re
import signal
import socket
import threading
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from generate.octave import LONGEST_RUN, Octave, doubles, numbers, words
from generate.peers import (
    MEDIA,
    Fault,
    FaultyLine,
    Medium,
    ObservedGateway,
    answer,
    damage,
    lose,
    replace,
    serve,
    simulate,
)
from support.recorded_bus import RecordedBus
from support.spec_examples import FIGURE_1
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.frames import Framing
from unity_link.spec import compile_file, compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.faults import Noise, NoisyLine
from unity_link.virtual.serving import serve_tcp

if TYPE_CHECKING:
    from collections.abc import Iterator


EXAMPLES = Path(__file__).parents[2] / "examples"

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
    with simulate(medium, "--robot", "scara") as url:
        shown = octave.run(_WORDS.format(url=url))
    assert shown["read"] == doubles(42)
    assert shown["masked"] == doubles(42)
    assert shown["after masked"] == doubles(37)
    assert shown["block"] == doubles(1, 2, 0xFFFFFFFF)
    # MATLAB orders elements by columns.
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
    "short ids": ("id_digits=2",),
    "a crc of 8 bits": ("crc_bits=8",),
    "a crc of 32 bits": ("crc_bits=32", "address_bits=21", "data_bits=17"),
    "no flow control": ("features=0x6f", "receive_fifo_bytes=64"),
    "short blocks": ("block_words=3",),
    "words of 64 bits": ("data_bits=64",),
}


@pytest.mark.slow
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


def of_another_session(answer_to_k: bytes, _: int) -> bytes:
    """Return the answer to `K` for another session than the requested one."""
    return Framing(Crc()).checked(b"K%03X%b" % (int(answer_to_k[1:4], 16) ^ 1, answer_to_k[4:-5]))


def test_a_damaged_beginning_is_begun_again(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    replies = [replace("^Q", b"\xff\x80Q01\r\n"), damage("^Q.*[^\r]$"), lose("^K"), lose("^r")]
    replies.insert(3, Fault(re.compile("^K"), of_another_session))
    with simulate("tcp") as url, FaultyLine(url, "tcp", replies, [damage("^K")]) as line:
        shown = octave.run(f"link = unity_link.Link('{line.url}'); link.write(1, 3); show('read', link.read(1));")
        assert line.count("^Q") >= 4
        # Damaged, lost, for another session, and right.
        assert line.count("^K") >= 4
    assert shown == {"read": doubles(3)}


@contextlib.contextmanager
def hanging_up() -> Iterator[str]:
    """Yield the URL of a server that accepts one connection and ends it."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def hang_up() -> None:
            server.accept()[0].close()

        thread = threading.Thread(target=hang_up, daemon=True)
        thread.start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}"
        thread.join()


def test_unusable_urls_and_gateways_are_reported(octave: Octave) -> None:
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
    assert shown["node"].startswith("unity_link:argumentError 'node=255'")
    assert shown["nobody"].startswith("unity_link:connectError tcp://127.0.0.1:1 cannot be opened")
    assert shown["silent"].startswith("unity_link:connectError no gateway answered")
    assert shown["hung up"] == "unity_link:connectError the connection was lost before the gateway answered"
    assert shown["widths"].startswith("unity_link:unsupported the gateway has words of 16 bits")
    for label in ("groups", "masked", "queue"):
        assert shown[label].startswith("unity_link:unsupported the gateway was built without"), shown[label]


@pytest.mark.slow
def test_a_gateway_of_another_map_is_refused(octave: Octave) -> None:
    spec = compile_text(FIGURE_1)
    octave.generate(spec)
    fingerprint = spec.interface().fingerprint
    mapped = ("--set", f"features={int(GatewayInfo().features | Feature.FINGERPRINT)}", "--set")
    with (
        simulate("tcp", *mapped, f"build_id={fingerprint}") as right,
        simulate("tcp", *mapped, "build_id=0xCAFE") as wrong,
    ):
        shown = octave.run(f"""\
robot = scara('{right}');
show('right', robot.link.read(1));
attempt('wrong', @() scara('{wrong}'));
robot = scara('{wrong}?map=any');
show('any', robot.link.read(1));
attempt('no choice', @() scara('{wrong}?map=all'));
""")
    assert shown["right"] == shown["any"] == doubles(0)
    assert shown["no choice"].startswith("unity_link:argumentError 'map=all' is no option")
    told = f"the gateway was built for the map 0000CAFE, and the spec describes the map {fingerprint:08X}"
    assert shown["wrong"].startswith(f"unity_link:unsupported {told}")


# State in the MEX file

_HANDLES = """\
link = unity_link.Link('{url}');
other = unity_link.Link('{other}');
samples = link.subscribe(1, 'rate_hz', 100);
link.write(1, 5);
other.write(1, 6);
show('two', [link.read(1), other.read(1)]);
stranger = other.subscribe(1, 'rate_hz', 100);
show('samples', [samples.take(1).words < 6, stranger.take(1).words]);
attempt('a subscription as a link', @() unity_link_mex('read', samples.number, 1));
attempt('a link as a subscription', @() unity_link_mex('take', link.number, 1));
attempt('none', @() unity_link_mex('read', 1e9, 1));
attempt('no number', @() unity_link_mex('read', 'link', 1));
attempt('two numbers', @() unity_link_mex('read', [link.number, link.number], 1));
attempt('nothing', @() unity_link_mex('read', [], 1));
attempt('not a number', @() unity_link_mex('read', NaN, 1));
attempt('an object', @() unity_link_mex('read', link, 1));
attempt('a command', @() unity_link_mex('reed', link.number, 1));
attempt('no command', @() unity_link_mex());
attempt('few arguments', @() unity_link_mex('read', link.number));
attempt('a cell of words', @() link.write_block(1, {{1, 2}}));
attempt('complex', @() link.write(1, 1i));
attempt('a sparse address', @() link.read(sparse(1)));
attempt('a text', @() link.write_many(1:2, 'ab'));
number = link.number;
waiting = samples.number;
link.close();
attempt('closed', @() link.read(1));
attempt('closed take', @() samples.take(1000));
samples.close();
attempt('closed subscription', @() unity_link_mex('take', waiting, 1));
samples = other.subscribe(2, 'rate_hz', 100);
delete(other);
attempt('take without its link', @() samples.take(1000));
samples.close();
delete(link);
attempt('deleted', @() unity_link_mex('read', number, 1));
attempt('deleted twice', @() unity_link_mex('release', number));
"""


def test_invalid_link_or_subscription_numbers_fail_and_links_are_separate(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url, simulate("unix", str(octave.folder / "socket")) as other:
        shown = octave.run(_HANDLES.format(url=url, other=other))
    assert shown.pop("two") == doubles(5, 6)
    assert shown.pop("samples") == doubles(1, 6)
    assert shown.pop("closed") == "unity_link:linkLost the link was closed; the request is known not to be executed"
    for label in ("closed take", "take without its link"):
        assert shown.pop(label) == "unity_link:linkLost the link was closed"
    assert shown["a link as a subscription"].endswith("is not the number of a subscription")
    assert shown["deleted"].endswith("it was deleted, or never made")
    wrong = {label: text for label, text in shown.items() if not text.startswith("unity_link:argumentError ")}
    assert wrong == {}


@pytest.mark.slow
def test_unbuilt_package_names_the_build_call_that_makes_it_usable(bare_octave: Octave) -> None:
    bare_octave.generate(compile_text(FIGURE_1))
    link = bare_octave.folder / "+unity_link" / "Link.m"
    with simulate("tcp") as url:
        shown = bare_octave.run(f"""\
attempt('not built', @() scara('{url}'));
unity_link.build();
link = unity_link.Link('{url}');
show('read', link.read(1));
attempt('build with a link', @() unity_link.build());
show('still there', link.read(1));
clear link
unity_link.build();
""")
        link.write_text(re.sub(r"'open', '\w+'", "'open', 'new'", link.read_text(encoding="utf-8")), encoding="utf-8")
        shown |= bare_octave.run(f"attempt('generated anew', @() scara('{url}'));")
    assert shown == {
        "not built": "unity_link:notBuilt the package unity_link is not built yet: call unity_link.build() once",
        "read": doubles(0),
        "build with a link": (
            "unity_link:argumentError a link is open: clear all links and subscriptions before building anew"
        ),
        "still there": doubles(0),
        "generated anew": (
            "unity_link:notBuilt the package unity_link was generated anew since it was built: call unity_link.build()"
        ),
    }
    sources = {"unity_link.h", "unity_link.c", "unity_link_posix.c", "unity_link_mex.c"}
    assert {path.name for path in (bare_octave.folder / "+unity_link" / "source").iterdir()} == sources


def test_build_without_a_compiler_names_the_missing_tool(bare_octave: Octave) -> None:
    bare_octave.generate(compile_text(FIGURE_1))
    shown = bare_octave.run("attempt('build', @() unity_link.build());", {"CC": "/no/such/compiler"})
    assert shown["build"].startswith("unity_link:noCompiler the package unity_link could not be compiled (")
    assert "is a C compiler installed? Octave needs liboctave-dev beside it" in shown["build"]


_CLEARED = """\
link = unity_link.Link('{url}');
samples = link.subscribe(1, 'rate_hz', 100);
clear unity_link_mex
show('kept', samples.take(1).words);
show('locked', mislocked('unity_link_mex'));
clear all
printf('unlocked\\t%d\\n', ~mislocked('unity_link_mex'));
link = unity_link.Link('{url}');
link.post(1, 7);
samples = link.subscribe(1, 'rate_hz', 100);
printf('again\\t%d\\n', samples.take(1).words);
"""


def test_octave_ends_well_with_open_links_and_after_all_is_cleared(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with serve(VirtualGateway()) as url:
        shown = octave.run(_CLEARED.format(url=url))
    assert shown == {"kept": doubles(0), "locked": "logical 1", "unlocked": "1", "again": "7"}


@pytest.mark.slow
def test_ctrl_c_ends_a_take_and_the_link_stays_usable(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    script = """\
link = unity_link.Link('{url}');
samples = link.subscribe(1, 'rate_hz', 100);
unwind_protect
  show('began', samples.take(1).words);
  samples.take(1e6, 1000);
unwind_protect_cleanup
  link.write(1, 9);
  show('read', link.read(1));
  show('samples', samples.take(1000).words(end));
end_unwind_protect
"""
    with simulate("tcp") as url, octave.start(script.format(url=url)) as process:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("began")
        process.send_signal(signal.SIGINT)
        output, _ = process.communicate(timeout=LONGEST_RUN)
    assert output.splitlines() == [f"read\t{doubles(9)}", f"samples\t{doubles(9)}"]
    # The exit code of an interrupted script.
    assert process.returncode == 1


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
link.write_block(0, 1000:1255);
show('whole block', isequal(link.read_block(0, 256).', 1000:1255));
show('repetitions', link.statistics.repetitions > 0);
"""


def test_lost_and_damaged_frames_give_the_right_result_exactly_once(octave: Octave) -> None:
    octave.generate(
        compile_text("public robot() { @field = 15[3:0]: READWRITE(); @other = 15[7:4]: READWRITE(); }", name="r.ul")
    )
    replies = [lose("^w000"), lose("^r001"), lose("^wk004"), lose("^wk006"), lose("^h")]
    replies += [damage("^r...000000FF"), lose("^r...00000002"), lose("^rq")]
    requests = [lose("^w002"), damage("^wk003"), lose("^ws"), damage("^ws"), lose("^wq")]
    with simulate("tcp") as url, FaultyLine(url, "pty", replies, requests) as line:
        shown = octave.run(_LOST.format(url=line.url))
        sent = list(line.requests)
    assert shown["read"] == doubles(1)
    assert shown["masked"] == doubles(0)
    assert shown["masked, answer lost"] == "no error"
    assert shown["after masked"] == doubles(255)
    assert shown["field"] == doubles(3)
    assert shown["posted"] == doubles(20)
    assert shown["many"] == doubles(1, 2, 255, 20)
    assert shown["queue, answer lost"] == "no error"
    assert shown["whole block"] == "logical 1"
    assert shown["repetitions"] == "logical 1"
    for beginning in ("w000", "r001", "w002", "wk003", "wk004", "wk006"):
        assert sum(frame.startswith(beginning) for frame in sent) >= 2, beginning


def test_errors_of_the_gateway_have_their_identifiers(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    codes = {5: "busTimeout", 6: "outOfRange", 8: "gatewayError", 0x42: "gatewayError"}
    replies = [answer(f"^r{number:03X}", b"x%%b%02X" % code) for number, code in enumerate(codes)]
    replies.append(replace("^r004", Framing(Crc()).checked(b"X02"), times=3))
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


def random_writes(chance: random.Random, count: int) -> tuple[list[str], list[tuple[int, int]]]:
    """Return random lines of a script, and the writes that they make, in order."""
    lines, writes, words = [], [], dict.fromkeys(range(256), 0)
    for number in range(1, count + 1):
        address = chance.randrange(240)
        way = chance.choice(["write", "post", "post", "post", "masked", "block", "many"])
        made = [(address, number)]
        if way == "masked":
            mask = chance.getrandbits(32)
            made = [(address, words[address] & ~mask | number & mask)]
            lines.append(f"attempt('{number}', @() link.write_masked({address}, {number}, {mask}));")
        elif way in {"block", "many"}:
            made = [(address + part, number + part) for part in range(4)]
            where = address if way == "block" else f"{address} + (0:3)"
            lines.append(f"link.write_{way}({where}, {number} + (0:3));")
        else:
            lines.append(f"link.{way}({address}, {number});")
        writes += made
        words.update(made)
    return lines, writes


@pytest.mark.asyncio
async def test_every_write_over_a_noisy_line_is_executed_exactly_once_and_in_order(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    lines, writes = random_writes(random.Random(1), 200)
    # With a CRC of 8 bits, one damaged frame in 256 would pass.
    gateway = VirtualGateway(GatewayInfo(crc_bits=32, crc_polynomial=0x04C11DB7))
    bus = RecordedBus(gateway)
    chances = {"loss": 0.003, "flip": 0.003, "double": 0.002}
    async with serve_tcp(NoisyLine(gateway, Noise(1, **chances), Noise(2, **chances))) as url:
        script = [f"link = unity_link.Link('{url}', 30);", *lines, "link.fence();"]
        script.append("show('repetitions', link.statistics.repetitions > 0);")
        shown = await asyncio.to_thread(octave.run, "\n".join(script))
    assert bus.writes == writes
    assert shown.pop("repetitions") == "logical 1"
    assert all(text == "no error" for text in shown.values())


@pytest.mark.asyncio
async def test_one_of_several_gateways_on_a_medium_is_spoken_to_by_its_number(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    gateway = VirtualGateway(GatewayInfo(), node=5)
    gateway.memory[1] = 7
    async with serve_tcp(gateway) as url:
        shown = await asyncio.to_thread(
            octave.run,
            f"link = unity_link.Link('{url}?node=5'); link.post(2, 8); link.fence();"
            "show('words', link.read_many(1:2));"
            "samples = link.subscribe(2, 'rate_hz', 100); show('sample', samples.take(1).words);",
        )
    assert shown == {"words": doubles(7, 8), "sample": doubles(8)}


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


_RESET = """\
link = unity_link.Link('{url}');
link.write(10, 7);
samples = link.subscribe(10, 'rate_hz', 100);
show('sampled', samples.take(1).words);
link.write(254, 1);
show('silent', numel(samples.take(1000, 0.2).sequence) < 1000);
for number = 1:20
  attempt(sprintf('write %d', number), @() link.write(20, number));
end
link.close();
link = unity_link.Link('{url}');
link.write(20, 1);
show('read', link.read(10));
samples = link.subscribe(20, 'rate_hz', 100);
show('sampled again', samples.take(1).words);
link.write(254, 1);
link.post(30, 1);
attempt('fence', @() link.fence());
"""


class ResetButton:
    """Resets its gateway after the answer to a write to this device."""

    def __init__(self, gateway: ObservedGateway) -> None:
        self._gateway = gateway

    def read(self, offset: int, now: float) -> int:
        return 0

    def write(self, offset: int, value: int, now: float) -> None:
        self._gateway.reset_after = True


def gateway_with_reset_button() -> ObservedGateway:
    """Return a gateway that is reset by a write to address 254."""
    gateway = ObservedGateway()
    gateway.detach([254])
    gateway.attach(ResetButton(gateway), [254])
    return gateway


def test_gateway_reset_on_an_open_line_loses_the_link_and_a_new_link_works(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    gateway = gateway_with_reset_button()
    with serve(gateway) as url:
        shown = octave.run(_RESET.format(url=url))
    assert shown["sampled"] == shown["read"] == doubles(7)
    assert shown["silent"] == "logical 1"
    reset = "unity_link:linkLost the gateway was reset, which ends the link; the request is "
    # On a busy machine, writes are retransmitted before the answer arrives; those are perhaps executed.
    ends = {reset + "known not to be executed", reset + "perhaps executed"}
    assert {shown[f"write {number}"] for number in range(1, 21)} <= ends
    assert shown["sampled again"] == doubles(1)
    assert shown["fence"] == f"{reset}known not to be executed; posted writes that are known not to be executed: 1"
    assert gateway.bus_log.writes == [(10, 7), (20, 1)]
    assert len(set(gateway.sessions())) == 2


def test_a_program_that_only_takes_samples_learns_of_a_reset(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with serve(gateway_with_reset_button()) as url:
        shown = octave.run(f"""\
link = unity_link.Link('{url}');
samples = link.subscribe(10, 'rate_hz', 100);
link.write(254, 1);
attempt('take', @() samples.take(1e6, 30));
""")
    assert shown["take"].startswith("unity_link:linkLost the gateway was reset")


def test_write_retransmitted_to_a_reset_gateway_is_perhaps_executed(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    gateway = ObservedGateway()

    def lose_and_reset(_: bytes, __: int) -> bytes:
        gateway.reset()
        return b""

    faults = [Fault(re.compile("^w001"), lose_and_reset)]
    with serve(gateway) as url, FaultyLine(url, "tcp", faults) as line:
        shown = octave.run(f"""\
link = unity_link.Link('{line.url}');
link.write(10, 1);
attempt('write', @() link.write(10, 3));
""")
        assert line.count("^w001") >= 2
    lost = "unity_link:linkLost the gateway was reset, which ends the link; the request is perhaps executed"
    assert shown == {"write": lost}
    assert gateway.bus_log.writes == [(10, 1), (10, 3)]


@pytest.mark.slow
def test_a_gateway_that_falls_silent_is_a_lost_link_even_if_it_publishes(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with (
        simulate("tcp") as url,
        FaultyLine(url, "tcp", requests=[lose(lost, 10**6) for lost in ("^w", r"^K.{4}\s*$")]) as line,
    ):
        shown = octave.run(f"""\
link = unity_link.Link('{line.url}');
samples = link.subscribe(1, 'rate_hz', 100);
attempt('write', @() link.write(1, 1));
""")
        # The client retransmits fewer than 20 times in the five seconds until it gives up.
        assert line.count("^w") < 20
    assert shown["write"] == (
        "unity_link:linkLost the gateway does not answer any more: is it powered and connected, or does another "
        "program read its answers?; the request is perhaps executed"
    )


def test_posted_writes_are_confirmed_during_take_and_before_long_requests(
    octave: Octave,
) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp", "--set", "features=0x6f", "--set", "receive_fifo_bytes=64") as url:
        shown = octave.run(f"""\
link = unity_link.Link('{url}');
samples = link.subscribe(1, 'rate_hz', 100);
link.post(1, 5);
show('sampled', samples.take(30).words(end));
link.post(1, 6);
link.write_block(2, 1:6);
show('read', link.read(1));
show('time outs', link.statistics.timeouts);
""")
    assert shown == {"sampled": doubles(5), "read": doubles(6), "time outs": doubles(0)}


def test_half_duplex_medium_carries_one_answered_request_at_a_time(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    gateway = ObservedGateway(GatewayInfo(features=Feature(0x7F) | Feature.HALF_DUPLEX))
    with serve(gateway) as url:
        shown = octave.run(f"""\
link = unity_link.Link('{url}');
link.write_many(1:30, 1:30);
link.post(40, 5);
link.post(41, 6);
show('read', link.read_many([30 40 41]));
""")
    assert shown == {"read": doubles(30, 5, 6)}
    assert gateway.most_at_once == 1
    assert not [frame for frame in gateway.heard if frame.startswith("ws")]


def test_gateway_of_another_version_is_reported_with_a_remedy(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url, FaultyLine(url, "tcp", [replace("^Q", b"Q01200802\r\n", 99)]) as line:
        shown = octave.run(f"attempt('other', @() unity_link.Link('{line.url}'));")
        assert line.count("^Q") >= 3
    assert shown["other"] == (
        "unity_link:unsupported the gateway speaks version 01 of the protocol and this program version 03: build the "
        "gateway anew with this version of unity-link, or generate the client with one that speaks 01"
    )


@pytest.mark.parametrize(
    ("settings", "most"),
    [(("features=0x6f", "receive_fifo_bytes=64"), 5), ((), 128)],
    ids=["a small FIFO", "the window"],
)
def test_requests_in_flight_stay_within_the_gateways_limits(
    octave: Octave, settings: tuple[str, ...], most: int
) -> None:
    octave.generate(compile_text(FIGURE_1))
    options = [option for setting in settings for option in ("--set", setting)]
    with simulate("tcp", *options) as url, FaultyLine(url, "tcp", [lose("^r", times=most)]) as line:
        shown = octave.run(
            f"link = unity_link.Link('{line.url}'); show('words', sum(link.read_many(mod(0:2999, 256))));"
        )
        sent = [frame for frame in line.requests if frame.startswith("r")]
    assert shown["words"] == doubles(0)
    # The answers to the whole first burst are lost, so that the next request is the first one again.
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
def test_samples_of_groups_and_addresses_have_numbers_times_and_values(octave: Octave, medium: Medium) -> None:
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


def test_more_samples_than_the_buffer_holds_are_taken_part_by_part(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url:
        shown = octave.run(f"""\
link = unity_link.Link('{url}');
samples = link.subscribe([1 2], 'rate_hz', 500, 'buffer', 40);
data = samples.take(200);
show('sizes', [size(data.words), size(data.time), sum(data.lost)]);
show('sequence', isequal(data.sequence, (0:199).'));
show('none', numel(samples.take(0).sequence));
""")
    assert shown == {"sizes": doubles(200, 2, 200, 1, 0), "sequence": "logical 1", "none": doubles(0)}


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


def test_lost_answer_is_requested_again_while_samples_arrive(octave: Octave) -> None:
    octave.generate(compile_text(FIGURE_1))
    with simulate("tcp") as url, FaultyLine(url, "tcp", [lose("^r")]) as line:
        shown = octave.run(f"""\
link = unity_link.Link('{line.url}');
link.write(1, 5);
samples = link.subscribe(1, 'rate_hz', 5000);
show('read', link.read(1));
show('samples', mean(samples.take(10).words));
""")
        assert line.count("^r") >= 2
    assert shown == {"read": doubles(5), "samples": doubles(5)}
