"""Recorded frames of a host, replayed into the compiled gateware: equal answers, equal samples, and a waveform."""

from __future__ import annotations

import asyncio
import itertools
import json
import random
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support import makers
from support.simulated_time import run_simulated
from support.waveform import Waveform, bytes_at_pins
from unity_link.capture import pcapng
from unity_link.capture.pcapng import Packet
from unity_link.errors import ArgumentError, GatewayError
from unity_link.protocol.wire.compact import END, ESCAPE, START, CompactForm, Packer
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.messages import Codec, ErrorCode
from unity_link.transport.snoop import read
from unity_link.virtual import AccessError, VirtualGateway
from unity_link.virtual.rtl import choose
from unity_link.virtual.rtl.retrace import Report, Retrace, fitting
from unity_link.virtual.rtl.snooped import Snooped, read_snooped

if TYPE_CHECKING:
    from collections.abc import Callable, Coroutine
from support.compilers import needs_cxx

pytestmark = [pytest.mark.rtl, needs_cxx]
PROGRAM = str(Path(sys.executable).parent / "unity-link")
SLOW = choose({"clock_hz": 50_000}).info
MODEL = "&".join(
    f"{name}={int(getattr(SLOW, name))}"
    for name in ("clock_hz", "base_frequency_millihertz", "groups", "group_words", "features")
)
URLS = {"model": f"sim:scara?{MODEL}", "gateware": "rtl:scara?clock_hz=50000"}
CYCLE_NS = 20_000


@pytest.fixture(params=URLS)
def url(request: pytest.FixtureRequest) -> str:
    return URLS[request.param]


def snoop_of(url: str, path: Path, use: Callable[[unity_link.Link], Coroutine[Any, Any, None]]) -> Path:
    """Record a snoop of a program, on simulated time."""

    async def run() -> None:
        async with unity_link.connect(f"{url}&snoop={path}") as link:
            await use(link)

    run_simulated(run())
    return path


def snooped(path: Path, connection: int | None = None, end: float | None = None) -> Snooped:
    damage: list[str] = []
    found = read_snooped(read(path, damage.append), connection, end)
    assert damage == []
    return found


def retraced(path: Path) -> Report:
    recorded = snooped(path)
    return Retrace(recorded, fitting(recorded)).play()


def checked(body: bytes) -> bytes:
    return body + Crc().text(body) + b"\n"


def sent(body: bytes) -> bytes:
    """Return a request of `SESSION`."""
    return body + Crc().text(body, seed_of(1, from_gateway=False)) + b"\n"


def told(body: bytes) -> bytes:
    """Return a frame of the gateway in `SESSION`."""
    return body + Crc().text(body, seed_of(1, from_gateway=True)) + b"\n"


def written(path: Path, *packets: tuple[float, bool, bytes], name: str = "hand") -> Path:
    """Write a snoop of packets: seconds, true if sent by the host, bytes."""
    blocks = [pcapng.packet(Packet(0, round(time * 1e9), sent, data)) for time, sent, data in packets]
    path.write_bytes(pcapng.section() + pcapng.interface(name) + b"".join(blocks))
    return path


QUESTION = [(1.0, True, b"\nQ\r"), (1.1, False, b"Q" + SLOW.to_hex() + b"\r\n"), (1.2, True, checked(b"K0000001"))]
SESSION = [*QUESTION, (1.25, False, checked(b"K00000010000"))]


async def a_minute_without_groups(link: unity_link.Link) -> None:
    loop, chance, count = asyncio.get_running_loop(), random.Random(1), 0
    end = loop.time() + 60
    while loop.time() < end:
        await asyncio.sleep(chance.expovariate(5))
        count += 1
        match chance.randrange(8):
            case 0:
                await link.write(0x94, count)
            case 1:
                await asyncio.gather(*(link.read(address) for address in range(0x80, 0x90)))
            case 2:
                await link.read_block(0x80, 8)
            case 3:
                await link.post_many([0x95, 0x20], [count, count])
            case 4:
                await link.write_masked(0x20, count & 0xFF, 0xFF)
            case 5:
                await link.write_block(0x30, [count] * 5)
            case 6:
                await link.read_queue(0x30, 3)
            case 7:
                await link.send_immediate("adaptive")


