"""Listeners on a connection: the snoop and the log of frames; a connection without them has no listener."""

from __future__ import annotations

import logging
import os
import struct
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.simulated_time import on_simulated_time, run_simulated
from unity_link.bridges.serve import serve
from unity_link.capture import pcapng
from unity_link.errors import ArgumentError
from unity_link.protocol.wire.configuration import GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.transport import SNOOP_VARIABLE
from unity_link.transport.snoop import Connected, Disconnected, Passed, Snoop, read
from unity_link.transport.tap import Tap
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_tcp, serve_udp, serve_unix

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.link.link import Link


def events(path: Path) -> list[Connected | Passed | Disconnected]:
    """Return the events of a snoop, and assert that it is undamaged."""
    damage: list[str] = []
    found = list(read(path, damage.append))
    assert damage == []
    return found


def passed(path: Path, *, sent: bool, connection: int = 0) -> bytes:
    """Return the recorded bytes of one direction."""
    return b"".join(
        event.data
        for event in events(path)
        if isinstance(event, Passed) and event.sent == sent and event.connection == connection
    )


def checked(body: bytes, session: int = 1, *, from_gateway: bool = False) -> bytes:
    return body + Crc().text(body, seed_of(session, from_gateway=from_gateway) if body[:1].islower() else 0) + b"\n"


def answered(body: bytes) -> bytes:
    return checked(body, from_gateway=True)


def write_and_read(url: str) -> None:
    async def use() -> None:
        async with unity_link.connect(url) as link:
            await link.write(0x10, 42)
            assert await link.read(0x10) == 42

    run_simulated(use())


