"""The plugin of pytest as a user has it: a folder with a spec, a model and tests, run by another pytest."""

from __future__ import annotations

import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from docs.walkthrough import files_of

EXAMPLES = Path(__file__).parent.parent / "examples"
SERVER = Path(__file__).parent / "transport" / "serve.py"
TESTS = """
import asyncio
import pytest

ROVER = pytest.mark.unity_link(spec="rover.ul", model="rover.py:Rover")
pytestmark = ROVER


async def reach(robot, wanted):
    await robot.left.duty.set(0.5)
    async for speed in robot.left.speed:
        if speed > wanted:
            return speed


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", [
    pytest.param(medium, marks=pytest.mark.unity_link(medium=medium)) for medium in ("sim", "tcp", "unix", "pty", "udp")
])
async def test_it_moves_on(medium, unity_link_robot):
    assert await reach(unity_link_robot, 0.5) > 0.5


@pytest.mark.asyncio
@pytest.mark.unity_link(noise=0.01, seed=3)
async def test_it_moves_over_noise(unity_link_link, unity_link_robot):
    await unity_link_robot.lamps.set(3)
    for _ in range(200):
        assert await unity_link_robot.lamps.get() == 3
    assert unity_link_link.statistics.repetitions


@pytest.mark.asyncio
async def test_a_fault_is_seen(unity_link_robot, unity_link_gateway):
    unity_link_gateway.robot.set_fault("blocked")
    await unity_link_robot.left.duty.set(1)
    await asyncio.sleep(0.2)
    assert await unity_link_robot.left.speed.get() == 0


def test_a_minute_passes_in_a_moment(unity_link_modelled_time, unity_link_open, unity_link_settings):
    import unity_link

    async def drive():
        async with unity_link_open() as link:
            robot = unity_link.load(unity_link_settings.spec)(link)
            await robot.left.duty.set(0.1)
            await asyncio.sleep(60)
            return await robot.left.position.get(), await robot.hits.get()

    position, hits = unity_link_modelled_time(drive())
    assert position == pytest.approx(0.6 * 60, rel=0.02)
    assert hits == 1


@pytest.mark.anyio
async def test_it_moves_under(unity_link_anyio_robot):
    assert await reach(unity_link_anyio_robot, 0.5) > 0.5
"""
BATTERY = """
import pytest

@pytest.mark.asyncio
async def test_battery(unity_link_robot):
    assert await unity_link_robot.battery.get() == 12
"""
SEVERAL = """
import pytest
import unity_link
from unity_link.bridges.serve import serve

pytestmark = pytest.mark.unity_link(spec="rover.ul", model="rover.py:Rover")


@pytest.mark.asyncio
@pytest.mark.parametrize("medium", [
    pytest.param(medium, marks=pytest.mark.unity_link(medium=medium)) for medium in ("sim", "tcp", "unix", "pty", "udp")
])
async def test_one_after_the_other(medium, unity_link_open):
    for value in range(3):
        async with unity_link_open() as link:
            with pytest.raises(pytest.UsageError, match="this test has a link, and serves one at a time"):
                async with unity_link_open():
                    pass
            assert await link.read(0x31) == value
            await link.write(0x31, value + 1)


@pytest.mark.asyncio
async def test_several_at_once(unity_link_gateway, tmp_path):
    async with serve(unity_link_gateway, unix=tmp_path / "shared") as server:
        (url,) = server.urls
        async with unity_link.connect(url) as one, unity_link.connect(url) as other:
            for value in range(16):
                await one.write(0x31, value)
                assert await other.read(0x31) == value
"""
WRONG = {
    "unity_link(medium='tcq')": "medium='tcq': one of sim, tcp, unix, pty, udp was expected",
    "unity_link(speck='rover.ul')": "unity_link takes spec=, model=, medium=, noise=, seed=, rtl= and unchecked=, not",
    "unity_link(model='rover.py:Rover')": "model is for the robot of a spec",
    "unity_link(spec=5)": "unity_link(spec=5): a path was expected",
    "unity_link(spec='rover.ul', model=5)": "unity_link(model=5): text such as rover.py:Rover was expected",
    "unity_link(spec='rover.ul', noise='0.1')": "unity_link(noise='0.1'): a number was expected",
    "unity_link(spec='rover.ul', seed='x')": "unity_link(seed='x'): a whole number was expected",
    "unity_link(spec='rover.ul', rtl='no')": "unity_link(rtl='no'): True or False was expected",
    "unity_link()": "a robot needs a spec: pytest.mark.unity_link(spec='robot.ul'), or unity_link_spec",
}