async def a_second_with_groups(link: unity_link.Link) -> None:
    loop, chance, count = asyncio.get_running_loop(), random.Random(2), 0
    end = loop.time() + 1
    async with (
        link.subscribe([0x88, 0x89], rate_hz=200),
        link.subscribe([0x88, 0x8A, 0x20], rate_hz=50, on_change=True),
        link.subscribe([0x20], rate_hz=100, timestamps=False),
    ):
        while loop.time() < end:
            await asyncio.sleep(chance.expovariate(100))
            count += 1
            await link.write(0x94, 100 * count)
            if count % 3:
                await link.write(0x20, count)
            await link.read_many([0x88, 0x89, 0x20])


@pytest.mark.slow
def test_a_minute_without_groups_has_equal_answers_byte_for_byte(url: str, tmp_path: Path) -> None:
    path = snoop_of(url, tmp_path / "a.snoop", a_minute_without_groups)
    recorded = snooped(path)
    report = retraced(path)
    assert (report.first, report.differences, report.unknown) == (None, 0, 0)
    assert report.answers == sum(step.owes for step in recorded.steps) > 500
    assert report.seconds == pytest.approx(60, abs=2)


def test_a_second_with_groups_has_equal_samples_in_each_group(url: str, tmp_path: Path) -> None:
    path = snoop_of(url, tmp_path / "a.snoop", a_second_with_groups)
    recorded = snooped(path)
    report = retraced(path)
    assert (report.first, report.differences, report.unknown) == (None, 0, 0)
    counts = [sum(len(settings.samples) for settings in group) for group in recorded.groups.values()]
    assert len(counts) == 3
    assert min(counts) > 20
    assert report.samples == sum(counts)
    assert report.answers > 100


def waveform_of(path: Path, vcd: Path) -> Waveform:
    """Return the waveform of a whole snoop."""
    recorded = snooped(path)
    gateway = Retrace(recorded, fitting(recorded))
    assert gateway.play_into(vcd, 0.0, 100.0).differences == 0
    return Waveform(vcd)


@pytest.mark.slow
def test_a_waveform_shows_the_inner_signals(tmp_path: Path) -> None:
    path = snoop_of(URLS["model"], tmp_path / "a.snoop", a_second_with_groups)
    waveform, recorded = waveform_of(path, tmp_path / "a.vcd"), snooped(path)
    assert waveform.timescale == ["1 ns"]
    core = "unity_link_inst.core_inst"
    for name, bits in [
        ("request_executor_inst.r", 121),
        ("bus_master_inst.for_sample", 1),
        ("with_groups_subscription_manager_inst.running", 4),
        ("with_groups_subscription_manager_inst.own_sequence", 8),
    ]:
        assert waveform.signals[f"unity_link_fifo.{core}.{name}"][1] == bits
    *_, (_, (registers,)) = waveform.cycles(f"{core}.request_executor_inst.r")
    # The first fields of the record: four bits of state, two bits for a session and a program's session, the session's
    # number, and the next ID.
    last_id = max(step.request.id for step in recorded.steps if step.request and step.request.id is not None)
    assert (registers & 0xF, registers >> 4 & 3, registers >> 6 & 0xFFFF) == (0, 3, 1)
    assert registers >> 22 & 0xFFF == last_id + 1
    running = {groups for _, (groups,) in waveform.cycles(f"{core}.with_groups_subscription_manager_inst.running")}
    assert {0, 0b1, 0b11, 0b111} <= running


