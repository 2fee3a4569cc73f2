"""Media are registered by URL schemes: by this package, by a user's program, and by other packages."""

from __future__ import annotations

import asyncio
import importlib
import os
import shlex
import subprocess
import sys
import textwrap
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest
import uvloop

import examples.own_medium  # noqa: F401  (it registers its scheme)
import unity_link
from unity_link import ArgumentError, ConnectError, transport
from unity_link.transport import DriverUrl, parse_url, register
from unity_link.virtual import VirtualGateway

if TYPE_CHECKING:
    from collections.abc import Callable

ROOT = Path(__file__).parents[2]
SERVER = Path(__file__).with_name("serve.py")
PACKAGE = """
    from unity_link.virtual import VirtualGateway

    OPTIONS = frozenset({"word"})

    async def connect(url, protocol):
        gateway = VirtualGateway()
        gateway.memory[0] = url.integer("word", 0)
        return await gateway.open(protocol)
"""


class MediumOfOne:
    """A driver that is an object and has a gateway of its own."""

    OPTIONS = frozenset({"word"})

    def __init__(self) -> None:
        self.gateway = VirtualGateway()

    async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
        self.gateway.memory[0] = url.integer("word", 0)
        return await self.gateway.open(protocol)


@pytest.fixture(autouse=True)
def own_registry(monkeypatch: pytest.MonkeyPatch) -> None:
    """Restore the registry after each test."""
    monkeypatch.setattr(transport, "_DRIVERS", dict(transport._DRIVERS))


@pytest.fixture
def install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Path]:
    """Yield a function that installs a package with a medium, as pip would, and returns the folder."""
    monkeypatch.syspath_prepend(tmp_path)

    def write(package: str, entry: str, source: str = PACKAGE) -> Path:
        module = package.replace("-", "_")
        (tmp_path / f"{module}.py").write_text(textwrap.dedent(source))
        metadata = tmp_path / f"{module}-1.0.dist-info"
        metadata.mkdir()
        (metadata / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n")
        (metadata / "entry_points.txt").write_text(f"[unity_link.transports]\n{entry}\n")
        importlib.invalidate_caches()
        return tmp_path

    return write


async def first_word(url: str) -> int:
    async with unity_link.connect(url) as link:
        return await link.read(0)


@pytest.mark.asyncio
async def test_a_program_adds_a_medium_by_an_object() -> None:
    register("one", MediumOfOne())
    assert await first_word("one:?word=7") == 7


@pytest.mark.asyncio
async def test_a_program_adds_a_medium_by_the_name_of_a_module(install: Callable[..., Path]) -> None:
    install("medium-by-name", "other = medium_by_name")
    register("by-name", "medium_by_name")
    assert "medium_by_name" not in sys.modules
    assert await first_word("by-name:?word=7") == 7


@pytest.mark.asyncio
async def test_an_option_unknown_to_a_users_medium_is_refused() -> None:
    register("one", MediumOfOne())
    with pytest.raises(
        ArgumentError, match=r"unknown option 'words' in .*: one: takes compact, echo, map, node, snoop, word"
    ):
        await first_word("one:?words=7")


@pytest.mark.parametrize("scheme", ["", "One", "1st", "a_b", "a:b", "a b", "é", "a\n"])
def test_a_scheme_of_other_characters_is_refused(scheme: str) -> None:
    with pytest.raises(ArgumentError, match=r"is no scheme of a URL: lower-case letters, digits, \+, - and \. were"):
        register(scheme, MediumOfOne())


def test_a_scheme_is_registered_once() -> None:
    driver = MediumOfOne()
    register("one", driver)
    register("one", driver)
    with pytest.raises(ArgumentError, match=r"^one: is registered already, by MediumOfOne: choose another scheme$"):
        register("one", MediumOfOne())
    with pytest.raises(ArgumentError, match=r"^sim: is registered already, by unity_link.virtual.schemes: choose"):
        register("sim", driver)


def test_an_object_that_is_no_driver_is_refused() -> None:
    with pytest.raises(ArgumentError, match=r"^object is no driver for one: because it has no connect and no OPTIONS$"):
        register("one", object())  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match=r"because it has no OPTIONS$"):
        register("one", SimpleNamespace(connect=print))


def test_the_error_for_a_module_that_is_no_driver_is_one_sentence() -> None:
    register("one", "textwrap")
    with pytest.raises(
        ArgumentError, match=r"^textwrap is no driver for one: because it has no connect and no OPTIONS$"
    ):
        parse_url("one:")
    register("two", "nowhere_at_all")
    with pytest.raises(ConnectError, match=r"^nowhere_at_all, the driver of two:, cannot be imported \(No module"):
        parse_url("two:")


@pytest.mark.asyncio
@pytest.mark.parametrize("error", [FileNotFoundError(2, "No such file or directory"), TimeoutError()])
async def test_an_operating_system_error_of_a_driver_is_a_connect_error(error: OSError) -> None:
    class Refused(MediumOfOne):
        async def connect(self, url: DriverUrl, protocol: asyncio.Protocol) -> asyncio.Transport:
            raise error

    register("one", Refused())
    with pytest.raises(ConnectError, match=r"^one:x: it cannot be opened \((No such file|TimeoutError)"):
        await unity_link.connect("one:x")


# Media of other packages