def run(folder: Path, *options: str) -> str:
    """Run pytest in a folder; return its output."""
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-q", "-rs", *options]
    if not plugin_is_installed():
        command += ["-p", "unity_link.pytest_plugin"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, timeout=100)
    return done.stdout + done.stderr


def plugin_is_installed() -> bool:
    from importlib.metadata import entry_points

    return bool(entry_points(group="pytest11", name="unity_link"))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    for name in ("rover.ul", "rover.py"):
        shutil.copy(EXAMPLES / name, tmp_path)
    (tmp_path / "pytest.ini").write_text("[pytest]\n")
    return tmp_path


@pytest.mark.slow
def test_plugin_tests_a_robot_on_all_media_with_noise_under_asyncio_and_trio(
    folder: Path,
) -> None:
    (folder / "test_rover.py").write_text(TESTS)
    said = run(folder)
    assert "10 passed" in said, said


@pytest.mark.slow
def test_the_how_to_page_is_right(folder: Path) -> None:
    page = files_of(EXAMPLES.parent / "docs" / "how-to" / "test-my-robot.md")
    for name in ("test_rover.py", "pytest.ini"):
        (folder / name).write_text(page[name])
    said = run(folder)
    assert "4 passed" in said, said


@pytest.mark.slow
def test_same_tests_run_on_a_board_except_those_that_need_a_virtual_gateway(folder: Path) -> None:
    (folder / "test_words.py").write_text(
        textwrap.dedent("""
            import pytest

            @pytest.mark.asyncio
            async def test_words(unity_link_link):
                await unity_link_link.write(0x20, 5)
                assert await unity_link_link.read(0x20) == 5

            def test_behind(unity_link_gateway):
                assert unity_link_gateway.memory[0x20] == 0
        """)
    )
    assert "2 passed" in run(folder)
    with subprocess.Popen([sys.executable, str(SERVER), "tcp", "", "0"], stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout is not None
        url = server.stdout.readline().strip()
        said = run(folder, f"--unity-link-url={url}")
        server.kill()
    assert "1 passed, 1 skipped" in said, said
    assert f"it looks behind the bus, and {url} is no virtual gateway" in said


@pytest.mark.slow
def test_ini_file_sets_the_defaults_of_all_tests(folder: Path) -> None:
    (folder / "pytest.ini").write_text(
        "[pytest]\nunity_link_spec = rover.ul\nunity_link_model = rover.py:Rover\nunity_link_medium = unix\n"
    )
    (folder / "test_rover.py").write_text(BATTERY)
    assert "1 passed" in run(folder)


@pytest.mark.slow
def test_paths_of_the_ini_file_are_below_its_folder(folder: Path) -> None:
    (folder / "ci").mkdir()
    (folder / "ci" / "board.ini").write_text(
        "[pytest]\nunity_link_spec = ../rover.ul\nunity_link_model = ../rover.py:Rover\n"
    )
    (folder / "test_rover.py").write_text(BATTERY)
    assert "1 passed" in run(folder, "-c", "ci/board.ini", "--rootdir=.")
    (folder / "pytest.ini").unlink()
    assert "1 passed" in run(folder, "-o", "unity_link_spec=rover.ul", "-o", "unity_link_model=rover.py:Rover")


@pytest.mark.slow
def test_links_opened_in_turn_and_at_once_share_the_gateway(folder: Path) -> None:
    (folder / "test_rover.py").write_text(SEVERAL)
    said = run(folder)
    assert "6 passed" in said, said


@pytest.mark.slow
def test_wrong_marks_are_reported_in_one_sentence(folder: Path) -> None:
    for place, mark in enumerate(WRONG):
        (folder / f"test_{place}.py").write_text(
            f"import pytest\n\n@pytest.mark.asyncio\n@pytest.mark.{mark}\nasync def test(unity_link_robot): ...\n"
        )
    said = run(folder)
    for sentence in WRONG.values():
        assert sentence in said


def test_pytest_loads_no_more_of_the_package_than_it_needs() -> None:
    code = (
        "import sys, pytest; before = set(sys.modules); import unity_link.pytest_plugin; "
        "print(*(set(sys.modules) - before))"
    )
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {name for name in loaded if name.startswith(("unity_link.virtual", "unity_link.spec", "numpy"))}