@pytest.mark.slow
def test_all_bytes_pass_the_pins_of_a_waveform_in_order(tmp_path: Path) -> None:
    path = snoop_of(URLS["model"], tmp_path / "a.snoop", a_second_with_groups)
    waveform, recorded = waveform_of(path, tmp_path / "a.vcd"), snooped(path)
    heard = bytes(one.byte for one in bytes_at_pins(waveform, "in"))
    assert heard == b"".join(step.frame for step in recorded.steps)
    said = bytes(one.byte for one in bytes_at_pins(waveform, "out")).splitlines(keepends=True)
    answers = b"".join(step.answer for step in recorded.steps if step.answer)
    assert b"".join(frame for frame in said if not frame.startswith(b"P")) == answers


@pytest.mark.slow
def test_a_request_is_found_in_the_waveform_by_its_time(tmp_path: Path) -> None:
    path = snoop_of(URLS["gateware"], tmp_path / "a.snoop", a_minute_without_groups)
    waveform, recorded = waveform_of(path, tmp_path / "a.vcd"), snooped(path)
    taken = bytes_at_pins(waveform, "in")
    heard = bytes(one.byte for one in taken)
    lone = [
        step
        for before, step in itertools.pairwise(recorded.steps)
        # With this clock, 16 reads take more than 10 ms.
        if step.time - before.time > 50e6 and heard.count(step.frame) == 1
    ]
    assert len(lone) > 50
    for step in lone:
        assert step.time <= taken[heard.index(step.frame)].time <= step.time + 2 * CYCLE_NS


def test_a_waveform_has_only_the_given_time_without_idle_cycles(tmp_path: Path) -> None:
    path = snoop_of(URLS["gateware"], tmp_path / "a.snoop", a_minute_without_groups)
    vcd = tmp_path / "a.vcd"
    result = run("retrace", path, "--rtl", "--vcd", vcd, "--from", "20", "--to", "25")
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.endswith(" 0 samples compared, 0 of them differ\n")
    times = [time for time, _ in Waveform(vcd).cycles()]
    assert 20e9 <= times[0] < 21e9
    assert 24e9 < times[-1] <= 25e9
    assert len(times) < 5e9 / CYCLE_NS / 5
    steps = [step for step in snooped(path).steps if 20e9 <= step.time <= 25e9]
    assert bytes(one.byte for one in bytes_at_pins(Waveform(vcd), "in")) == b"".join(step.frame for step in steps)


@pytest.mark.parametrize("noise", ["loss=0.0005&seed=3", "flip=0.0005&seed=8", "loss=0.002&seed=2"])
def test_losses_and_damage_on_the_way_to_the_gateway_are_replayed(noise: str, tmp_path: Path) -> None:
    path = snoop_of(f"{URLS['model']}&{noise}", tmp_path / "a.snoop", a_second_with_groups)
    recorded = snooped(path)
    report = retraced(path)
    assert (report.first, report.differences) == (None, 0)
    assert recorded.astray > 0
    assert report.answers > 100
    assert report.samples > 200
    answers = [step.answer for step in recorded.steps if step.answer]
    assert any(answer.startswith((b"X01", b"n")) for answer in answers)


@pytest.mark.parametrize(
    ("packets", "answers"),
    [
        (
            # The answer to the first request is lost, and the words of the queue are returned again.
            [
                (2.0, True, sent(b"rq0000A02")),
                (2.1, True, sent(b"rq0000A02")),
                (2.2, False, told(b"rq000" + 16 * b"0")),
            ],
            3,
        ),
        (
            [
                (2.0, True, sent(b"w0000A00000001") + sent(b"w0010A00000002")),
                (2.1, False, checked(b"X01") + told(b"n000")),
                (2.2, True, sent(b"w0000A00000001") + sent(b"w0010A00000002")),
                (2.3, False, told(b"w000") + told(b"w001")),
            ],
            6,
        ),
        (
            [
                (2.0, True, sent(b"w0000A00000001") + sent(b"w0010A00000002") + sent(b"w0020A00000003")),
                (2.1, False, told(b"n000")),
                (2.2, True, sent(b"w0000A00000001") + sent(b"w0010A00000002")),
                (2.3, False, told(b"w000") + told(b"w001")),
            ],
            5,
        ),
    ],
    ids=["answered before", "damaged", "missed"],
)
def test_each_sign_of_loss_is_replayed(tmp_path: Path, packets: list[tuple[float, bool, bytes]], answers: int) -> None:
    report = retraced(written(tmp_path / "a.snoop", *SESSION, *packets))
    assert (report.first, report.differences, report.answers) == (None, 0, answers)


