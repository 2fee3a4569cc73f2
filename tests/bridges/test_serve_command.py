"""`unity-link serve` as processes: sockets, tokens, signals, systemd, and gateways and clients that are killed."""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import socket
import stat
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import unity_link
from support.bridge_programs import PROGRAM, wait_until
from unity_link import BusTimeoutError, ConnectError, GatewayResetError, blocking
from unity_link.bridges.serve.door import MOST_CLIENTS

if TYPE_CHECKING:
    from collections.abc import Iterator

ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in ("UNITY_LINK_TOKEN", "NOTIFY_SOCKET")}


def run(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    result = subprocess.run(
        [PROGRAM, *arguments],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        env={**ENVIRONMENT, **environment},
    )
    assert "Traceback" not in result.stderr
    return result


@contextmanager
def started(*arguments: str, **environment: str) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run a command that serves; yield the process, and the URL that it prints when it is ready."""
    with subprocess.Popen(
        [PROGRAM, *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**ENVIRONMENT, **environment},
    ) as process:
        assert process.stdout is not None
        try:
            yield process, process.stdout.readline().strip()
        finally:
            process.kill()


def free_port() -> int:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port: int = server.getsockname()[1]
        return port


# Sockets and access to them


def test_unix_socket_is_private_and_removed_at_the_end(tmp_path: Path) -> None:
    with started("serve", "sim:", XDG_RUNTIME_DIR=str(tmp_path)) as (process, url):
        place = tmp_path / "unity-link.sock"
        assert url == f"unix:{place}"
        assert stat.S_IMODE(place.stat().st_mode) == 0o600
        assert run("write", url, "5", "6").returncode == 0
        assert "6" in run("read", url, "5").stdout
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 130
        assert process.stderr is not None
        assert "Traceback" not in process.stderr.read()
        assert not place.exists()


@pytest.mark.slow
def test_served_socket_is_refused_and_a_stale_socket_is_replaced(tmp_path: Path) -> None:
    place = str(tmp_path / "socket")
    with started("serve", "sim:", "--unix", place) as (process, url):
        second = run("serve", "sim:", "--unix", place)
        assert second.returncode == 1
        assert "already served" in second.stderr
        assert run("read", url, "0").returncode == 0
        process.kill()
        process.wait(30)
    assert Path(place).is_socket()
    with started("serve", "sim:", "--unix", place) as (_, url):
        assert run("read", url, "0").returncode == 0


def test_socket_of_a_suspended_program_with_full_backlog_is_refused_at_once(tmp_path: Path) -> None:
    place = str(tmp_path / "socket")
    with socket.socket(socket.AF_UNIX) as still, contextlib.ExitStack() as stack:
        still.bind(place)
        still.listen(0)
        callers = [stack.enter_context(socket.socket(socket.AF_UNIX)) for _ in range(10)]
        for caller in callers:
            caller.setblocking(False)
        assert errno.EAGAIN in [caller.connect_ex(place) for caller in callers]
        result = run("serve", "sim:", "--unix", place)
    assert result.returncode == 1
    assert "served by another program, which accepts no connections" in " ".join(result.stderr.split())
    assert Path(place).is_socket()


def test_a_socket_of_another_kind_is_one_clear_error_and_stays(tmp_path: Path) -> None:
    place = str(tmp_path / "socket")
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as datagrams:
        datagrams.bind(place)
        result = run("serve", "sim:", "--unix", place)
    assert result.returncode == 1
    assert "choose another path" in " ".join(result.stderr.split())
    assert Path(place).is_socket()


def test_unix_socket_needs_a_path_without_a_runtime_directory() -> None:
    result = run("serve", "sim:", XDG_RUNTIME_DIR="")
    assert result.returncode == 2
    assert "--unix PATH" in result.stderr


def test_tcp_listens_on_this_machine_alone(tmp_path: Path) -> None:
    with started("serve", "sim:", "--tcp", "0") as (_, url):
        port = int(url.rpartition(":")[2])
        assert url == f"tcp://127.0.0.1:{port}"
        listening = Path("/proc/net/tcp").read_text() + Path("/proc/net/tcp6").read_text()
        addresses = {line.split()[1] for line in listening.splitlines() if f":{port:04X} " in line[:60]}
        assert {address for address in addresses if address.endswith(f":{port:04X}")} == {f"0100007F:{port:04X}"}
        assert run("read", url, "0").returncode == 0


@pytest.mark.parametrize("place", [["--tcp", "0"], []], ids=["tcp", "no tcp"])
def test_another_address_needs_tcp_and_a_token(place: list[str]) -> None:
    result = run("serve", "sim:", *place, "--host", "0.0.0.0")
    assert result.returncode == 2
    assert ("--token-file" if place else "--tcp") in result.stderr


@pytest.mark.parametrize("url", ["sim:", "sim:examples/rover.ul"])
def test_interface_option_needs_a_spec(url: str) -> None:
    result = run("serve", url, "--tcp", "0", "--interface", "other")
    assert result.returncode == 2
    assert "--interface goes with --spec alone" in result.stderr


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "no token can be read"), ("", "is empty"), ("two words", "without blanks"), ("\x00", "printable")],
)
def test_a_token_that_can_be_none_is_one_clear_error(content: str | None, words: str, tmp_path: Path) -> None:
    file = tmp_path / "token"
    if content is not None:
        file.write_text(content)
    result = run("serve", "sim:", "--tcp", "0", "--host", "0.0.0.0", "--token-file", str(file))
    assert result.returncode == 2
    assert words in " ".join(result.stderr.split())


@pytest.mark.slow
def test_wrong_token_ends_the_connection_without_an_answer(tmp_path: Path) -> None:
    (tmp_path / "token").write_text("open-sesame\n")
    with started("serve", "sim:", "--tcp", "0", "--host", "0.0.0.0", "--token-file", str(tmp_path / "token")) as (
        _,
        url,
    ):
        port = int(url.rpartition(":")[2])
        for said in (b"token open-sesam\n", b"Q\r\n", b"\nQ\r\n", b"token open-sesame2\nQ\r", b"x" * 1000, b"\n"):
            with socket.create_connection(("127.0.0.1", port)) as caller:
                caller.settimeout(30)
                caller.sendall(said)
                try:
                    heard = caller.recv(100)
                except ConnectionResetError:
                    heard = b""
                assert heard == b""
        for wrong in ("", "?token=sesame"):
            result = run("read", f"tcp://127.0.0.1:{port}{wrong}", "0")
            assert result.returncode == 1
            assert "ended before the gateway answered" in result.stderr
            assert "sesame" not in result.stderr
        assert run("read", f"tcp://127.0.0.1:{port}?token=open-sesame", "0").returncode == 0


def test_the_token_may_come_in_the_environment() -> None:
    with started("serve", "sim:", "--tcp", "0", UNITY_LINK_TOKEN="secret") as (_, url):
        assert "secret" not in url
        assert run("read", url, "0", "--timeout", "2").returncode == 1
        assert run("read", f"{url}?token=secret", "0").returncode == 0


# systemd


def test_systemd_gets_readiness_status_and_watchdog_messages(tmp_path: Path) -> None:
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as manager:
        manager.bind(str(tmp_path / "notify"))
        manager.settimeout(60)
        told: list[str] = []

        def hear(*beginnings: str) -> str:
            end = time.monotonic() + 60
            while time.monotonic() < end:
                told.extend(manager.recv(4096).decode().splitlines())
                for line in told:
                    if line.startswith(beginnings):
                        told.clear()
                        return line
            raise TimeoutError(f"no notification began with {beginnings}")

        place = tmp_path / "socket"
        port = free_port()
        environment = {"NOTIFY_SOCKET": str(tmp_path / "notify"), "WATCHDOG_USEC": "200000"}
        with started("serve", f"tcp://127.0.0.1:{port}", "--unix", str(place), **environment) as (process, _):
            hear("READY=1")
            assert place.exists()
            assert "waiting for the gateway" in hear("STATUS=0 clients; waiting")
            with started("simulate", "--tcp", str(port)):
                hear("STATUS=0 clients; the gateway answers")
                with blocking.connect(f"unix:{place}") as link:
                    assert link.read(0) == 0
                    hear("STATUS=1 clients; the gateway answers")
                    hear("WATCHDOG=1")
            # If the manager is busy, it gets only the newest status.
            hear("STATUS=0 clients; the gateway is away", "STATUS=0 clients; waiting for the gateway")
            process.terminate()
            hear("STOPPING=1")
            assert process.wait(30) == 128 + signal.SIGTERM


# Gateways and clients that are killed


@pytest.mark.slow
def test_the_gateway_may_be_away_at_the_start_and_in_between(tmp_path: Path) -> None:
    port = free_port()
    with started("serve", f"tcp://127.0.0.1:{port}", "--unix", str(tmp_path / "socket")) as (process, url):
        with pytest.raises(ConnectError, match="nothing arrived"), blocking.connect(url, timeout=0.5):
            pass
        with started("simulate", "--tcp", str(port)) as (gateway, _), blocking.connect(url, timeout=30) as link:
            link.write(1, 11)
            gateway.kill()
            gateway.wait(30)
            with pytest.raises(BusTimeoutError):
                link.write(1, 12)
            with started("simulate", "--tcp", str(port)):

                def back() -> bool:
                    try:
                        return link.read(1) == 0
                    except BusTimeoutError:
                        return False
                    except GatewayResetError:
                        return True

                wait_until(back)
                link.write(1, 13)
                assert link.read(1) == 13
        assert process.poll() is None


def test_unknown_gateway_is_wrong_use(tmp_path: Path) -> None:
    result = run("serve", "sim:delta", "--unix", str(tmp_path / "socket"))
    assert result.returncode == 2
    assert result.stderr.startswith("error: no robot 'delta' is known")


@pytest.mark.slow
def test_another_gateway_in_its_place_ends_the_server_with_one_sentence(tmp_path: Path) -> None:
    port = free_port()
    with started("serve", f"tcp://127.0.0.1:{port}", "--unix", str(tmp_path / "socket")) as (process, url):
        with started("simulate", "--tcp", str(port)), blocking.connect(url, timeout=30):
            pass
        with started("simulate", "--tcp", str(port), "--set", "data_bits=16"):
            assert process.wait(60) == 1
        assert process.stderr is not None
        last = process.stderr.read().splitlines()[-1]
        assert "another gateway answers" in last
        assert "perhaps executed" not in last


@pytest.mark.slow
def test_client_killed_during_a_request_disturbs_no_other(tmp_path: Path) -> None:
    program = (
        "import sys, unity_link.blocking as b\n"
        "with b.connect(sys.argv[1]) as link, link.subscribe([1], rate_hz=1000) as samples:\n"
        "    print('ready', flush=True)\n"
        "    while True:\n"
        "        link.write_block(0, range(200))\n"
    )
    with (
        started("serve", "sim:?groups=1", "--unix", str(tmp_path / "socket")) as (_, url),
        blocking.connect(url, timeout=30) as link,
    ):
        for _ in range(3):
            with subprocess.Popen([sys.executable, "-c", program, url], stdout=subprocess.PIPE) as client:
                assert client.stdout is not None
                assert client.stdout.readline() == b"ready\n"
                link.write(0xF0, 1)
                client.kill()

            def free() -> bool:
                try:
                    with link.subscribe([2], rate_hz=1000) as samples:
                        return next(iter(samples)).lost == 0
                except unity_link.OutOfRangeError:
                    return False

            wait_until(free)
            # A busy machine may be slow enough for time-outs; there must be no other retransmissions.
            assert link.statistics.repetitions <= link.statistics.timeouts
            assert link.statistics.damaged_frames == 0


def test_clients_that_stop_reading_or_send_random_bytes_disturb_no_other(tmp_path: Path) -> None:
    place = tmp_path / "socket"
    with (
        started("serve", "sim:", "--unix", str(place)) as (process, url),
        blocking.connect(url, timeout=30) as link,
        socket.socket(socket.AF_UNIX) as deaf,
        socket.socket(socket.AF_UNIX) as wild,
    ):
        for caller in (deaf, wild):
            caller.connect(str(place))
            caller.setblocking(False)
        with contextlib.suppress(BlockingIOError):
            for _ in range(100_000):
                deaf.send(b"RM00FF\r" * 1000)
        link.write_many(range(200), range(200))
        for _ in range(50):
            wild.send(os.urandom(1000) + b"\n")
            assert link.read_many(range(200)).tolist() == list(range(200))
        memory = int(Path(f"/proc/{process.pid}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
        assert memory < 200_000_000
        assert link.statistics.reconnections == 0


def test_piped_requests_are_all_answered(tmp_path: Path) -> None:
    place = tmp_path / "socket"
    with started("serve", "sim:", "--unix", str(place)) as (_, url), socket.socket(socket.AF_UNIX) as pipe:
        assert run("read", url, "0").returncode == 0
        pipe.connect(str(place))
        pipe.sendall(b"WS0A2A\rR0A\r" * 500)
        pipe.shutdown(socket.SHUT_WR)
        heard = b""
        while data := pipe.recv(65536):
            heard += data
        assert heard == b"R0A0000002A\r\n" * 500


@pytest.mark.slow
def test_connections_beyond_the_limit_are_closed(tmp_path: Path) -> None:
    place = tmp_path / "socket"
    with started("serve", "sim:", "--unix", str(place)) as (_, url), contextlib.ExitStack() as stack:
        assert run("read", url, "0").returncode == 0
        callers = [stack.enter_context(socket.socket(socket.AF_UNIX)) for _ in range(MOST_CLIENTS + 20)]
        for caller in callers:
            caller.connect(str(place))
            caller.settimeout(60)
        for caller in callers[:MOST_CLIENTS]:
            caller.sendall(b"H\r")
            assert caller.recv(100) == b"H\r\n"
        for caller in callers[MOST_CLIENTS:]:
            assert caller.recv(100) == b""
        callers[0].close()

        def room() -> bool:
            return run("read", url, "0").returncode == 0

        wait_until(room)
