"""One set of tests for every API of a link, also in other languages, on every medium that the API has.

docs/reference/faces.md has the table. A thread serves the gateways, so that no API shares their event loop.
tests/transport/test_faces.py covers the media on which a test cannot reset the gateway or cut the line.
"""

from __future__ import annotations

import asyncio
import itertools
import shutil
import subprocess
from contextlib import ExitStack, asynccontextmanager
from typing import TYPE_CHECKING, Any, Self

import pytest
import trio
import uvloop
from anyio.from_thread import start_blocking_portal

import unity_link
from generate.octave import MEX_FILE, why_not
from generate.programs import CPP, HERE, C, Driven, compiled, generated, linked
from support.behaviours import (
    BEHAVIOURS,
    Line,
    a_lost_line_ends_the_calls,
    a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session,
)
from support.driven_link import DrivenLink
from support.faces import face
from support.spec_examples import FIGURE_1
from unity_link.bridges.serve import serve
from unity_link.spec import compile_text
from unity_link.virtual.serving import serve_pty, serve_tcp, serve_udp, serve_unix

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Iterator
    from contextlib import AbstractAsyncContextManager, AbstractContextManager
    from pathlib import Path
    from types import TracebackType

    from anyio.from_thread import BlockingPortal

    from support.behaviours import Behaviour
    from unity_link.virtual import Gateway

IN_PYTHON = ("asyncio", "uvloop", "trio", "blocking")
PROGRAMS = ("C", "C++", "Octave")
MEDIA = ("serial", "tcp", "unix", "udp", "served")
A_SERVER_TELLS = "the server has a session of its own: it is the one that is told (tests/bridges)"
EMPTY: dict[tuple[str | None, str, Behaviour | None], str] = {
    (None, "served", a_reset_is_told_and_nothing_is_executed_by_a_gateway_without_a_session): A_SERVER_TELLS,
    (None, "udp", a_lost_line_ends_the_calls): "datagrams have no line; silence ends a link after five seconds",
}
"""Cells without a test, by API, medium and behaviour (None for all), and the reasons."""


class Served:
    """Serves gateways on one medium, in the thread of a portal."""

    def __init__(self, portal: BlockingPortal, medium: str, folder: Path) -> None:
        self._portal, self._medium, self._folder = portal, medium, folder
        self._numbers = itertools.count()

    def serve(self, gateway: Gateway) -> AbstractContextManager[str]:
        path = self._folder / f"gateway{next(self._numbers)}"
        serving: dict[str, Callable[[], AbstractAsyncContextManager[str]]] = {
            "serial": lambda: serve_pty(gateway),
            "tcp": lambda: serve_tcp(gateway),
            "unix": lambda: serve_unix(gateway, path),
            "udp": lambda: serve_udp(gateway),
            "served": lambda: _shared(gateway, path),
        }
        return self._portal.wrap_async_context_manager(serving[self._medium]())

    def call(self, function: Callable[[], object]) -> object:
        return self._portal.call(function)


@asynccontextmanager
async def _shared(gateway: Gateway, path: Path) -> AsyncIterator[str]:
    async with serve(gateway, unix=path):
        yield f"unix:{path}"


class Script(Driven):
    """The driver in an interpreted language."""

    def __init__(self, folder: Path) -> None:
        self._process = subprocess.Popen(
            ["octave-cli", "--no-init-file", "--quiet", "driver.m"],
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )


class Programs:
    """Drivers; each is compiled and started at its first use."""

    def __init__(self, folder: Path, mex_file: Callable[[], Path]) -> None:
        self._folder, self._mex_file = folder, mex_file
        self._running = ExitStack()
        self._started: dict[str, Driven] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._running.close()

    def __getitem__(self, name: str) -> Driven:
        if name not in self._started:
            folder = self._folder / name
            folder.mkdir()
            started = Script(self._package(folder)) if name == "Octave" else Driven(self._compiled(name, folder))
            self._started[name] = self._running.enter_context(started)
        return self._started[name]

    def _compiled(self, name: str, folder: Path) -> Path:
        generated("cpp", compile_text(FIGURE_1), folder)
        objects = compiled(C, [folder / "unity_link.c", folder / "unity_link_posix.c"], folder)
        compiler, source = (C, "driver.c") if name == "C" else (CPP, "driver.cc")
        return linked(compiler, [*objects, *compiled(compiler, [HERE / source], folder)], folder / "driver")

    def _package(self, folder: Path) -> Path:
        generated("matlab", compile_text(FIGURE_1), folder)
        shutil.copy2(self._mex_file(), folder / MEX_FILE)
        shutil.copy2(HERE / "driver.m", folder)
        return folder


@pytest.fixture(scope="module")
def programs(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Programs]:
    with Programs(tmp_path_factory.mktemp("programs"), lambda: request.getfixturevalue("mex_file")) as programs:
        yield programs


@pytest.fixture(scope="module")
def portal() -> Iterator[BlockingPortal]:
    """The thread that serves the gateways."""
    with start_blocking_portal() as portal:
        yield portal


def why_empty(name: str, medium: str, behaviour: Behaviour) -> str | None:
    """Return the reason why a cell has no test, or None if it has one."""
    cells = itertools.product((name, None), (medium, None), (behaviour, None))
    return next((EMPTY[cell] for cell in cells if cell in EMPTY), None)


def run(name: str, behaviour: Behaviour, line: Line, folder: Path, programs: Programs) -> None:
    """Run a behaviour on an API."""
    connect: Any = unity_link.connect
    if name == "trio":
        trio.run(behaviour, connect, line)
    elif name == "blocking":
        with face("blocking", folder) as connect:
            asyncio.run(behaviour(connect, line))
    else:
        if name in PROGRAMS:
            program = programs[name]

            def connect(url: str) -> DrivenLink:
                return DrivenLink(program, url)

        with asyncio.Runner(loop_factory=uvloop.new_event_loop if name == "uvloop" else None) as runner:
            runner.run(behaviour(connect, line))


CELLS = [
    pytest.param(*cell, id=f"{cell[0]}-{cell[1]}-{cell[2].__name__}")
    for cell in itertools.product((*IN_PYTHON, *PROGRAMS), MEDIA, BEHAVIOURS)
    if why_empty(*cell) is None
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "medium", "behaviour"), CELLS)
def test_every_api_behaves_like_a_link_on_every_medium(
    name: str, medium: str, behaviour: Behaviour, portal: BlockingPortal, programs: Programs, tmp_path: Path
) -> None:
    if name == "Octave" and why_not():
        pytest.skip(why_not())
    run(name, behaviour, Line(Served(portal, medium, tmp_path)), tmp_path, programs)