class Failing:
    """A device whose first address fails, and whose second address does not answer."""

    def read(self, offset: int, now: float) -> int:
        raise AccessError((ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT)[offset])

    def write(self, offset: int, value: int, now: float) -> None:
        raise AccessError((ErrorCode.BUS_ERROR, ErrorCode.BUS_TIMEOUT)[offset])


def test_errors_of_the_bus_and_refusals_are_replayed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.snoop"
    monkeypatch.setenv("UNITY_LINK_SNOOP", str(path))

    async def use() -> None:
        gateway = VirtualGateway(SLOW)
        gateway.attach(Failing(), (0x40, 0x41))
        async with unity_link.connect(gateway) as link:
            calls = [
                link.read(0x40),
                link.read(0x41),
                link.write(0x40, 1),
                link.write_masked(0x41, 1, 1),
                link.read_block(0x3E, 4),
                link.write_block(0x3F, [1, 2, 3]),
                link.read_queue(0x41, 2),
            ]
            for call in calls:
                with pytest.raises(GatewayError):
                    await call
            assert await link.read(0x3F) == 1
            await link.post(0x40, 7)
            with pytest.raises(GatewayError):
                await link.fence()

    run_simulated(use())
    report = retraced(path)
    assert (report.first, report.differences, report.unknown) == (None, 0, 0)
    assert report.answers == 3 + 7 + 1 + 1 + 1