@pytest.mark.asyncio
@pytest.mark.parametrize("entry", ["installed = medium_package", "installed = medium_package:DRIVER"])
async def test_an_installed_package_adds_a_medium_by_an_entry_point(
    install: Callable[..., Path], entry: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(sys.modules, "medium_package", raising=False)
    install("medium-package", entry, PACKAGE + "\n    import sys\n    DRIVER = sys.modules[__name__]\n")
    assert await first_word("installed:?word=7") == 7


def test_the_command_line_accepts_the_media_of_installed_packages(install: Callable[..., Path]) -> None:
    folder = install("medium-package", "installed = medium_package")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), str(ROOT)])}
    command = [str(Path(sys.executable).with_name("unity-link")), "read", "installed:?word=7", "0"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["0x00", "0x00000007", "7"]


def test_the_error_for_an_unknown_scheme_lists_the_media(install: Callable[..., Path]) -> None:
    install("medium-package", "installed = medium_package")
    with pytest.raises(ArgumentError, match=r"'nothing:' is no URL of a gateway: .*serial:, .*sim:, .*installed:"):
        parse_url("nothing:")


def test_the_error_for_a_medium_of_two_packages_names_both(install: Callable[..., Path]) -> None:
    install("one-package", "both = one_package")
    install("other-package", "both = other_package")
    with pytest.raises(ArgumentError, match=r"^both: is a medium of several packages \(one-package, other-package\)"):
        parse_url("both:")


@pytest.mark.parametrize(
    ("entry", "sentence"),
    [
        ("broken = nowhere_at_all", "cannot be imported .No module named 'nowhere_at_all'"),
        ("broken = broken_package:DRIVER", "cannot be imported .module 'broken_package' has no attribute 'DRIVER'"),
    ],
)
def test_the_error_for_a_package_that_cannot_be_imported_is_one_sentence(
    install: Callable[..., Path], entry: str, sentence: str
) -> None:
    install("broken-package", entry)
    with pytest.raises(ConnectError, match=f"^broken: of the package broken-package {sentence}"):
        parse_url("broken:")


# Modules that an import loads


def modules_after(code: str, *arguments: str) -> set[str]:
    """Return the modules that a new Python process has imported after it ran some code."""
    program = f"{textwrap.dedent(code)}\nimport sys; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program, *arguments], capture_output=True, text=True, check=True, cwd=ROOT
    )
    return set(done.stdout.split())


def test_installed_packages_are_searched_only_for_an_unknown_scheme() -> None:
    known = modules_after("from unity_link.transport import parse_url; parse_url('serial:/dev/ttyUSB0')")
    assert "importlib.metadata" not in known


CONNECTS = """
    import asyncio, sys, unity_link

    async def main(url):
        async with unity_link.connect(url) as link:
            await link.write(0x0A, 42)
            assert await link.read(0x0A) == 42

    asyncio.run(main(sys.argv[1]))
"""
FINDS_NO_CHIP = """
    import asyncio, sys, unity_link

    async def main(url):
        try:
            await unity_link.connect(url)
        except unity_link.ConnectError:
            pass
        else:
            raise AssertionError

    asyncio.run(main(sys.argv[1]))
"""


@pytest.mark.parametrize("medium", ["serial", "tcp", "unix", "udp"])
def test_a_link_to_hardware_does_not_import_the_simulator(medium: str, tmp_path: Path) -> None:
    command = [sys.executable, str(SERVER), medium, str(tmp_path / "gateway"), "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        loaded = modules_after(CONNECTS, process.stdout.readline().strip())
        process.kill()
    assert f"unity_link.transport.{medium}" in loaded
    assert {name for name in loaded if name.startswith("unity_link.virtual")} == set()


@pytest.mark.parametrize("scheme", ["ftdi", "ftdi-async"])
def test_the_drivers_of_an_ft232h_do_not_import_the_simulator(scheme: str) -> None:
    loaded = modules_after(FINDS_NO_CHIP, f"{scheme}://ftdi:232h:NOSUCHCHIP/1")
    assert "unity_link.transport.ft232h.chip" in loaded
    assert {name for name in loaded if name.startswith("unity_link.virtual")} == set()


# The example


def gateway_on_pipes() -> str:
    return f"pipes:{shlex.join([sys.executable, str(ROOT / 'examples' / 'gateway_on_pipes.py')])}"


def test_the_example_of_a_users_medium_runs() -> None:
    command = [sys.executable, str(ROOT / "examples" / "own_medium.py")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == "42\n"


def test_a_users_medium_works_on_uvloop() -> None:
    async def use() -> None:
        async with unity_link.connect(gateway_on_pipes()) as link:
            await link.write_block(0, range(256))
            assert (await link.read_many(range(256))).tolist() == list(range(256))

    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(use())


@pytest.mark.asyncio
async def test_the_link_is_lost_when_the_program_of_a_users_medium_ends() -> None:
    async with unity_link.connect(gateway_on_pipes()) as link:
        assert await link.read(0) == 0
        stream = link._flow.stream
        assert stream is not None
        assert stream._transport is not None
        stream._transport.abort()
        with pytest.raises(unity_link.LinkLostError):
            await link.read(0)


@pytest.mark.asyncio
@pytest.mark.parametrize(
    ("url", "error", "sentence"),
    [
        ("pipes:", ArgumentError, "names no program"),
        ("pipes:it's", ArgumentError, "is no command: No closing quotation"),
        ("pipes:/nowhere/at/all", ConnectError, r"it cannot be opened \(No such file or directory\)"),
        (f"pipes:{sys.executable} -c pass", ConnectError, "the connection ended before the gateway answered"),
    ],
)
async def test_the_error_for_an_impossible_program_is_one_sentence(
    url: str, error: type[Exception], sentence: str
) -> None:
    with pytest.raises(error, match=sentence):
        await unity_link.connect(url)