def test_a_snoop_has_all_bytes_of_both_directions_and_the_end(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    write_and_read(f"sim:?snoop={path}")
    first, *_, last = events(path)
    assert first == Connected(0, f"sim:?snoop={path}")
    assert isinstance(last, Disconnected)
    assert passed(path, sent=True).endswith(checked(b"K0000001") + checked(b"w000100000002A") + checked(b"r00110"))
    assert passed(path, sent=False).endswith(answered(b"K00000010000") + answered(b"w000") + answered(b"r0010000002A"))


@on_simulated_time
async def test_a_snoop_has_the_times_at_which_bytes_were_sent_and_received(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    async with unity_link.connect(f"sim:?bytes_per_second=1000&snoop={path}") as link:
        await link.read(0)
    packets = [event for event in events(path) if isinstance(event, Passed)]
    (asked,) = [event for event in packets if event.data.startswith(b"r000") and event.sent]
    (answer,) = [event for event in packets if event.data.startswith(b"r000") and not event.sent]
    # The answer has 17 bytes, at 1,000 bytes per second.
    assert answer.time_ns - asked.time_ns == pytest.approx(17_000_000, abs=1000)


def test_the_environment_variable_adds_a_snoop_to_a_url_without_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(SNOOP_VARIABLE, str(tmp_path / "all.snoop"))
    write_and_read("sim:")
    write_and_read(f"sim:?snoop={tmp_path / 'own.snoop'}")
    for name in ("all.snoop", "own.snoop"):
        assert checked(b"w000100000002A") in passed(tmp_path / name, sent=True)
        assert len([event for event in events(tmp_path / name) if isinstance(event, Connected)]) == 1


@on_simulated_time
async def test_links_that_name_one_file_share_it_and_are_distinguished(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    async with unity_link.connect(f"sim:?snoop={path}") as one, unity_link.connect(f"sim:?snoop={path}") as other:
        await one.write(1, 1)
        await other.write(2, 2)
    assert b"w0000100000001" in passed(path, sent=True, connection=0)
    assert b"w0000200000002" in passed(path, sent=True, connection=1)


@pytest.mark.asyncio
async def test_a_link_that_reconnects_appends_to_its_snoop(tmp_path: Path) -> None:
    path, gateway = tmp_path / "a.snoop", VirtualGateway(GatewayInfo())
    async with serve_unix(gateway, tmp_path / "gateway") as url:
        link = await unity_link.connect(f"{url}?snoop={path}", reconnect=unity_link.Reconnect(first_pause=0.001))
        await link.write(1, 1)
    async with serve_unix(gateway, tmp_path / "gateway"):
        assert await link.read(1) == 1
        await link.aclose()
    kinds = [type(event) for event in events(path) if not isinstance(event, Passed)]
    assert kinds == [Connected, Disconnected, Connected, Disconnected]
    assert checked(b"r00001", 2) in passed(path, sent=True, connection=1)


def test_a_file_that_was_moved_is_not_written_any_more(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    write_and_read(f"sim:?snoop={path}")
    before = path.rename(tmp_path / "b.snoop").read_bytes()
    write_and_read(f"sim:?snoop={path}")
    assert (tmp_path / "b.snoop").read_bytes() == before
    assert checked(b"w000100000002A") in passed(path, sent=True)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("", r"snoop= in sim:\?snoop= names no file"),
        ("missing/a.snoop", r"can't be made \(No such file or directory\)"),
        ("folder", r"can't be made \(Is a directory\)"),
        ("pipe", "can't be made|is no file"),
        ("text", "exists, and is no snoop to append to"),
    ],
)
def test_the_error_for_an_unwritable_snoop_is_one_sentence(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, words: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    (tmp_path / "text").write_text("dear diary")
    os.mkfifo(tmp_path / "pipe")
    opened: list[object] = []
    monkeypatch.setattr("unity_link.virtual.schemes.connect", opened.append)
    with pytest.raises(ArgumentError, match=words):
        write_and_read(f"sim:?snoop={name}")
    assert opened == []
    assert (tmp_path / "text").read_text() == "dear diary"


def test_a_snoop_file_is_written_by_one_program_at_a_time(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    write_and_read(f"sim:?snoop={path}")
    before = path.read_bytes()
    command = [sys.executable, "-m", "unity_link.cli", "read", f"sim:?snoop={path}", "0"]
    other = subprocess.run(
        [sys.executable, "-c", "from unity_link.cli import main; main()", *command[3:]],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (other.returncode, other.stderr.strip().replace("\n", " ")) == (
        2,
        f"error: another program writes the snoop {path}: choose another name",
    )
    assert path.read_bytes() == before


def test_an_incomplete_record_is_removed_before_more_is_appended(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    path = tmp_path / "a.snoop"
    write_and_read(f"sim:?snoop={path}")
    whole = path.read_bytes()
    other = tmp_path / "b.snoop"
    other.write_bytes(whole + whole[:21])
    write_and_read(f"sim:?snoop={other}")
    assert other.read_bytes().startswith(whole)
    assert len([event for event in events(other) if isinstance(event, Connected)]) == 2
    assert "the last record of the snoop" in caplog.text


def block(kind: int, body: bytes, order: str = "<") -> bytes:
    """Return a pcapng block as any program writes it."""
    length = struct.pack(f"{order}I", 12 + len(body))
    return struct.pack(f"{order}I", kind) + length + body + length


def foreign(order: str = "<") -> bytes:
    """Return a capture of another program."""
    section = block(0x0A0D0D0A, struct.pack(f"{order}IHHq", 0x1A2B3C4D, 1, 0, -1), order)
    return section + block(1, struct.pack(f"{order}HHI", 1, 0, 0), order) + block(6, bytes(80), order) * 100


OTHERS = {
    "big-endian": foreign(">"),
    "of Wireshark": foreign(),
    "of Wireshark, cut": foreign()[:-7],
    "a block too big": foreign()[:28] + struct.pack("<II", 0xBAD, 1 << 27) + bytes(4000),
    "a line end": b"\n",
    "the first bytes of any capture": pcapng.SECTION_START,
    "our first section, cut": pcapng.section()[:30],
    "of a later version": pcapng.section().replace(b"snoop 1", b"snoop 2"),
    "ours, then a text": pcapng.section() + b"and what I thought of it",
    "ours, then a block of another kind, cut": pcapng.section() + block(0xBAD, bytes(400))[:300],
    "ours, then a block too big": pcapng.section() + struct.pack("<II", 6, 1 << 27) + bytes(4000),
    "ours, then two lengths that differ": pcapng.section() + block(6, bytes(80))[:-1] + b"x" + block(6, bytes(8))[:-1],
}


@pytest.mark.parametrize("content", OTHERS.values(), ids=OTHERS)
def test_a_file_that_is_not_certainly_a_snoop_is_left_unchanged(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    path.write_bytes(content)

    with pytest.raises(
        ArgumentError, match=r"a\.snoop exists, and is no snoop to append to \(.*\): choose another name"
    ):
        write_and_read(f"sim:?snoop={path}")

    assert path.read_bytes() == content


@pytest.mark.parametrize("left", range(0, 96, 19))
def test_a_record_that_a_crash_left_incomplete_or_as_zeros_is_removed(left: int, tmp_path: Path) -> None:
    record = block(6, bytes(range(1, 89)))
    for rest in (record[:left], record[:left] + bytes(100 - left), record[:left] + bytes(5000)):
        path = tmp_path / f"{len(rest)}.snoop"
        path.write_bytes(pcapng.section() + rest)

        write_and_read(f"sim:?snoop={path}")

        assert path.read_bytes().startswith(pcapng.section() * 2)


def test_a_snoop_is_not_created_through_a_dangling_symbolic_link(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    path.symlink_to(tmp_path / "elsewhere")

    with pytest.raises(ArgumentError, match="is a link that leads nowhere"):
        write_and_read(f"sim:?snoop={path}")

    assert not path.exists()
    (tmp_path / "elsewhere").touch()
    write_and_read(f"sim:?snoop={path}")
    assert (path.is_symlink(), len(events(path)) > 0) == (True, True)


def test_snoops_that_another_program_merged_are_read(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    write_and_read(f"sim:?snoop={path}")
    expected = events(path)
    # The file as mergecap writes it: only the section header is its own.
    option = struct.pack("<HH", 4, 8) + b"Mergecap" + bytes(4)
    section = block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1) + option)
    path.write_bytes(path.read_bytes().replace(pcapng.section(), section))

    assert events(path) == expected

    path.write_bytes(path.read_bytes() + block(1, struct.pack("<HHI", 1, 0, 0)))
    said: list[str] = []
    assert list(read(path, said.append)) == expected
    assert "an interface that is no connection to a gateway" in said[0]


def test_a_full_disk_ends_the_snoop_but_not_the_link(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    path = tmp_path / "a.snoop"

    async def use() -> None:
        async with unity_link.connect(f"sim:?snoop={path}") as link:
            await link.write(1, 7)
            snoop = Snoop.at(str(path))
            assert snoop._file is not None
            full = os.open("/dev/full", os.O_WRONLY)
            os.dup2(full, snoop._file)
            os.close(full)
            assert await link.read(1) == 7

    run_simulated(use())
    assert f"the snoop {path} ends here: No space left on device" in caplog.text
    assert b"w000" in passed(path, sent=True)


@pytest.mark.asyncio
async def test_a_token_is_never_written(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    async with (
        serve_tcp(VirtualGateway(GatewayInfo())) as url,
        unity_link.connect(f"{url}?token=sesame&snoop={path}") as link,
    ):
        # The token precedes all frames; a gateway without tokens takes it for a damaged frame.
        await link.read(0)
    assert b"sesame" not in path.read_bytes()
    assert events(path)[0] == Connected(0, f"{url}?token=...&snoop={path}")
    assert b"X01" in passed(path, sent=False)


# The log of frames


@on_simulated_time
async def test_a_link_without_listeners_has_its_stream_as_protocol() -> None:
    link = await unity_link.connect(VirtualGateway(GatewayInfo()))
    assert _protocol_of(link) is link._flow.stream
    await link.aclose()


@on_simulated_time
async def test_the_log_level_when_a_link_connects_decides_if_frames_are_logged(
    caplog: pytest.LogCaptureFixture,
) -> None:
    caplog.set_level(logging.DEBUG, "unity_link.frames.samples")
    async with unity_link.connect(VirtualGateway(GatewayInfo())) as link:
        assert isinstance(_protocol_of(link), Tap)
        caplog.set_level(logging.DEBUG, "unity_link.frames.sent")
        await link.read(0x0A)
    assert [record.name for record in caplog.records if record.levelno == logging.DEBUG] == [
        "unity_link.frames.sent",
        "unity_link.frames.sent",
    ]


def _protocol_of(link: Link) -> object:
    stream = link._flow.stream
    assert stream is not None
    transport = stream._transport
    assert transport is not None
    return getattr(transport, "_tap", None) or transport.get_protocol()


@on_simulated_time
async def test_each_frame_is_logged_in_words_by_the_logger_of_its_direction(
    caplog: pytest.LogCaptureFixture,
) -> None:
    caplog.set_level(logging.DEBUG, "unity_link")
    gateway = VirtualGateway(GatewayInfo())
    async with unity_link.connect(gateway) as link:
        await link.write(0x0A, 42)
        async with link.subscribe([0x0A], rate_hz=100) as samples:
            await anext(aiter(samples))
    lines = [(record.name.removeprefix("unity_link."), record.getMessage()) for record in caplog.records]
    frames = [line for line in lines if line[0].startswith("frames.")]
    session = "session 0001 has begun, the next ID expected is 000"
    for expected in [
        ("frames.sent", "the given gateway > w0000A0000002AE020  write 0x0000002A (42) to 0x0A (ID 000)"),
        ("frames.received", "the given gateway < w000BC6B  write to 0x0A done (ID 000)"),
        ("frames.received", f"the given gateway < K000000100002941  {session}; no session ended"),
    ]:
        assert expected in frames
    assert any(
        name == "frames.samples" and "sample 0 of group 0" in text and "0x0A = 42" in text for name, text in frames
    )


@pytest.mark.asyncio
async def test_the_life_of_a_link_is_logged(caplog: pytest.LogCaptureFixture, tmp_path: Path) -> None:
    caplog.set_level(logging.INFO, "unity_link")
    gateway = VirtualGateway(GatewayInfo())
    async with serve_unix(gateway, tmp_path / "gateway") as url:
        link = await unity_link.connect(url, reconnect=unity_link.Reconnect(first_pause=0.001))
        gateway.reset()
        await link.read(1)
    async with serve_unix(gateway, tmp_path / "gateway"):
        await link.read(1)
        await link.aclose()
    said = [
        record.getMessage().removeprefix(f"{url}: ") for record in caplog.records if record.name == "unity_link.link"
    ]
    lost = [text for text in said if text.endswith("; connecting again")]
    assert len(lost) == 1
    assert [text for text in said if not text.startswith("not connected (")] == [
        "connected",
        "session 1 has begun",
        "the gateway was reset",
        "session 2 has begun",
        *lost,
        "connected",
        "session 3 has begun",
        "the link was closed",
    ]


@pytest.mark.asyncio
async def test_the_link_of_a_server_to_its_gateway_has_a_snoop(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    async with (
        serve(f"sim:?snoop={path}", unix=tmp_path / "shared") as server,
        unity_link.connect(server.urls[0]) as link,
    ):
        await link.write(0x10, 42)
    assert b"100000002A" in passed(path, sent=True)
    assert {event.name for event in events(path) if isinstance(event, Connected)} == {f"sim:?snoop={path}"}


@pytest.mark.asyncio
async def test_a_snoop_of_datagrams_has_the_frames_in_them(tmp_path: Path) -> None:
    path = tmp_path / "a.snoop"
    async with (
        serve_udp(VirtualGateway(GatewayInfo())) as url,
        unity_link.connect(f"{url}?snoop={path}") as link,
    ):
        await link.write(0x10, 42)
    # On a busy machine a request may be retransmitted.
    assert checked(b"w000100000002A") in passed(path, sent=True)
    assert answered(b"w000") in passed(path, sent=False)
