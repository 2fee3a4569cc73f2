"""`unity-link find`: boards on sockets of this machine, which answer as the gateware does."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

import pytest

import unity_link
from unity_link.protocol.wire.discovery import NOWHERE, Found, answer, asked

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence

PROGRAM = str(Path(sys.executable).parent / "unity-link")
LAMP = Found(bytes.fromhex("02554c000001"), NOWHERE, 0x1234ABCD, has_fingerprint=True, session_open=False, name="lamp")
CART = Found(bytes.fromhex("02554c000002"), NOWHERE, 7, has_fingerprint=False, session_open=True, name="cart")


def find(*arguments: str) -> subprocess.CompletedProcess[str]:
    result = subprocess.run(
        [PROGRAM, "find", *arguments],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        stdin=subprocess.DEVNULL,
    )
    assert "Traceback" not in result.stderr
    return result


@contextmanager
def boards(
    founds: Sequence[Found],
    *,
    heeds: bool = True,
    becomes: Mapping[Found, Found] = MappingProxyType({}),
    also: Found | None = None,
    address: str = "127.0.0.1",
) -> Iterator[int]:
    """Answer for several boards on one socket, as hubs show boards with the same address; yield the port.

    Args:
        founds: the answers of the boards.
        heeds: True if the boards accept a new address.
        becomes: the answers from the first question to a single board on, by the earlier ones.
        also: a board that also answers questions to another board, and no question to all boards.
        address: of the socket.
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind((address, 0))
        known = list(founds)
        over = threading.Event()

        def serve() -> None:
            while True:
                data, source = opened.recvfrom(2000)
                if over.is_set():
                    return
                if not data[2] & 1:
                    known[:] = [becomes.get(found, found) for found in known]
                    if also is not None:
                        opened.sendto(answer(also), source)
                for place, found in enumerate(known):
                    if asked(data, found.mac):
                        if heeds and data[2:8] == found.mac:
                            known[place] = found._replace(ip=data[8:12])
                        opened.sendto(answer(known[place]), source)

        thread = threading.Thread(target=serve)
        thread.start()
        try:
            yield opened.getsockname()[1]
        finally:
            over.set()
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as last:
                last.sendto(b"", opened.getsockname())
            thread.join()


