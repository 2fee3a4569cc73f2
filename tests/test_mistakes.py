"""Each row of the tables in docs/mistakes.md is tried, and must end with the error of the row.

Rows of commands run in this process, some once more as programs; rows of Python run in the surroundings of their
section. Real ports replace those of the page: one is closed, others belong to servers of other kinds.
"""

from __future__ import annotations

import ast
import asyncio
import contextlib
import inspect
import re
import shlex
import shutil
import socket
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import pytest

import unity_link
from unity_link import blocking, cli
from unity_link.data import Group
from unity_link.data.blocking import put
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator

ROOT = Path(__file__).parent.parent
SPEC = ROOT / "examples" / "scara.ul"
PROGRAM = str(Path(sys.executable).parent / "unity-link")
SECTION, ROW = re.compile(r"^## (.*)$"), re.compile(r"^\| `(.+?)` \| (.+) \| `?([\w.]+)`? \|$")
PRIVATE = re.compile(r"^[\w./-]*: error: ")
"""Prefix of a sentence about a spec: the place in the spec."""


class Mistake(NamedTuple):
    section: str
    tried: str
    said: str
    ends: str

    def is_told_by(self, sentence: str) -> bool:
        """Return True if a sentence is that of the page, in which ``...`` matches any text."""
        return re.fullmatch(re.escape(self.said).replace(r"\.\.\.", ".*"), sentence) is not None


def mistakes() -> list[Mistake]:
    """Return the rows of the page."""
    found, section = [], ""
    for line in (ROOT / "docs" / "mistakes.md").read_text(encoding="utf-8").splitlines():
        if heading := SECTION.match(line):
            section = heading[1]
        elif row := ROW.match(line):
            found.append(Mistake(section, *row.groups()))
    return found


MISTAKES = mistakes()
COMMANDS = [mistake for mistake in MISTAKES if mistake.tried.startswith("unity-link")]
PYTHON = [mistake for mistake in MISTAKES if not mistake.tried.startswith("unity-link")]


def test_the_page_has_fifty_rows_and_none_that_waits_for_a_time_out() -> None:
    assert len(MISTAKES) >= 50
    assert len({(mistake.section, mistake.tried) for mistake in MISTAKES}) == len(MISTAKES)
    text = (ROOT / "docs" / "mistakes.md").read_text(encoding="utf-8")
    assert len(MISTAKES) == len(re.findall(r"^\| `", text, re.MULTILINE))
    assert [mistake for mistake in MISTAKES if "no gateway answered" in mistake.said] == []


# Servers at the ports of the page


def _says(answer: bytes) -> Callable[[socket.socket], None]:
    def serve(connection: socket.socket) -> None:
        connection.recv(100)
        connection.sendall(answer)

    return serve


def _echo(connection: socket.socket) -> None:
    while data := connection.recv(100):
        connection.sendall(data)


SERVERS = {
    "8080": _says(b"HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n"),
    "2222": _says(b"SSH-2.0-OpenSSH_9.6\r\nInvalid SSH identification string.\r\n"),
    "7001": _echo,
}
NOBODY = "7200"


