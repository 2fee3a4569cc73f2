"""The contents of a generated package of ROS, on the Pythons of its distributions: `make ros-packages` names them.

Without ROS_PYTHONS, it is tried on this one and on those that are found.
"""

from __future__ import annotations

import ast
import asyncio
import functools
import importlib
import json
import math
import os
import shutil
import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import unity_link
from generate.every_kind import WORD_BITS, every_kind
from generate.peers import serve as served_by_tcp
from generate.ros_on_paper import Paper
from support.bridge_programs import PROGRAM, Noted, wait_until
from support.spec_examples import FIGURE_1
from unity_link import ArgumentError, GatewayInfo, blocking
from unity_link.bridges.topics import command_topics, joint_command_topics, published_groups
from unity_link.data.blocking import put
from unity_link.generate import generate, write
from unity_link.generate.ros import OLDEST_PYTHON
from unity_link.spec import compile_file, compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.serving import serve_unix

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import ModuleType

EXAMPLES = Path(__file__).parents[2] / "examples"
ON_PAPER = Path(__file__).with_name("ros_on_paper.py")
PATIENCE = 120
NAMED = os.environ.get("ROS_PYTHONS", "").split()
BASE, CTRL = 0x400, 0x7F0
PACKAGES = {"ros1": ("scripts", ""), "ros2": ("", "scara_unity_link.")}
"""Folder of a package's modules, and the prefix of their names."""
MODULES = ("client", "values", "bridge", "robot")


def runs(python: str) -> bool:
    """Return whether a Python is there; a name may be that of a program that only looks for one."""
    found = shutil.which(python)
    return found is not None and subprocess.run([found, "-c", ""], check=False, capture_output=True).returncode == 0


def pythons() -> list[str]:
    return NAMED or [sys.executable, *filter(runs, ("python3.8", "python3.10", "python3.12"))]


def packages(folder: Path, target: str, spec: Any) -> Path:
    write(generate(target, spec), folder)
    (package,) = folder.iterdir()
    return package


