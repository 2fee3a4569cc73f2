"""The compiled gateware with the interface of the model: its bus, its time, and its compiler."""

from __future__ import annotations

import asyncio
import ctypes
import functools
import itertools
import os
import random
import select
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING

import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.makers import build_params
from unity_link.errors import ArgumentError, ConnectError
from unity_link.protocol.wire.crc import Crc
from unity_link.protocol.wire.messages import Codec, ErrorCode
from unity_link.virtual import AccessError, VirtualGateway
from unity_link.virtual.rtl import RtlGateway, archive, choose, compiling, configurations, library

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path
from support.compilers import needs_cxx

pytestmark = [pytest.mark.rtl, needs_cxx]
PERIODIC, ON_TRIGGER, PLAIN = 1, 2, 32


@pytest.fixture(scope="module")
def built() -> RtlGateway:
    return RtlGateway()


@pytest.fixture
def gateway(built: RtlGateway) -> RtlGateway:
    built.reset()
    for address in list(built.memory):
        del built.memory[address]
    return built


def rests(gateway: RtlGateway) -> bool:
    """Return true if the harness finds an idle gateway idle."""
    before = gateway.cycles
    gateway._run_until_quiet()
    return gateway.cycles - before < 200


def _checked(body: bytes) -> bytes:
    return body + Crc().text(body) + b"\n"


def test_memory_has_the_words_that_requests_read_and_write(gateway: RtlGateway) -> None:
    gateway.memory[0x0A] = 0x12
    assert gateway.receive(_checked(b"R0A"), 0.0) == _checked(b"R0A00000012")
    assert gateway.receive(_checked(b"W0B89ABCDEF"), 0.0) == _checked(b"W0B")
    assert dict(gateway.memory) == {0x0A: 0x12, 0x0B: 0x89ABCDEF}


def test_addresses_and_words_out_of_range_are_refused(gateway: RtlGateway) -> None:
    with pytest.raises(ArgumentError, match="address 0x100 does not fit in 8 bits"):
        gateway.memory[0x100] = 0
    with pytest.raises(ArgumentError, match="word 0x100000000 does not fit in 32 bits"):
        gateway.memory[0] = 1 << 32


class _Recorder:
    """A device that records its accesses, and raises `refusal` if it is set."""

    def __init__(self) -> None:
        self.calls: list[tuple[str, int, int]] = []
        self.refusal: BaseException | None = None

    def read(self, offset: int, now: float) -> int:
        assert now >= 0
        self._note("read", offset, 0)
        return -1 - offset

    def write(self, offset: int, value: int, now: float) -> None:
        assert now >= 0
        self._note("write", offset, value)

    def _note(self, kind: str, offset: int, value: int) -> None:
        self.calls.append((kind, offset, value))
        if self.refusal is not None:
            raise self.refusal


def test_a_device_answers_at_its_addresses(gateway: RtlGateway) -> None:
    device = _Recorder()
    gateway.attach(device, (0x20, 0x21))
    assert gateway.receive(b"R21\rW200000002A\r", 0.0) == b"R21FFFFFFFE\r\nW20\r\n"
    assert device.calls == [("read", 1, 0), ("write", 0, 42)]
    gateway.detach((0x20, 0x21))
    assert gateway.receive(b"R21\r", 0.0) == b"R2100000000\r\n"


@pytest.mark.parametrize(("code", "answer"), [(ErrorCode.BUS_ERROR, b"X04\r\n"), (ErrorCode.BUS_TIMEOUT, b"X05\r\n")])
def test_a_refusal_of_a_device_is_a_bus_error(gateway: RtlGateway, code: ErrorCode, answer: bytes) -> None:
    device = _Recorder()
    device.refusal = AccessError(code)
    gateway.attach(device, (0x20,))
    assert gateway.receive(b"R20\r", 0.0) == answer
    gateway.detach((0x20,))


def test_a_bug_in_a_device_is_a_bus_error_and_logged(gateway: RtlGateway, caplog: pytest.LogCaptureFixture) -> None:
    device = _Recorder()
    device.refusal = ZeroDivisionError("in the device")
    gateway.attach(device, (0x20,))
    assert gateway.receive(b"R20\r", 0.0) == b"X04\r\n"
    assert "ZeroDivisionError: in the device" in caplog.text
    with pytest.raises(ArgumentError, match="address 0x20 has a device"):
        gateway.attach(_Recorder(), (0x20,))
    device.refusal = KeyboardInterrupt()
    with pytest.raises(KeyboardInterrupt):
        gateway.receive(b"R20\r", 0.0)
    gateway.detach((0x20,))


