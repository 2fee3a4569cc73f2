"""A process forked from one with links does not use them; each use raises an error at once."""

from __future__ import annotations

import subprocess
import sys
from typing import TYPE_CHECKING

import pytest
from anyio.from_thread import start_blocking_portal

from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_tcp, serve_unix

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there is no fork")

HEAD = """
import asyncio, gc, os, sys, warnings
warnings.simplefilter("ignore")
import unity_link
from unity_link import blocking
"""
CHILD = """
def use(ask):
    try:
        ask()
    except unity_link.LinkLostError as error:
        os.write(1, f"child: {error}\\n".encode())

def end(way):
    if way == "exit":
        sys.exit()
    if way == "forgotten":
        global link
        del link
        gc.collect()
    os._exit(0)
"""
PROGRAMS = {
    "blocking": """
link = blocking.connect(sys.argv[1])
link.write(1, 5)
with link.subscribe([1], rate_hz=200) as samples:
    samples.take(2)
    if os.fork() == 0:
        use(lambda: link.read(1))
        use(lambda: link.write(1, 6))
        use(lambda: samples.take(100_000))
        end(sys.argv[2])
    os.wait()
    samples.take(2)
    print(link.read(1))
link.close()
""",
    "asyncio": """
async def main():
    async with unity_link.connect(sys.argv[1]) as link:
        await link.write(1, 5)
        if os.fork() == 0:
            use(lambda: link.read(1).send(None))
            use(lambda: link.write(1, 6).send(None))
            end("at once")
        os.wait()
        print(await link.read(1))
asyncio.run(main())
""",
    "trio": """
async def main():
    async with unity_link.connect(sys.argv[1]) as link:
        await link.write(1, 5)
        if os.fork() == 0:
            use(lambda: link.read(1).send(None))
            use(lambda: link.write(1, 6).send(None))
            end("at once")
        os.wait()
        print(await link.read(1))
import trio
trio.run(main)
""",
}
SENTENCE = "child: this process was forked from the one that opened the link: open another link here"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("face", "end"),
    [("blocking", "exit"), ("blocking", "forgotten"), ("blocking", "at once"), ("asyncio", ""), ("trio", "")],
)
@pytest.mark.parametrize("medium", ["unix", "tcp", "sim"])
def test_child_process_cannot_use_the_link_of_its_parent(face: str, end: str, medium: str, tmp_path: Path) -> None:
    with start_blocking_portal() as portal:
        gateway = VirtualGateway()
        serving = serve_tcp(gateway, 0) if medium == "tcp" else serve_unix(gateway, tmp_path / "gateway")
        with portal.wrap_async_context_manager(serving) as url:
            program = [sys.executable, "-c", HEAD + CHILD + PROGRAMS[face], "sim:" if medium == "sim" else url, end]
            result = subprocess.run(program, capture_output=True, text=True, timeout=60, check=False)
    assert result.stderr == ""
    *told, last = result.stdout.splitlines()
    assert {one.partition("; ")[0] for one in told} == {SENTENCE}
    assert len(told) == (3 if face == "blocking" else 2)
    assert last == "5"