@contextmanager
def served(folder: Path, gateway: str) -> Iterator[str]:
    with subprocess.Popen(
        [PROGRAM, "serve", gateway, "--unix", str(folder / "gateway")],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as server:
        assert server.stdout is not None
        yield server.stdout.readline().strip()
        server.terminate()


def loaded(package: Path) -> dict[str, ModuleType]:
    """Return the modules of a package of ROS 1, without those of another package that have the same names."""
    sys.path.insert(0, str(package / "scripts"))
    try:
        return {name: importlib.import_module(name) for name in MODULES}
    finally:
        sys.path.pop(0)
        for name in MODULES:
            sys.modules.pop(name, None)


# On each Python


@pytest.mark.slow
@pytest.mark.parametrize("python", pythons())
@pytest.mark.parametrize("target", PACKAGES)
def test_a_package_runs_on_the_python_of_its_distribution(target: str, python: str, tmp_path: Path) -> None:
    place, prefix = PACKAGES[target]
    folder = packages(tmp_path / "package", target, compile_file(EXAMPLES / "scara.ul")) / place
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    with served(tmp_path, "sim:scara") as url:
        done = subprocess.run(
            [python, "-W", "error", str(ON_PAPER), str(folder), prefix, url],
            env=environment,
            capture_output=True,
            check=False,
            text=True,
            timeout=PATIENCE,
        )
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    warnings = [text.partition(" (told once)")[0] for text in told["warnings"]]
    assert warnings == [
        f"the gateway answers at {url}",
        "j1.pos_sp: 500.0 is outside of its limits, -130 to 130 deg",
        "j2.pos_sp: inf is no finite number in deg",
    ]
    assert told["written"] == 1 + 2 + 3
    assert told["subscribed"]["/arm/joint_commands"] == "sensor_msgs/JointState"
    assert told["subscribed"]["/arm/position_commands"] == "std_msgs/Float64MultiArray"
    assert told["subscribed"]["/arm/j1/pos_sp/set"] == "std_msgs/Float64"
    kind, (_, frame_id, names, columns) = told["last"]["/arm/joint_states"]
    assert (kind, frame_id, names) == ("sensor_msgs/JointState", "base", ["j1", "j2", "j3", "j4"])
    assert [len(column) for column in columns] == [4, 4, 0]
    _, (_, [(level, name, message, hardware, values)]) = told["last"]["/diagnostics"]
    assert (level, name, message, hardware) == (0, "unity_link_arm: link", "connected", url)
    assert float(dict(values)["round trip (ms)"]) > 0


@pytest.mark.parametrize("target", PACKAGES)
@pytest.mark.parametrize("spec", ["scara", "walker", "figure_1"])
def test_a_package_has_nothing_that_the_oldest_python_does_not_know(target: str, spec: str, tmp_path: Path) -> None:
    compiled = compile_text(FIGURE_1) if spec == "figure_1" else compile_file(EXAMPLES / f"{spec}.ul")
    folder = packages(tmp_path, target, compiled)
    programs = [path for path in folder.rglob("*") if path.suffix == ".py" or path.name == "bridge"]
    assert len(programs) >= 5
    for path in programs:
        tree = ast.parse(path.read_text(), str(path), feature_version=OLDEST_PYTHON)
        imported = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        imported |= {name.name for node in ast.walk(tree) if isinstance(node, ast.Import) for name in node.names}
        assert not any(name.startswith(("unity_link", "numpy", "msgspec")) for name in imported)


def test_the_modules_that_a_test_runs_are_those_that_the_oldest_python_knows() -> None:
    ast.parse(ON_PAPER.read_text(), str(ON_PAPER), feature_version=OLDEST_PYTHON)


# The link


class Buffers:
    """A double-buffered memory, of which a commit sends one buffer and gives the user the other."""

    def __init__(self) -> None:
        self._own: dict[int, int] = {}
        self._other: dict[int, int] = {}
        self.sent: list[dict[int, int]] = []

    def read(self, offset: int, now: float) -> int:
        return 0 if offset == CTRL - BASE else self._own.get(offset, 0)

    def write(self, offset: int, value: int, now: float) -> None:
        if offset == CTRL - BASE:
            self.sent.append(dict(self._own))
            self._own, self._other = self._other, self._own
        else:
            self._own[offset] = value


@pytest.mark.asyncio
async def test_what_is_written_to_a_tosnet_is_committed_with_all_that_was_written_before(tmp_path: Path) -> None:
    spec = compile_text(
        FIGURE_1.replace("TOSNET(", "GATEWAY(ADDRESS_BITS=12); TOSNET(").replace("BASE=0", f"BASE={BASE}")
    )
    package = loaded(packages(tmp_path / "package", "ros1", spec))
    gateway, buffers = VirtualGateway(GatewayInfo(address_bits=12)), Buffers()
    gateway.attach(buffers, range(BASE, CTRL + 1))
    async with serve_unix(gateway, tmp_path / "gateway") as url:
        bridge = package["bridge"].Bridge(Paper(url, given_ctrl=hex(CTRL)), package["robot"])
        await asyncio.to_thread(set_joints, bridge, package["robot"])
    wanted = [
        {"j1.pos_sp": 30, "j2.pos_sp": 40},
        {"j1.pos_sp": 31, "j2.pos_sp": 40},
        {"j1.pos_sp": 31, "j2.pos_sp": -5},
    ]
    signals = spec.interface().signals
    assert buffers.sent == [
        {signals[path].address - BASE: signals[path].encode(value)[0] for path, value in sent.items()}
        for sent in wanted
    ]


def set_joints(bridge: Any, robot: Any) -> None:
    bridge.start()
    signals = {signal.path: signal for signal in robot.WRITABLE}
    assert bridge._link.connected.wait(PATIENCE)
    for values in ({"j1.pos_sp": 30, "j2.pos_sp": 40}, {"j1.pos_sp": 31}, {"j2.pos_sp": -5}):
        bridge.write([(signals[path], value) for path, value in values.items()])
    bridge.close()


POLLED = """
public robot() {
  @count = 0x10: unsigned 40 READ(POLL(100));
  @state = 0x11[31:8]: READ(POLL(100));
  @after = 0x12: READ(POLL(100));
}
"""


@pytest.mark.asyncio
async def test_a_polled_value_of_several_words_is_read_in_one_transaction_of_the_bus(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path / "package", "ros1", compile_text(POLLED)))
    gateway = VirtualGateway()
    gateway.memory.update({0x10: 0xFFFFFFFF, 0x11: 0xABCDEF12, 0x12: 7})
    async with serve_unix(gateway, tmp_path / "gateway") as url:
        paper = Paper(url)
        asked, values = await asyncio.to_thread(polled, package["bridge"].Bridge(paper, package["robot"]), paper)
    assert asked == ["RM1002", "R12"]
    assert values == {"count": 0x12_FFFFFFFF, "state": 0xABCDEF, "after": 7}