def test_an_overflow_is_answered_by_error_09(gateway: RtlGateway) -> None:
    gateway.overflow()
    assert gateway.receive(2 * _checked(b"R0A"), 0.0) == _checked(b"X09") + _checked(b"R0A00000000")


def test_time_passes_while_no_group_runs(gateway: RtlGateway) -> None:
    gateway.receive(b"R0A\r", 1.0)
    assert gateway.next_due is None
    assert gateway.advance(3601.0) == b""
    assert gateway.cycles == pytest.approx(3600 * gateway.info.clock_hz, abs=200)


def test_skipped_time_has_the_effect_of_simulated_time() -> None:
    """Skipped time has the same effect as simulated time on every later byte and cycle: clock, base tick, bus."""
    skipping, running = RtlGateway(), RtlGateway()
    cycles = 123 * skipping.info.clock_hz * 1000 // skipping.info.base_frequency_millihertz
    seen = []
    for gateway in (skipping, running):
        sent = gateway.receive(b"GS00090002020A0B\rGP00\r", 0.0)
        if gateway is skipping:
            gateway._library.ul_skip(gateway._handle, cycles)
        else:
            gateway.run(cycles)
        sent += gateway.receive(b"GP00\rGN00\rW0A1\r", 0.0)
        sent += b"".join(gateway.run(100) for _ in range(50))
        seen.append((gateway.cycles, sent))
    assert seen[0] == seen[1]
    assert seen[0][1].count(b"P00") > 20


def test_a_gateway_whose_groups_were_stopped_is_idle(gateway: RtlGateway) -> None:
    gateway.receive(b"GS000100010108\rGN00\r", 0.0)
    assert gateway.next_due is not None
    gateway.receive(b"GX00\r", 0.001)
    assert gateway.next_due is None


def test_a_running_group_publishes_at_its_rate_until_a_new_session(gateway: RtlGateway) -> None:
    # Group 0 at a tenth of the base frequency of 10 kHz, one word, plain frames: a sample per millisecond.
    answers = gateway.receive(b"GS0021000A010A\rGN00\r", 5.0)
    assert answers.startswith(b"GS00\r\nGN00\r\n")
    due = gateway.next_due
    assert due is not None
    published = answers[12:] + b"".join(gateway.advance(5.0 + step / 1000) for step in range(1, 51))
    frames = published.split(b"\r\n")[:-1]
    assert len(frames) == pytest.approx(50, abs=1)
    assert [frame[:5] for frame in frames] == [b"P00%02X" % number for number in range(len(frames))]
    assert gateway.receive(b"K0000001\r", 5.06).endswith(b"K00000010000\r\n")
    assert gateway.next_due is None
    assert gateway.advance(6.0) == b""


@pytest.mark.slow
def test_samples_without_space_are_overruns(gateway: RtlGateway) -> None:
    gateway.receive(b"GS0021000A010A\rGN00\r", 0.0)
    for step in range(1, 400):
        assert gateway.advance(step / 100, room=0) == b""
    rest = b"".join(gateway.advance(4 + step / 100) for step in range(5))
    numbers = [int(frame[3:5], 16) for frame in rest.split(b"\r\n")[:-1]]
    # The samples in the FIFOs arrive first and without a gap; then the numbers of all lost samples are missing.
    assert len(numbers) < 2000
    assert any((later - earlier) % 256 > 1 for earlier, later in itertools.pairwise(numbers))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(20))