def test_connections_of_one_gateway_are_replayed_in_order(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.snoop"
    monkeypatch.setattr("unity_link.link.connection.choose_seed", itertools.count().__next__)
    monkeypatch.setenv("UNITY_LINK_SNOOP", str(path))

    async def use() -> None:
        gateway = VirtualGateway(SLOW)
        for _ in range(2):
            async with unity_link.connect(gateway) as link:
                await a_second_with_groups(link)

    run_simulated(use())
    assert retraced(path).differences == 0
    assert len([step for step in snooped(path).steps if step.frame == b"\nQ\r"]) == 2


def test_a_node_on_a_shared_medium_is_replayed_into_a_node_of_its_number(tmp_path: Path) -> None:
    async def use(link: unity_link.Link) -> None:
        await link.write(1, 7)
        assert await link.read(1) == 7

    node = choose({}, 5).info
    url = f"sim:?node=5&groups={node.groups}&group_words={node.group_words}"
    recorded = snooped(snoop_of(url, tmp_path / "a.snoop", use))
    assert (recorded.node, fitting(recorded).name) == (5, "node")
    assert all(step.answer is not None and step.answer.startswith(b"Z05") for step in recorded.steps)


WRITE, SAMPLE = sent(b"w0000A00000001").decode().strip(), told(b"P030100000007").decode().strip()
WRITTEN, REFUSED = told(b"w000").decode().strip(), told(b"x00006").decode().strip()


@pytest.mark.parametrize(
    ("packets", "words"),
    [
        (
            [(2.5, True, sent(b"w0000A00000001")), (2.6, False, told(b"x00006"))],
            f"first difference at 1.500000 s, to {WRITE}: {REFUSED} was recorded, {WRITTEN} comes",
        ),
        (
            [(2.5, True, sent(b"r0000A")), (2.6, False, told(b"r00000000001") + told(b"h001000"))],
            "",
        ),
        (
            [
                (2.0, True, sent(b"gs00003000001010A")),
                (2.1, False, told(b"gs000")),
                (2.2, True, sent(b"gp00103")),
                (2.3, False, told(b"P030100000007") + told(b"gp001")),
            ],
            f"first difference at 1.300000 s, a sample: {SAMPLE} was recorded, nothing comes",
        ),
    ],
    ids=["answer", "stray", "sample"],
)
def test_the_first_difference_is_reported_with_its_time_and_frame(
    tmp_path: Path, packets: list[tuple[float, bool, bytes]], words: str
) -> None:
    result = run("retrace", written(tmp_path / "a.snoop", *SESSION, *packets), "--rtl")
    assert result.returncode == (1 if words else 0)
    assert result.stderr.replace("error: ", "").startswith(words)


def test_a_lost_answer_is_not_compared(tmp_path: Path) -> None:
    path = written(
        tmp_path / "a.snoop",
        *SESSION,
        (2.0, True, sent(b"w0000A00000001") + sent(b"r0010A")),
        (2.1, False, told(b"r00100000001")),
    )
    report = retraced(path)
    assert (report.differences, report.unknown, report.answers) == (0, 1, 3)


def run(*arguments: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=300)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["good", "--to", "1", "--from", "2"], "--to 1 is not after --from 2"),
        (["good", "--rtl", "--to", "1", "--from", "2"], "--to 1 is not after --from 2"),
        (["good", "--rtl", "--connection", "7"], "there is no connection 7: the file has 0"),
        (["good", "--rtl", "--vcd", "missing/a.vcd"], "missing/a.vcd can't be made (No such file or directory)"),
        (["missing", "--rtl"], "missing cannot be read: No such file or directory"),
        (["silent", "--rtl"], "the snoop has no answer to Q, so it is not known which gateway it is of"),
        (["empty", "--rtl"], "the snoop has no answer to Q, so it is not known which gateway it is of"),
        (["wide", "--rtl"], "no gateware was compiled with the widths of the recorded gateway: data_bits=48, "),
        (["two", "--rtl"], "the file has connections to hand, other: choose one by --connection "),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_of_retrace_causes_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], words: str
) -> None:
    monkeypatch.chdir(tmp_path)
    good = written(tmp_path / "good", *SESSION).read_bytes()
    written(tmp_path / "silent", *SESSION[:1])
    written(tmp_path / "empty")
    wide = GatewayInfo(data_bits=48).to_hex()
    written(tmp_path / "wide", (1.0, True, b"\nQ\r"), (1.1, False, b"Q" + wide + b"\r\n"))
    (tmp_path / "two").write_bytes(good + written(tmp_path / "other", *SESSION, name="other").read_bytes())
    result = run("retrace", *arguments)
    # A missing file is a failure, as for `check` and `export`.
    assert result.returncode == (1 if "cannot be read" in words else 2)
    assert result.stdout == ""
    assert result.stderr.startswith(f"error: {words}")
    assert len(result.stderr.splitlines()) == 1


@pytest.mark.slow
def test_the_error_for_a_full_disk_is_one_sentence(tmp_path: Path) -> None:
    path = snoop_of(URLS["model"], tmp_path / "a.snoop", a_second_with_groups)
    result = run("retrace", path, "--rtl", "--vcd", "/dev/full")
    assert (result.returncode, result.stderr) == (
        1,
        "error: /dev/full could not be written (No space left on device)\n",
    )


def test_the_complete_records_of_a_cut_file_are_replayed(tmp_path: Path) -> None:
    path = written(tmp_path / "a.snoop", *SESSION, (2.0, True, sent(b"r0000A")), (2.1, False, told(b"r00000000009")))
    path.write_bytes(path.read_bytes()[:-3])
    result = run("retrace", path, "--rtl")
    assert result.returncode == 1
    assert "2 answers and 0 samples compared, 0 of them differ; 1 answers were not recorded" in result.stdout
    assert "it is cut at byte" in result.stderr