def polled(bridge: Any, paper: Paper) -> tuple[list[str], dict[str, int]]:
    """Return the requests of a poll, and what was published."""
    asked: list[list[str]] = []
    ask = bridge._link.ask

    def note(requests: list[str], *arguments: Any) -> Any:
        asked.append(requests)
        return ask(requests, *arguments)

    bridge._link.ask = note
    bridge.start()
    topics = {name: f"/arm/{name}" for name in ("count", "state", "after")}
    wait_until(lambda: all(topic in paper.last for topic in topics.values()))
    bridge.close()
    wanted = next(requests for requests in asked if requests != ["H"])
    return wanted, {name: paper.last[topic][1] for name, topic in topics.items()}


@pytest.mark.slow
def test_a_gateway_may_go_and_come_back_and_nothing_is_kept_for_it(tmp_path: Path) -> None:
    noted = Noted(tmp_path)
    package = loaded(packages(tmp_path / "package", "ros1", compile_file(noted.spec)))
    target, *_ = package["robot"].WRITABLE
    paper = Paper(noted.url)
    bridge = package["bridge"].Bridge(paper, package["robot"])
    with noted.running():
        bridge.start()
        assert bridge._link.connected.wait(PATIENCE)
        bridge.write([(target, 1)])
        paper.say("/arm/refused", data=1)
        wait_until(lambda: noted.values == [1] and bridge.published)
    wait_until(lambda: not bridge._link.connected.is_set())
    with pytest.raises(package["client"].LinkError, match="the gateway is away"):
        bridge.write([(target, 2)])
    wait_until(lambda: paper.last["/diagnostics"][1][1][0][:3:2] == (2, "the gateway is away"))
    with noted.running():
        assert bridge._link.connected.wait(PATIENCE)
        before = bridge.published
        bridge.write([(target, 3)])
        wait_until(lambda: noted.values == [1, 3] and bridge.published > before)
        wait_until(lambda: dict(paper.last["/diagnostics"][1][1][0][4])["reconnections"] == "1")
    bridge.close()
    assert any("W21" in text and "the bus refused the access" in text for text in paper.warnings)
    assert any("waiting for the gateway" in text for text in paper.warnings)


@pytest.mark.slow
def test_each_lease_has_a_status_that_tells_how_it_ended(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(
        "public rover() { drive: LEASE(TIMEOUT=20) @(0xE0); arm: LEASE() @(0xC0);"
        " @speed = 0x10: signed READWRITE(SAFE(0, drive)); }"
    )
    package = loaded(packages(tmp_path / "package", "ros1", compile_file(spec)))
    paper = Paper("unix:" + str(tmp_path / "gateway"))

    def told() -> dict[str, tuple[int, str]]:
        statuses = paper.last["/diagnostics"][1][1] if "/diagnostics" in paper.last else []
        return {name: (level, message) for level, name, message, _, _ in statuses}

    bridge = package["bridge"].Bridge(paper, package["robot"])
    bridge.start()
    wait_until(lambda: told().get("unity_link_arm: lease drive") == (3, "the gateway is away"))
    never = (1, "disarmed: nobody has armed it since the reset")
    with served(tmp_path, f"sim:{spec}") as url, blocking.connect(url) as link:
        wait_until(lambda: told().get("unity_link_arm: lease arm") == never)
        robot: Any = put(unity_link.load(spec), link)
        with robot.drive.armed():
            wait_until(lambda: told()["unity_link_arm: lease drive"] == (0, "armed"))
        wait_until(lambda: told()["unity_link_arm: lease drive"] == (1, "disarmed: it was disarmed"))
        with robot.drive.armed(timeout=0.5):
            wait_until(lambda: told()["unity_link_arm: lease drive"][0] == 2)
            message = told()["unity_link_arm: lease drive"][1]
        assert message.startswith("fault: no kick came before its end, at ")
        assert told()["unity_link_arm: lease arm"] == never
    bridge.close()


@pytest.mark.slow
def test_samples_go_on_when_the_gateway_behind_the_server_was_reset(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path / "package", "ros1", compile_file(EXAMPLES / "scara.ul")))
    gateway, paper = VirtualGateway(), Paper("unix:" + str(tmp_path / "gateway"), poll_hz=0.0)
    with served_by_tcp(gateway) as url, served(tmp_path, url):
        bridge = package["bridge"].Bridge(paper, package["robot"])
        bridge.start()
        wait_until(lambda: bridge.published > 100)
        gateway.reset()
        wait_until(lambda: bridge._link.connections == 2)
        before = bridge.published
        wait_until(lambda: bridge.published > before + 100)
        assert any(text.endswith(": the gateway was reset") for text in paper.warnings)
        bridge.close()


