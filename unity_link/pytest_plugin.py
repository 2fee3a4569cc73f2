"""Fixtures for tests of programs that use a gateway: on a simulated robot, or on a board by ``--unity-link-url``.

::

    @pytest.mark.unity_link(spec="rover.ul", model="rover.py:Rover")
    async def test_it_stops_at_the_wall(unity_link_robot, unity_link_gateway):
        await unity_link_robot.left.duty.set(1)
        ...

pytest loads this module in every run, so the fixtures import the modules that they need.
"""

from __future__ import annotations

import contextlib
import importlib.util
import os
import threading
from dataclasses import dataclass, replace
from numbers import Real
from pathlib import Path  # noqa: TC003  (pytest and dataclasses read it)
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
    from contextlib import AbstractAsyncContextManager

    from unity_link import Link
    from unity_link.data import Robot
    from unity_link.virtual.gateway import BareGateway, Gateway

MEDIA = ("sim", "tcp", "unix", "pty", "udp")
_INI = {
    "unity_link_spec": "path of the spec of the robot, below the folder of the ini file",
    "unity_link_model": "model of the robot, as rover.py:Rover",
    "unity_link_medium": f"what is between program and gateway: {', '.join(MEDIA)}",
    "unity_link_noise": "probability that a byte is lost, and that one is damaged",
    "unity_link_seed": "chooses the course of the noise",
}
_KINDS: dict[str, tuple[Any, str]] = {
    "spec": (str | os.PathLike | None, "a path"),
    "model": (str | None, "text such as rover.py:Rover"),
    "noise": (Real | None, "a number"),
    "seed": (int, "a whole number"),
    "rtl": (bool, "True or False"),
    "unchecked": (bool, "True or False"),
}
"""Types of the marker's arguments, with phrases for messages."""


@dataclass(frozen=True)
class GatewaySettings:
    """Settings of a test's gateway."""

    spec: Path | None = None
    """Spec of the robot; None for plain memory."""
    model: str | None = None
    """Class of the model, as ``rover.py:Rover``; None if the registers are plain memory."""
    medium: str = "sim"
    noise: float = 0.0
    """Probability that a byte is lost, and also that a byte is damaged, in both directions."""
    seed: int = 0
    rtl: bool = False
    """True if the gateway is the compiled gateware instead of a model."""
    unchecked: bool = False
    """True if VHDL of the spec's own cores is not compared with GHDL's conversion of it."""
    url: str | None = None
    """URL of a board; it replaces all settings except the spec."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options of the command line and the ini file."""
    group = parser.getgroup("unity-link")
    group.addoption("--unity-link-url", metavar="URL", help="run the same tests on the gateway at URL: a board")
    for name, text in _INI.items():
        parser.addini(name, text)


def pytest_configure(config: pytest.Config) -> None:
    """Register the marker."""
    config.addinivalue_line(
        "markers",
        "unity_link(spec, model, medium, noise, seed, rtl, unchecked): the gateway of a test, and its robot; "
        "settings that are not given are those of the ini file",
    )


@pytest.fixture
def unity_link_settings(request: pytest.FixtureRequest) -> GatewaySettings:
    """Return the settings from markers, ini file and command line; an inner marker overrides an outer one."""
    config = request.config
    settings = _of_ini(config)
    for marker in reversed(list(request.node.iter_markers("unity_link"))):
        if marker.args or not marker.kwargs.keys() <= GatewaySettings.__annotations__.keys() - {"url"}:
            raise pytest.UsageError(
                f"unity_link takes spec=, model=, medium=, noise=, seed=, rtl= and unchecked=, not {marker}"
            )
        for name, value in marker.kwargs.items():
            kind, expected = _KINDS.get(name, (object, ""))
            if not isinstance(value, kind):
                raise pytest.UsageError(f"unity_link({name}={value!r:.80}): {expected} was expected")
        here = request.path.parent
        found = dict(marker.kwargs)
        if found.get("spec") is not None:
            found["spec"] = here / found["spec"]
        if found.get("model") is not None:
            found["model"] = _below(here, found["model"])
        settings = replace(settings, **found)
    if settings.medium not in MEDIA:
        raise pytest.UsageError(f"medium={settings.medium!r}: one of {', '.join(MEDIA)} was expected")
    return replace(settings, url=config.getoption("unity_link_url"))


def _of_ini(config: pytest.Config) -> GatewaySettings:
    texts = {name.removeprefix("unity_link_"): str(config.getini(name)) for name in _INI}
    folder = config.rootpath if config.inipath is None else config.inipath.parent
    try:
        return GatewaySettings(
            spec=folder / texts["spec"] if texts["spec"] else None,
            model=_below(folder, texts["model"]) if texts["model"] else None,
            medium=texts["medium"] or "sim",
            noise=float(texts["noise"] or 0),
            seed=int(texts["seed"] or 0),
        )
    except ValueError as error:
        raise pytest.UsageError(f"unity_link_noise and unity_link_seed are numbers: {error}") from None


def _below(folder: Path, model: str) -> str:
    """Return a model with its file relative to a folder; a model in a module is unchanged."""
    return str(folder / model) if ".py:" in model else model