def test_a_gateway_with_other_limits_is_replayed_into_the_most_similar_build(
    tmp_path: Path,
) -> None:
    async def use(link: unity_link.Link) -> None:
        await link.write(1, 7)
        await link.read(1)

    path = snoop_of(f"sim:?{MODEL}&build_id=7", tmp_path / "a.snoop", use)
    result = run("retrace", path, "--rtl", "--connection", 0)
    assert result.returncode == 0
    assert result.stderr == "played into 'slow', which differs from the recorded gateway in build_id\n"
    assert " 5 answers" in result.stdout


def test_the_last_bytes_of_explain_and_retrace_have_the_same_time(tmp_path: Path) -> None:
    path = snoop_of(URLS["model"], tmp_path / "a.snoop", a_second_with_groups)
    lines = [json.loads(line) for line in run("explain", path, "--json").stdout.splitlines()]
    sent = [line["time"] for line in lines if line.get("direction") == "sent"]
    assert sent == [step.time / 1e9 for step in snooped(path).steps]


def test_no_gateway_is_chosen_if_the_widths_differ() -> None:
    with pytest.raises(ArgumentError, match="id_digits=2, crc_bits=16"):
        fitting(Snooped(GatewayInfo(id_digits=2), None, [], {}, 0.0, 0))


def test_requests_beside_a_silent_group_are_found_by_their_time(tmp_path: Path) -> None:
    async def use(link: unity_link.Link) -> None:
        async with link.subscribe([0x20], rate_hz=100, on_change=True):
            for number in range(20):
                await asyncio.sleep(0.05)
                await link.write(0x30, number)

    path = snoop_of(URLS["gateware"].replace("scara", ""), tmp_path / "a.snoop", use)
    waveform, recorded = waveform_of(path, tmp_path / "a.vcd"), snooped(path)
    taken = bytes_at_pins(waveform, "in")
    heard = bytes(one.byte for one in taken)
    writes = [step for step in recorded.steps if step.request and step.request.command == "W"]
    assert len(writes) == 20
    for step in writes:
        assert step.time <= taken[heard.index(step.frame)].time <= step.time + 2 * CYCLE_NS


@pytest.mark.slow
def test_samples_at_the_slowest_rate_are_awaited(tmp_path: Path) -> None:
    async def use(link: unity_link.Link) -> None:
        async with link.subscribe([0x20], divisor=0xFFFF) as samples:
            await anext(samples)
            await anext(samples)

    report = retraced(snoop_of(URLS["model"], tmp_path / "a.snoop", use))
    assert (report.first, report.samples) == (None, 2)


COMPACT = choose({**makers.COMPACT}).info
"""A gateway with the compact form."""


def test_cut_frames_in_a_compact_session_have_equal_answers(tmp_path: Path) -> None:
    gateway, codec, packer = (
        VirtualGateway(COMPACT),
        Codec(COMPACT),
        Packer(CompactForm.of(COMPACT, from_gateway=False)),
    )
    text = [
        codec.request("W", number, codec.fields("W", 1, number), seed_of(1, from_gateway=False)) for number in range(9)
    ]
    whole = [packer.pack_one(frame) for frame in text]
    cuts = [b"\r", b"\n", START + END, ESCAPE + END, b"\r\n"]
    pieces = [b"\nQ\r", codec.framing.checked(codec.opening(0, 1 | COMPACT.asks_compact))]
    for number, cut in enumerate(cuts):
        pieces += [whole[number][:-1] + cut, whole[number]]
    pieces += [text[5][:-1] + END, text[5], END, START + b"\n", text[6][:9] + whole[6]]
    packets = []
    for number, piece in enumerate(pieces):
        packets += [(number + 1.0, True, piece), (number + 1.1, False, gateway.receive(piece, number + 1.0))]
    report = retraced(written(tmp_path / "a.snoop", *packets))
    assert (report.first, report.differences) == (None, 0)
    assert report.answers == 2 + len(cuts) * 2 + 6
    assert gateway.memory[1] == 6