def test_requests_are_answered_during_any_edges_at_the_triggers(gateway: RtlGateway, seed: int) -> None:
    """Use each half period from the shortest on, on one trigger or all, with groups that use edges or do not."""
    draw = random.Random(seed)
    library, handle = gateway._library, gateway._handle
    for session in range(1, 21):
        flags = [draw.choice((PLAIN, PLAIN, PLAIN | ON_TRIGGER, PLAIN | PERIODIC)) for _ in range(16)]
        if draw.random() < 0.5:
            flags = [PLAIN | flag & PERIODIC for flag in flags]
        for group, flag in enumerate(flags):
            count = draw.choice((1, 2, 20))
            settings = f"GS{group:02X}{flag:02X}0028{count:02X}{'0A' * count}\rGN{group:02X}\r".encode()
            library.ul_push(handle, settings, len(settings))
        gateway.run(3000)
        half = draw.choice((2, 2, 3, 4, 5, 7, draw.randrange(8, 80)))
        library.ul_choose_trigger(handle, draw.choice((-1, draw.randrange(16))))
        heard = b""
        opening = b"K000%04X" % session
        for request in (b"H", b"GX%02X" % draw.randrange(16), b"GP00", b"GS05200001010B", b"R0A", opening):
            library.ul_push(handle, request + b"\r", len(request) + 1)
            said = b""
            for level in range(20_000 // half):
                library.ul_set_trigger(handle, level % 2)
                said += gateway.run(half)
                if b"\n" + request[:4] in b"\n" + said:
                    break
            else:
                raise AssertionError(f"{request!r} was not answered: flags {flags}, half period {half}")
            heard += said
        library.ul_set_trigger(handle, 0)
        heard += gateway.run(2000)
        published = {int(frame[1:3], 16) for frame in heard.split(b"\r\n") if frame.startswith(b"P")}
        assert published <= {group for group, flag in enumerate(flags) if flag & (PERIODIC | ON_TRIGGER)} | {0}


# Slow if it is the first test to compile the builds: it runs early then, and each process compiles others.
@pytest.mark.slow
@pytest.mark.parametrize("name", build_params(configurations()))
def test_every_configuration_is_that_of_its_file(name: str) -> None:
    gateway = RtlGateway(name)
    assert gateway.info == configurations()[name].info
    assert rests(gateway)


@pytest.mark.slow
def test_a_group_of_the_most_words_is_set_up_at_once() -> None:
    gateway = RtlGateway("ft232h")
    codec = Codec(gateway.info)
    request = codec.framing.checked(b"GS" + codec.fields("GS", 0, 0, 1, 255, range(255)))
    assert gateway.receive(request + codec.framing.checked(b"H"), 0.0) == b"".join(
        codec.framing.checked(answer) for answer in (b"GS00", b"H")
    )
    assert gateway.receive(request, 1.0) == codec.framing.checked(b"GS00")


def _requests(group_words: int) -> st.SearchStrategy[list[tuple[str, int, bool]]]:
    """Return lists of a command, its number of words, and true if the request is sent twice."""
    blocks = st.tuples(st.sampled_from(("rm", "rq", "wm", "wq", "wk")), st.integers(1, 255), st.booleans())
    groups = st.tuples(st.just("GS"), st.integers(1, group_words), st.just(value=False))
    return st.lists(blocks | groups, min_size=1, max_size=8)


@given(requests=_requests(32))
def test_each_answer_is_returned_at_once_after_a_silence_of_the_gateware(
    built: RtlGateway, requests: list[tuple[str, int, bool]]
) -> None:
    """The gateware fetches up to 255 words for an answer before it sends the first byte."""
    _answers_as_the_model(built, requests)


@pytest.mark.slow
@given(requests=_requests(255))
def test_answers_after_groups_of_up_to_255_words_are_returned_at_once(requests: list[tuple[str, int, bool]]) -> None:
    _answers_as_the_model(_largest(), [*requests, ("GS", 255, False), ("rq", 255, True)])


@functools.cache
def _largest() -> RtlGateway:
    return RtlGateway("ft232h")


def _answers_as_the_model(gateway: RtlGateway, requests: list[tuple[str, int, bool]]) -> None:
    gateway.reset()
    model = VirtualGateway(gateway.info)
    for address in range(256):
        gateway.memory[address] = model.memory[address] = 0x01010101 * address
    frames = [b"K0001234\r"]
    identifier = 0
    for command, words, again in requests:
        if command == "GS":
            frames.append(b"GS00000001%02X%s\r" % (words, b"0A" * words))
            continue
        head = b"%s%03X" % (command.encode(), identifier)
        fields = b"20FFFFFFFF%08X" if command == "wk" else b"10%02X"
        data = b"89ABCDEF" * words if command in ("wm", "wq") else b""
        frames += [head + fields % words + data + b"\r"] * (2 if again else 1)
        identifier += 1
    for instant, frame in enumerate(frames):
        assert gateway.receive(frame, instant / 10) == model.receive(frame, instant / 10), frame


def test_the_error_for_an_unknown_configuration_names_it() -> None:
    with pytest.raises(ArgumentError, match=r"no gateware .huge.: this installation has .*default"):
        RtlGateway("huge")


@pytest.mark.parametrize(
    ("fields", "node", "name"),
    [
        ({}, None, "default"),
        ({"data_bits": 32, "clock_hz": 500_000}, None, "default"),
        ({"data_bits": 64}, None, "wide"),
        ({"groups": 0}, None, "minimal"),
        ({"crc_bits": 32}, None, "crc_32"),
        ({"id_digits": 2}, None, "short"),
        ({"crc_bits": 8}, None, "short"),
        ({"crc_bits": 32, "id_digits": 2}, None, "short_ids"),
        ({"clock_hz": 50_000_000}, None, "ft232h"),
        ({}, 5, "node"),
    ],
)
def test_a_configuration_is_chosen_by_its_fields_and_else_the_default(
    fields: dict[str, int], node: int | None, name: str
) -> None:
    assert choose(fields, node).name == name


@pytest.mark.parametrize(
    ("fields", "node", "message"),
    [
        ({"data_bits": 16}, None, "with data_bits=16: there are data_bits=8, data_bits=9, data_bits=32, data_bits=64$"),
        ({"data_bits": 64, "id_digits": 2}, None, "data_bits=64&id_digits=2: there are .*, data_bits=64&id_digits=3$"),
        ({}, 6, "with node=6: there are node=5, no node$"),
    ],
)
def test_the_error_for_a_missing_build_lists_the_available_ones(
    fields: dict[str, int], node: int | None, message: str
) -> None:
    with pytest.raises(ArgumentError, match=message):
        choose(fields, node)


# The archive of all builds


def packed(folder: Path, names: tuple[str, ...] = ("default", "minimal")) -> dict[str, bytes]:
    """Put some builds into a folder; return their texts."""
    index, texts = archive.read_index(archive.GENERATED), archive.read_texts(archive.GENERATED)
    chosen = {name: texts[name] for name in names}
    archive.write(folder, {name: index[name] for name in names}, chosen)
    return chosen


@pytest.mark.slow
def test_the_archive_has_exactly_the_builds() -> None:
    texts = archive.read_texts(archive.GENERATED)
    assert {name: build.text() for name, build in configurations().items()} == texts
    assert all(b"UL_SIGNALS" in text for text in texts.values())


def test_a_change_of_all_builds_adds_little_to_the_history() -> None:
    assert sum(path.stat().st_size for path in archive.GENERATED.iterdir()) < 250_000


@pytest.mark.slow
def test_the_same_builds_make_the_same_archive(tmp_path: Path) -> None:
    for folder in ("a", "b"):
        assert packed(tmp_path / folder) == archive.read_texts(tmp_path / folder)
    files = [{path.name: path.read_bytes() for path in (tmp_path / folder).iterdir()} for folder in ("a", "b")]
    assert files[0] == files[1]
    assert len(files[0]) == 2


def test_a_missing_or_foreign_build_of_an_installation_is_reported(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    build = configurations()["minimal"]
    monkeypatch.setattr(archive, "GENERATED", tmp_path)
    missing = r"models.tar.xz does not hold the gateware 'minimal': install unity-link anew, or run make rtl"
    with pytest.raises(ArgumentError, match=missing):
        build.text()
    index = archive.read_index(archive.GENERATED) or {"minimal": archive.Entry("", "", "")}
    archive.write(tmp_path, index, {"minimal": b"// another\n"})
    with pytest.raises(ArgumentError, match=missing):
        build.text()


@pytest.mark.parametrize("damage", [lambda data: data[:5000], lambda data: b"no archive" + data], ids=["cut", "spoilt"])
def test_the_error_for_a_damaged_archive_names_it(
    damage: Callable[[bytes], bytes], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    packed(tmp_path)
    path = tmp_path / "models.tar.xz"
    path.write_bytes(damage(path.read_bytes()))
    build = configurations()["minimal"]
    monkeypatch.setattr(archive, "GENERATED", tmp_path)
    with pytest.raises(ArgumentError, match=r"models.tar.xz cannot be unpacked \(.*\): install unity-link anew"):
        build.text()


@pytest.mark.parametrize("text", ["{", '{"default": {"origin": "1"}}'])
def test_the_error_for_a_damaged_index_names_it(text: str, tmp_path: Path) -> None:
    (tmp_path / "models.json").write_text(text)
    with pytest.raises(ArgumentError, match=r"models.json is no index of the gateware \(.*\): install"):
        archive.read_index(tmp_path)


# The compiler and its cache


def fresh_load(name: str = "minimal") -> None:
    """Load a library as a new process does."""
    library.load.__wrapped__(configurations()[name])


@pytest.mark.parametrize("cxx", [None, ""])
def test_the_error_without_a_compiler_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, cxx: str | None
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CXX", raising=False)
    if cxx is not None:
        monkeypatch.setenv("CXX", cxx)
    with pytest.raises(ConnectError, match=r"no C\+\+ compiler is there: apt install g\+\+"):
        fresh_load()


def test_the_error_for_a_missing_compiler_names_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CXX", "ccc++ -m64")
    with pytest.raises(ConnectError, match=r"'ccc\+\+', is not there: unset CXX"):
        fresh_load()


def compiler(monkeypatch: pytest.MonkeyPatch, folder: Path, script: str) -> None:
    """Put a script in place of the C++ compiler."""
    path = folder / "c++"
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    monkeypatch.setenv("CXX", str(path))
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder / "cache"))


def test_a_failing_compiler_is_quoted_and_leaves_no_file(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    compiler(monkeypatch, tmp_path, "echo 'In file included from' >&2; echo 'x.cc:1: error: no <vector>' >&2; exit 1")
    with pytest.raises(ConnectError, match=r"could not be compiled by .*: x.cc:1: error: no <vector>$"):
        fresh_load()
    assert list((tmp_path / "cache" / "unity-link" / "rtl").iterdir()) == []


def test_the_output_of_a_compiler_is_cached(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    compiler(
        monkeypatch,
        tmp_path,
        f'[ "$1" = --version ] && exit; echo "$@" >> {tmp_path}/calls; for last; do :; done; echo no library > "$last"',
    )
    for _ in range(2):
        # The output is no library; the error shows the path where it is cached.
        with pytest.raises(ConnectError, match=r"cache/unity-link/rtl/minimal-.*\.so can't be loaded"):
            fresh_load()
    assert len((tmp_path / "calls").read_text().splitlines()) == 1


def test_the_error_for_an_unwritable_folder_names_it(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    folder = tmp_path / "unity-link"
    folder.mkdir()
    (folder / "rtl").symlink_to("/proc/self")
    for place in (tmp_path / "file", tmp_path):
        monkeypatch.setenv("XDG_CACHE_HOME", str(place))
        with pytest.raises(ConnectError, match=f"can't be kept in {place}/unity-link/rtl .*XDG_CACHE_HOME"):
            fresh_load()


@pytest.mark.asyncio
async def test_a_cancelled_compilation_ends_the_compiler_and_its_children(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    started, ended = tmp_path / "started", tmp_path / "ended"
    os.mkfifo(started)
    os.mkfifo(ended)
    # The inner process keeps a FIFO open until it ends.
    compiler(monkeypatch, tmp_path, f'[ "$1" = --version ] || sh -c "exec 3>{ended}; echo >{started}; sleep 1000"')
    task = asyncio.create_task(compiling.compile_beside(configurations()["minimal"]))
    watch = os.open(ended, os.O_RDONLY | os.O_NONBLOCK)
    await asyncio.to_thread(started.read_text)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    # The read would block if a process were left: the file ends when its last writer has ended.
    os.set_blocking(watch, True)
    assert await asyncio.wait_for(asyncio.to_thread(os.read, watch, 1), 60) == b""
    os.close(watch)
    assert list((tmp_path / "cache" / "unity-link" / "rtl").iterdir()) == []


@pytest.mark.parametrize("way", ["SIGTERM", "SIGKILL"])
def test_a_program_killed_by_a_signal_leaves_no_compiler(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, way: str
) -> None:
    started, ended = tmp_path / "started", tmp_path / "ended"
    os.mkfifo(started)
    os.mkfifo(ended)
    compiler(monkeypatch, tmp_path, f'[ "$1" = --version ] || sh -c "exec 3>{ended}; echo >{started}; sleep 1000"')
    watch = os.open(ended, os.O_RDONLY | os.O_NONBLOCK)
    text = (
        "from unity_link.virtual.rtl import compiling, configurations\ncompiling.compiled(configurations()['minimal'])"
    )
    with subprocess.Popen([sys.executable, "-c", text], stderr=subprocess.DEVNULL) as program:
        started.read_text()
        program.send_signal(signal.Signals[way])
        assert program.wait() != 0
    # A time-out, in case a process is left.
    ready, _, _ = select.select([watch], [], [], 60)
    assert ready
    assert os.read(watch, 1) == b""
    os.close(watch)


def test_two_programs_may_compile_at_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    # Each compiler waits for the other, and compiles only a library with one name instead of the gateware.
    script = f"""[ "$1" = --version ] && exit
    mkdir {tmp_path}/first 2>/dev/null || touch {tmp_path}/second
    until [ -e {tmp_path}/second ]; do sleep 0.01; done
    while [ "$1" != -o ]; do shift; done
    echo 'int ul_create;' | cc -shared -fPIC -x c - -o "$2"
    """
    compiler(monkeypatch, tmp_path, script)
    with ThreadPoolExecutor(2) as threads:
        for path in threads.map(compiling.compiled, [configurations()["minimal"]] * 2):
            assert ctypes.CDLL(str(path)).ul_create is not None
    assert len(list((tmp_path / "cache" / "unity-link" / "rtl").iterdir())) == 1