@pytest.fixture
def unity_link_gateway(unity_link_settings: GatewaySettings) -> BareGateway:
    """Return the virtual gateway of the test; its `robot` is the model.

    On a board, tests that use this fixture are skipped.
    """
    if unity_link_settings.url is not None:
        pytest.skip(f"it looks behind the bus, and {unity_link_settings.url} is no virtual gateway")
    return _build(unity_link_settings)


def _build(settings: GatewaySettings) -> BareGateway:
    from unity_link.virtual.build import Wanted, build_bare

    robot = "" if settings.spec is None else str(settings.spec)
    return build_bare(Wanted(robot=robot, model=settings.model, rtl=settings.rtl, unchecked=settings.unchecked))


@pytest.fixture
def unity_link_open(
    request: pytest.FixtureRequest, unity_link_settings: GatewaySettings, tmp_path: Path
) -> Callable[[], AbstractAsyncContextManager[Link]]:
    """Return a function that opens a link to the test's gateway, for ``async with``; only one may be open at a time."""
    if unity_link_settings.url is not None:
        return lambda: _connect(unity_link_settings.url)
    gateway = request.getfixturevalue("unity_link_gateway")
    turn = threading.Lock()
    return lambda: _opened(unity_link_settings, gateway, tmp_path, turn)


def _connect(target: Any) -> AbstractAsyncContextManager[Link]:
    import unity_link

    return unity_link.connect(target)


@contextlib.contextmanager
def _alone(turn: threading.Lock) -> Iterator[None]:
    """Raise an error for a second link at the same time: the links would end each other's session and lose writes."""
    if not turn.acquire(blocking=False):
        raise pytest.UsageError(
            "the gateway of this test has a link, and serves one at a time: leave that first, or share the gateway by "
            "unity_link.bridges.serve.serve(unity_link_gateway, unix=tmp_path / 'shared')"
        )
    try:
        yield
    finally:
        turn.release()


@contextlib.asynccontextmanager
async def _opened(
    settings: GatewaySettings, bare: BareGateway, folder: Path, turn: threading.Lock
) -> AsyncIterator[Link]:
    from unity_link.virtual.build import put_behind_line

    chances = {"loss": settings.noise, "flip": settings.noise} if settings.noise else None
    gateway = put_behind_line(bare, chances=chances, seed=settings.seed)
    async with contextlib.AsyncExitStack() as stack:
        stack.enter_context(_alone(turn))
        target: Gateway | str = gateway
        if settings.medium != "sim":
            target = await stack.enter_async_context(_served(settings.medium, gateway, folder))
        yield await stack.enter_async_context(_connect(target))


def _served(medium: str, gateway: Gateway, folder: Path) -> AbstractAsyncContextManager[str]:
    from unity_link.virtual import serving

    match medium:
        case "unix":
            return serving.serve_unix(gateway, str(folder / "gateway"))
        case "pty":
            return serving.serve_pty(gateway)
        case "udp":
            return serving.serve_udp(gateway)
    return serving.serve_tcp(gateway)


@pytest.fixture
def unity_link_modelled_time() -> Callable[[Coroutine[Any, Any, Any]], Any]:
    """Return a function that runs a coroutine on simulated time, which does not wait; only for the medium ``sim``."""
    import asyncio

    from unity_link.virtual.modelled_time import ModelledTimeLoop

    def run(coroutine: Coroutine[Any, Any, Any]) -> Any:
        with asyncio.Runner(loop_factory=ModelledTimeLoop) as runner:
            return runner.run(coroutine)

    return run


async def _robot(settings: GatewaySettings, link: Link) -> Robot:
    import unity_link

    if settings.spec is None:
        raise pytest.UsageError("a robot needs a spec: pytest.mark.unity_link(spec='robot.ul'), or unity_link_spec")
    return await unity_link.robot(link, settings.spec)


async def _a_link(unity_link_open: Callable[[], AbstractAsyncContextManager[Link]]) -> AsyncIterator[Link]:
    """Yield a link to the test's gateway."""
    async with unity_link_open() as link:
        yield link


@pytest.fixture
async def unity_link_anyio_link(
    unity_link_open: Callable[[], AbstractAsyncContextManager[Link]],
) -> AsyncIterator[Link]:
    """Yield a link to the test's gateway, for tests of anyio's plugin, under asyncio or trio."""
    async with unity_link_open() as link:
        yield link


@pytest.fixture
async def unity_link_anyio_robot(unity_link_settings: GatewaySettings, unity_link_anyio_link: Link) -> Robot:
    """Return the robot of the spec, for tests of anyio's plugin."""
    return await _robot(unity_link_settings, unity_link_anyio_link)


if importlib.util.find_spec("pytest_asyncio") is not None:
    import pytest_asyncio

    unity_link_link = pytest_asyncio.fixture(_a_link, name="unity_link_link")

    @pytest_asyncio.fixture
    async def unity_link_robot(unity_link_settings: GatewaySettings, unity_link_link: Link) -> Robot:
        """Return the robot of the spec, for tests of pytest-asyncio."""
        return await _robot(unity_link_settings, unity_link_link)