def test_a_gateway_that_is_away_from_its_server_was_not_reset(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path, "ros1", compile_file(EXAMPLES / "scara.ul")))
    link = package["client"].Link("unix:/nowhere", 32, [], print, print)
    link.configuration = package["client"].Configuration(GatewayInfo().to_hex().decode())
    answers = package["client"].Answers(1)
    link._pending.append(("h001", answers))
    link._take_line("x00105")
    assert answers.wait() == []
    with pytest.raises(package["client"].LinkError, match="the gateway was reset"):
        link._take_line("x0010A")


def test_velocities_of_which_the_gateway_gives_the_magnitude_have_the_sign_of_the_last_move(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path, "ros1", compile_file(EXAMPLES / "scara.ul")))
    paper = Paper("unix:/nowhere", poll_hz=0.0)
    bridge = package["bridge"].Bridge(paper, package["robot"])
    (group,) = package["robot"].GROUPS
    for topic in ["joint_states", *(signal.topic for signal in group.signals)]:
        bridge._publish_on(topic, "some_msgs", "Message")
    seen = []
    for position in (0, 10, 10, -10, -10, 5):
        words = [0] * len(group.addresses)
        words[group.places["j2.cpos"][0]], words[group.places["j2.spd"][0]] = position % (1 << 32), 1000
        bridge._publish(group, 1.0, words)
        velocities = paper.last["/arm/joint_states"][1][3][1]
        seen.append(velocities[1] > 0)
        assert abs(velocities[1]) == pytest.approx(1.8 * math.pi / 180)
    assert seen == [True, True, True, False, False, True]


@pytest.mark.parametrize("url", ["", "sim:scara", "tcp://localhost", "unix:", "serial:/dev/ttyUSB0"])
def test_another_link_than_a_shared_one_is_refused_with_what_to_do(url: str, tmp_path: Path) -> None:
    package = loaded(packages(tmp_path, "ros1", compile_file(EXAMPLES / "scara.ul")))
    with pytest.raises(package["client"].LinkError, match=r"is no shared link: .* `unity-link serve"):
        package["bridge"].Bridge(Paper(url), package["robot"])