@pytest.fixture(scope="module")
def ports() -> Iterator[dict[str, str]]:
    """Run the servers at the ports of the page; yield the real port for each port of the page."""
    from threading import Thread

    with contextlib.ExitStack() as stack:
        given = {}
        for port, serve in SERVERS.items():
            server = stack.enter_context(socket.create_server(("127.0.0.1", 0)))
            given[port] = str(server.getsockname()[1])

            def accept(server: socket.socket = server, serve: Callable[[socket.socket], None] = serve) -> None:
                with contextlib.suppress(OSError):
                    while True:
                        connection, _ = server.accept()
                        with connection, contextlib.suppress(OSError):
                            serve(connection)

            Thread(target=accept, daemon=True).start()
            stack.callback(server.shutdown, socket.SHUT_RDWR)
        # Bind a socket without listening, so that no other process gets the port.
        nobody = stack.enter_context(socket.socket())
        nobody.bind(("127.0.0.1", 0))
        given[NOBODY] = str(nobody.getsockname()[1])
        yield given


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Change to a folder with the files that the page names."""
    shutil.copy(SPEC, tmp_path)
    (tmp_path / "there.mcap").touch()
    (tmp_path / "broken.ul").write_text("public robot() { @speed = 0x10: sined READ(); }\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "500")
    monkeypatch.delenv("XDG_RUNTIME_DIR", raising=False)
    return tmp_path


def _with_ports(text: str, ports: dict[str, str]) -> str:
    return re.sub(r"\b(\d{4})\b", lambda match: ports.get(match[1], match[1]), text)


# Commands


@pytest.mark.parametrize("mistake", COMMANDS, ids=lambda mistake: mistake.tried)
@pytest.mark.usefixtures("folder")
def test_mistaken_command_prints_the_error_on_the_page(
    mistake: Mistake, ports: dict[str, str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", shlex.split(_with_ports(mistake.tried, ports)))
    code = cli._run(cli.app)
    said = capsys.readouterr()
    first = said.err.splitlines()[0]
    assert mistake._replace(said=_with_ports(mistake.said, ports)).is_told_by(_sentence(first)), first
    assert said.out == ""
    assert str(code) == mistake.ends


def _sentence(line: str) -> str:
    """Return a message without the place in a spec."""
    return PRIVATE.sub("", line).removeprefix("error: ")


@pytest.mark.slow
@pytest.mark.parametrize("mistake", COMMANDS[::12], ids=lambda mistake: mistake.tried)
def test_mistaken_command_as_a_process_prints_the_same_error(
    mistake: Mistake, folder: Path, ports: dict[str, str]
) -> None:
    _, *arguments = shlex.split(_with_ports(mistake.tried, ports))
    result = subprocess.run([PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    assert (str(result.returncode), result.stdout) == (mistake.ends, "")
    assert mistake._replace(said=_with_ports(mistake.said, ports)).is_told_by(_sentence(result.stderr.splitlines()[0]))


# Python


@contextlib.asynccontextmanager
async def surroundings(section: str) -> AsyncIterator[dict[str, Any]]:
    """Yield the names that the page defines for a section."""
    Scara = unity_link.load("scara.ul")  # noqa: N806  (a class)
    names: dict[str, Any] = {"unity_link": unity_link, "blocking": blocking, "Scara": Scara, "Group": Group}
    names |= {"put": put, "Path": Path, "VirtualGateway": VirtualGateway}
    if section == "In blocking code":
        with blocking.connect("sim:scara") as link:
            yield names | {"link": link, "robot": put(Scara, link)}
        return
    async with unity_link.connect("sim:scara") as link:
        robot = Scara(link)
        sample = await anext(aiter(robot.groups["state"]))
        yield names | {"link": link, "robot": robot, "sample": sample}


@pytest.mark.parametrize("mistake", PYTHON, ids=lambda mistake: f"{mistake.section}: {mistake.tried}")
@pytest.mark.usefixtures("folder")
def test_mistake_in_a_program_raises_the_error_on_the_page(mistake: Mistake, ports: dict[str, str]) -> None:
    async def attempt() -> BaseException | None:
        async with surroundings(mistake.section) as names:
            code = compile(
                _with_ports(mistake.tried, ports), "<the page>", "exec", flags=ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
            )
            try:
                result = eval(code, names)
                if inspect.iscoroutine(result):
                    await result
            except Exception as error:  # noqa: BLE001  (the test compares it)
                return error
        return None

    error = asyncio.run(attempt())
    assert error is not None
    sentence = " ".join(str(error).splitlines()[0].split())
    assert mistake._replace(said=_with_ports(mistake.said, ports)).is_told_by(_sentence(sentence)), sentence
    kinds = {kind.__name__ for kind in type(error).__mro__}
    assert mistake.ends.rpartition(".")[2] in kinds
