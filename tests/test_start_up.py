"""Slow modules are imported only by calls that need them, and never while samples and answers arrive."""

from __future__ import annotations

import subprocess
import sys
import textwrap
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from unity_link.protocol import wire

if TYPE_CHECKING:
    from collections.abc import Iterator

SERVER = Path(__file__).parent / "transport" / "serve.py"
SLOW = {"anyio", "numpy", "pydantic", "rich"}
MODULES_OF_ITS_OWN = 63
"""Most modules that `import unity_link` may load besides asyncio, msgspec and fastcrc."""

COMMAND = """
import contextlib, sys
from unity_link.cli import main
with contextlib.suppress(SystemExit):
    main()
print("modules:", *sys.modules)
"""


def printed(code: str, *arguments: str) -> list[str]:
    program = [sys.executable, "-c", textwrap.dedent(code), *arguments]
    return subprocess.run(program, check=True, capture_output=True, text=True, timeout=60).stdout.split()


@pytest.fixture(scope="module")
def pty() -> Iterator[str]:
    """Serve a gateway on a pseudo-terminal of another process; yield its path."""
    command = [sys.executable, str(SERVER), "serial", "", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        yield process.stdout.readline().strip()
        process.kill()


@pytest.fixture(params=["sim", "pty"])
def url(request: pytest.FixtureRequest) -> str:
    return "sim:" if request.param == "sim" else str(request.getfixturevalue("pty"))


def test_the_package_brings_few_modules() -> None:
    loaded = printed(
        "import sys, asyncio, fastcrc, msgspec; before = set(sys.modules); import unity_link;"
        "print(*(set(sys.modules) - before))"
    )
    assert len(loaded) <= MODULES_OF_ITS_OWN
    assert SLOW.isdisjoint(loaded)


def test_public_packages_are_attributes_that_are_imported_on_first_use() -> None:
    assert printed(
        "import sys, unity_link; print('unity_link.data' in sys.modules);"
        "print(unity_link.data.Group.__name__, unity_link.blocking.connect.__name__, hasattr(unity_link, 'dta'))"
    ) == ["False", "Group", "connect", "False"]


def test_single_words_are_transferred_without_slow_imports(url: str) -> None:
    loaded = printed(
        """
        import asyncio, sys
        import unity_link

        async def main():
            async with unity_link.connect(sys.argv[1]) as link:
                await link.write(0x0A, 42)
                assert await link.read(0x0A) == 42
                assert await link.write_masked(0x0A, 1, 1) == 42
                await link.post(0x0A, 43)
                await link.fence()
                assert await link.read(0x0A) == 43

        asyncio.run(main())
        print(*sys.modules)
        """,
        url,
    )
    assert SLOW.isdisjoint(loaded)


def test_blocking_api_reads_single_words_without_slow_imports(url: str) -> None:
    loaded = printed(
        """
        import sys
        from unity_link import blocking

        with blocking.connect(sys.argv[1]) as link:
            link.write(0x0A, 42)
            assert link.read(0x0A) == 42
            link.post(0x0A, 43)
            link.fence()
        print(*sys.modules)
        """,
        url,
    )
    assert SLOW.isdisjoint(loaded)


@pytest.mark.parametrize(
    "call",
    [
        "await link.read_many([1, 2])",
        "await link.write_many([1, 2], [3, 4])",
        "await link.post_many([1, 2], [3, 4]); await link.fence()",
        "await link.read_block(1, 2)",
        "await link.read_queue(1, 2)",
        "await link.write_block(1, [3, 4])",
        "await link.write_queue(1, [3, 4])",
        "async with link.subscribe([1, 2], rate_hz=500) as samples: [await anext(samples) for _ in range(50)]",
        "async with link.subscribe([1, 2]) as samples: await samples.publish(); await anext(samples)",
    ],
)
def test_numpy_is_imported_by_the_call_that_needs_it_before_it_sends_data(call: str, pty: str) -> None:
    code = f"""
import asyncio, sys
import unity_link

seen = []

class Watch:
    def find_spec(self, name, path, target=None):
        if name == "numpy":
            seen.append((asyncio.current_task() is not None, link.statistics.requests))

async def main():
    global link
    link = await unity_link.connect(sys.argv[1])
    await link.read(1)
    before = link.statistics.requests
    sys.meta_path.insert(0, Watch())
    {call}
    await link.aclose()
    print(seen == [(True, before)])

asyncio.run(main())
"""
    assert printed(code, pty) == ["True"]


def test_a_server_has_numpy_from_the_start() -> None:
    assert "numpy" in printed("import sys, unity_link.bridges.serve; print(*sys.modules)")


@pytest.mark.parametrize(
    ("arguments", "needs"),
    [
        ("read sim: 0x10", set()),
        ("read sim: 0x10 --json --timeout 5", {"pydantic"}),
        ("write sim: 0x10 5", set()),
        ("info sim:", set()),
        ("--version", set()),
        ("read --help", {"rich"}),
        ("--help", {"rich"}),
        ("read sim: 0x10 3", {"numpy"}),
    ],
)
def test_command_imports_only_modules_that_it_uses(arguments: str, needs: set[str]) -> None:
    loaded = printed(COMMAND, *arguments.split())
    assert SLOW.intersection(loaded[loaded.index("modules:") :]) == needs


def test_a_command_imports_no_other_family() -> None:
    loaded = printed(COMMAND, "read", "sim:", "0x10")
    families = {"access", "arguments", "completion", "families", "output", "running", "words"}
    assert {name for name in loaded if name.startswith("unity_link.cli.")} == {
        f"unity_link.cli.{name}" for name in families
    }


def test_unknown_attribute_of_the_wire_package_is_missing() -> None:
    assert not hasattr(wire, "matrices")