def test_simulated_boards_are_listed_with_name_map_and_session() -> None:
    command = [PROGRAM, "simulate", "scara", "--udp", "0", "--set", "build_id=0x1234ABCD"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as board:
        assert board.stdout is not None
        url = board.stdout.readline().strip()
        port = url.rpartition(":")[2]
        try:
            shown = find("--port", port, "--wait", "0.4").stdout.split()
            assert shown[0] == url
            assert shown[2:] == ["scara", "build", "0x1234ABCD", "no", "session"]
            with unity_link.blocking.connect(url) as link:
                link.read(0x88)
                told = json.loads(find("127.0.0.1", "--port", port, "--wait", "0.4", "--json").stdout)
            assert told == {
                "url": url,
                "address": "127.0.0.1",
                "port": int(port),
                "mac": shown[1],
                "name": "scara",
                "build_id": 0x1234ABCD,
                "has_fingerprint": False,
                "session_open": True,
            }
            refused = find("127.0.0.1", "--port", port, "--assign", f"{shown[1]}=10.1.2.3", "--wait", "0.4")
            assert (refused.returncode, refused.stdout) == (1, "")
            assert refused.stderr == f"error: {shown[1]} (scara) has answered, but its address is still 127.0.0.1\n"
        finally:
            board.terminate()


def test_boards_with_one_address_are_distinguished_and_named() -> None:
    with boards([LAMP, CART]) as port:
        result = find("--port", str(port), "--wait", "0.4")
    assert result.returncode == 0
    assert result.stdout.splitlines() == [
        f"udp://127.0.0.1:{port}  02:55:4c:00:00:01  lamp  map 0x1234ABCD    no session",
        f"udp://127.0.0.1:{port}  02:55:4c:00:00:02  cart  build 0x00000007  session open",
    ]
    assert result.stderr == (
        "127.0.0.1 is the address of 02:55:4c:00:00:01 (lamp) and 02:55:4c:00:00:02 (cart): give each another one, by "
        "unity-link find --assign MAC=ADDRESS\n"
    )


@pytest.mark.parametrize("second", [LAMP, LAMP._replace(name="cart")], ids=["alike", "of another name"])
def test_two_boards_with_one_mac_are_reported_and_get_no_address(second: Found) -> None:
    with boards([LAMP, second]) as port:
        listed = find("--port", str(port), "--wait", "0.4")
        refused = find("--port", str(port), "--wait", "0.4", "--assign", "02:55:4c:00:00:01=10.1.2.3")
    words = "two boards have the MAC address 02:55:4c:00:00:01: build one of them with another\n"
    assert (listed.returncode, listed.stderr) == (0, words)
    assert (refused.returncode, refused.stdout, refused.stderr) == (1, "", f"error: {words}")


def test_a_board_is_given_an_address_and_shown_with_it() -> None:
    with boards([LAMP, CART]) as port:
        result = find("--port", str(port), "--wait", "0.4", "--assign", "02-55-4C-00-00-02=10.1.2.3", "--json")
        taken = find("--port", str(port), "--wait", "0.4", "--assign", "02:55:4c:00:00:01=10.1.2.3")
        missing = find("--port", str(port), "--wait", "0.4", "--assign", "02:55:4c:00:00:09=10.1.2.4")
    assert json.loads(result.stdout)["url"] == f"udp://10.1.2.3:{port}"
    assert taken.stderr == "error: 10.1.2.3 is the address of 02:55:4c:00:00:02 (cart) already: give another one\n"
    assert missing.stderr == f"error: no board with the MAC address 02:55:4c:00:00:09 has answered at port {port}\n"


def test_name_of_a_board_has_no_control_sequences_and_no_line_ends() -> None:
    names = ["\x1b[2Jx\x07", "a\nudp://10.0.0", "b\r\nmap", "c\rmap", "d\tmap"]
    founds = [
        LAMP._replace(name=name, mac=bytes.fromhex(f"02554c0000{number:02x}")) for number, name in enumerate(names, 1)
    ]
    with boards(founds) as port:
        result = find("--port", str(port), "--wait", "0.4")
    assert "\x1b" not in result.stdout
    assert "\x07" not in result.stdout
    rows = result.stdout.splitlines()
    assert [row.split("  ")[2] for row in rows] == ["\ufffd[2Jx\ufffd", "a udp://10.0.0", "b map", "c map", "d map"]
    # A note about many boards with one address names only some of them.
    (note,) = result.stderr.splitlines()
    assert note.count(" and ") == 4
    assert "02:55:4c:00:00:04 (c map) and 1 more: give each another one" in note


@contextmanager
def echo(address: str, port: int = 0) -> Iterator[int]:
    """Send each datagram back, as the service `echo` does; yield the port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as opened:
        opened.bind((address, port))

        def serve() -> None:
            while (received := opened.recvfrom(2000))[0]:
                opened.sendto(*received)

        thread = threading.Thread(target=serve)
        thread.start()
        try:
            yield opened.getsockname()[1]
        finally:
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as last:
                last.sendto(b"", opened.getsockname())
            thread.join()


def test_an_echo_of_the_question_is_no_board() -> None:
    with echo("127.0.0.1") as port:
        listed = find("--port", str(port), "--wait", "0.2")
        assigned = find("--port", str(port), "--wait", "0.2", "--assign", "02:55:4c:00:00:01=10.1.2.3")
    assert listed.stderr.startswith(f"error: no board has answered at port {port}: ")
    assert assigned.stderr == f"error: no board with the MAC address 02:55:4c:00:00:01 has answered at port {port}\n"


@pytest.mark.parametrize("heeds", [True, False])
def test_an_address_that_another_board_has_taken_since_is_not_assigned(heeds: bool) -> None:
    later = CART._replace(ip=socket.inet_aton("10.1.2.3"))
    with boards([LAMP, CART], heeds=heeds, becomes={CART: later}) as port:
        result = find("--port", str(port), "--wait", "0.4", "--assign", "02:55:4c:00:00:01=10.1.2.3")
    words = "error: 10.1.2.3 is the address of 02:55:4c:00:00:02 (cart) already: give another one\n"
    assert (result.returncode, result.stdout, result.stderr) == (1, "", words)


def test_an_answer_of_another_board_does_not_show_that_an_address_was_taken() -> None:
    """Another board, which has the wanted address already, answers too; the asked board did not take the address."""
    intruder = CART._replace(ip=socket.inet_aton("10.1.2.3"))
    with boards([LAMP], heeds=False, also=intruder) as port:
        result = find("--port", str(port), "--wait", "0.4", "--assign", "02:55:4c:00:00:01=10.1.2.3")
    assert result.stderr == "error: 02:55:4c:00:00:01 (lamp) has answered, but its address is still 127.0.0.1\n"


def test_foreign_datagrams_are_no_boards() -> None:
    with boards([]) as port:
        result = find("--port", str(port), "--wait", "0.2")
    assert result.returncode == 1
    assert result.stderr.startswith(f"error: no board has answered at port {port}: is a board on the network, and ")


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["--assign", "02:55:4c:00:00:01"], 2, "MAC=ADDRESS was expected, such as 02:55:4c:00:00:01=192.168.1.101"),
        (["--assign", "02:55=10.0.0.1"], 2, "'02:55' is no MAC address, such as 02:55:4c:00:00:01"),
        (["--assign", "03:55:4c:00:00:01=10.0.0.1"], 2, "is the address of a group, not of one board"),
        (["--assign", "02:55:4c:00:00:01=10.0.0"], 2, "'10.0.0' is no IPv4 address"),
        (["--assign", "02:55:4c:00:00:01=224.0.0.1"], 2, "224.0.0.1 can't be the address of a board"),
        (["--assign", "02:55:4c:00:00:01=255.255.255.255"], 2, "255.255.255.255 can't be the address of a board"),
        (
            ["--assign", "02:55:4c:00:00:01=10.0.0.1", "--assign", "02:55:4c:00:00:02=10.0.0.1"],
            2,
            "each board and each address can be named once",
        ),
        (["--port", "0"], 2, "--port is '0': a whole number from 1 to 65535 was expected"),
        (["nosuch.invalid"], 1, "the question cannot be sent to port 21845: nosuch.invalid: "),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_ends_in_one_sentence(arguments: list[str], code: int, words: str) -> None:
    result = find(*arguments)
    assert (result.returncode, result.stdout) == (code, "")
    assert words in result.stderr
    assert result.stderr.count("\n") <= 2