@pytest.mark.slow
def test_a_token_lets_in(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path / "package", "ros1", compile_file(EXAMPLES / "scara.ul")))
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    environment = {**os.environ, "UNITY_LINK_TOKEN": "sesame"}
    with subprocess.Popen(
        [PROGRAM, "serve", "sim:scara", "--tcp", str(port)], env=environment, stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        server.stdout.readline()
        paper = Paper(f"tcp://127.0.0.1:{port}?token=sesame")
        bridge = package["bridge"].Bridge(paper, package["robot"])
        bridge.start()
        wait_until(lambda: "/arm/joint_states" in paper.last)
        wait_until(lambda: "/diagnostics" in paper.last)
        bridge.close()
        server.terminate()
    assert not any("sesame" in text for text in [*paper.warnings, str(paper.last["/diagnostics"])])


# Values


@functools.cache
def tables(word_bits: int, folder: Path) -> dict[str, Any]:
    """Return the signals of a package by their paths."""
    package = loaded(packages(folder / str(word_bits), "ros1", every_kind(word_bits)))
    signals = {signal.path: signal for signal in (*package["robot"].REST, *package["robot"].WRITABLE)}
    return {**signals, "refused": package["values"].ValueRefused}


@pytest.mark.slow
@given(data=st.data(), word_bits=st.sampled_from(WORD_BITS))
def test_values_stand_in_words_as_unity_link_itself_has_them(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, word_bits: int
) -> None:
    theirs = every_kind(word_bits).interface().signals
    ours = tables(word_bits, tmp_path_factory.getbasetemp() / "ros_values")
    signal = theirs[data.draw(st.sampled_from([path for path in theirs if path in ours]))]
    words = data.draw(st.lists(st.integers(0, (1 << word_bits) - 1), min_size=signal.words, max_size=signal.words))
    expected, seen = signal.decode(words), ours[signal.path].decode(words)
    assert seen == expected or (math.isnan(seen) and math.isnan(expected))

    value = data.draw(st.floats() | st.integers(-(1 << 70), 1 << 70) | st.booleans() | st.just(seen))
    try:
        right: list[int] | None = list(signal.encode(value))
    except ArgumentError:
        right = None
    try:
        assert ours[signal.path].encode(value) == right
    except ours["refused"]:
        assert right is None


# What the packages and the bridges agree on


@pytest.mark.parametrize("name", ["scara", "walker"])
def test_a_package_has_the_topics_of_the_bridge(name: str, tmp_path: Path) -> None:
    from unity_link.data import load

    spec = compile_file(EXAMPLES / f"{name}.ul")
    folder = packages(tmp_path, "ros1", spec) / "scripts"
    program = "import json, robot; print(json.dumps([[[s.topic, s.message] for s in g.signals] for g in robot.GROUPS]))"
    done = subprocess.run([sys.executable, "-c", program], cwd=folder, capture_output=True, text=True, check=True)
    with blocking.connect(f"sim:{name}") as link:
        robot = load(spec)(link._link)
        groups = published_groups(robot)
        topics = [[[topic.name, topic.type] for topic in group.topics] for group in groups]
        joints = joint_command_topics(robot, groups)[0].joints
    assert json.loads(done.stdout) == topics
    assert repr(joints.names) in (folder / "robot.py").read_text()


WHOLE_DEGREES = """
group state(1, 10, JOINTS(POSITION=q, SET_POSITION=q));
public robot() { hip: joint() @(0); }
joint(): @(base) { @q = base: signed READWRITE(UNIT="deg", PUBLISH(state)); }
"""


def test_a_set_point_that_no_number_holds_in_the_unit_of_the_spec_is_refused(tmp_path: Path) -> None:
    package = loaded(packages(tmp_path, "ros1", compile_text(WHOLE_DEGREES)))
    (joints,) = package["robot"].JOINTS
    with pytest.raises(package["values"].ValueRefused, match="1e\\+308 is no finite number in deg"):
        joints.of_array("position", [1e308])


ALIKE = """
group state(1, 10, JOINTS(POSITION=q, SET_POSITION=to));
public robot() {
  legs[3]: leg() @(2 * i);
  legs_1: leg() @(8);
  legs_1_2: leg() @(10);
}
leg(): @(base) { @q = base: signed READ(PUBLISH(state)); @to = base + 1: signed WRITE(); }
"""


def test_no_two_signals_or_joints_have_one_name_in_ros(tmp_path: Path) -> None:
    from unity_link.data import load

    spec = compile_text(ALIKE)
    robot = loaded(packages(tmp_path, "ros1", spec))["robot"]
    with blocking.connect("sim:") as link:
        bridged = load(spec)(link._link)
        (group,) = published_groups(bridged)
        commands = command_topics(bridged, [group])
    legs = {
        "legs[0]": "legs_0",
        "legs[1]": "legs_1_3",
        "legs[2]": "legs_2",
        "legs_1": "legs_1",
        "legs_1_2": "legs_1_2",
    }
    assert {topic.proxy.path: topic.name for topic in group.topics} == {f"{a}.q": f"{b}/q" for a, b in legs.items()}
    assert {topic.proxy.path: topic.name for topic in commands} == {f"{a}.to": f"{b}/to" for a, b in legs.items()}
    for topics in (group.topics, commands):
        theirs = {signal.path: signal.topic for signal in (*robot.GROUPS[0].signals, *robot.WRITABLE)}
        assert {topic.proxy.path: topic.name for topic in topics}.items() <= theirs.items()
    assert group.joints is not None
    assert sorted(group.joints.names) == sorted(legs.values())
    assert robot.JOINTS[0].names == robot.GROUPS[0].joints[0] == group.joints.names


@pytest.mark.slow
@pytest.mark.parametrize("target", PACKAGES)
def test_maintainer_and_licence_are_the_users(target: str, tmp_path: Path) -> None:
    spec = str(EXAMPLES / "scara.ul")
    options = ["--maintainer", "Ada & Co <ada@lab.org>", "--licence", "MIT"]
    subprocess.run([PROGRAM, "generate", target, spec, "-o", str(tmp_path), *options], check=True, capture_output=True)
    text = (tmp_path / "scara_unity_link" / "package.xml").read_text()
    assert '<maintainer email="ada@lab.org">Ada &amp; Co</maintainer>' in text
    assert "<license>MIT</license>" in text


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["ros1", "--maintainer", "Ada"], "--maintainer 'Ada': a name and an address were expected"),
        (["c", "--licence", "MIT"], "c takes no licence: it is for ros1 and ros2"),
    ],
)
def test_wrong_options_are_one_sentence(arguments: list[str], what: str, tmp_path: Path) -> None:
    target, *options = arguments
    command = [PROGRAM, "generate", target, str(EXAMPLES / "scara.ul"), "-o", str(tmp_path), *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert what in done.stderr
    assert list(tmp_path.iterdir()) == []
