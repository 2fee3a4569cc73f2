"""Generated packages of ROS: roslaunch starts that of ROS 1; `bridges/test_rclpy` builds and starts that of ROS 2."""

from __future__ import annotations

import ast
import math
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree as ET

import pytest
import yaml

from gateware.bench.network.tap import URL
from support.bridge_programs import PROGRAM, wait_until
from unity_link import blocking
from unity_link.bridges.topic_names import topic_names
from unity_link.generate import generate, write
from unity_link.spec import compile_file, compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator

    from gateware.bench.network.tap import Plugged

EXAMPLES = Path(__file__).parents[2] / "examples"
PATIENCE = 60
J2_TO_HALF_A_RADIAN = ("/scara/joint_commands", "sensor_msgs/JointState", "{name: [j2], position: [0.5]}")
HALF_A_RADIAN = round(0.5 * 180 / math.pi / (360 / 200_000))
"""Half a radian in counts of the joint."""
pytest_plugins = ["gateware.bench.network.fixtures"]

needs_ros = pytest.mark.skipif(
    shutil.which("roslaunch") is None or shutil.which("rostopic") is None,
    reason="needs ROS 1: apt install python3-rospy python3-roslaunch python3-rostopic python3-sensor-msgs",
)


@contextmanager
def served(folder: Path, gateway: str) -> Iterator[str]:
    with subprocess.Popen(
        [PROGRAM, "serve", gateway, "--unix", str(folder / "gateway")], stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        yield server.stdout.readline().strip()
        server.terminate()


@pytest.fixture
def packages(tmp_path: Path) -> dict[str, Path]:
    spec = compile_file(EXAMPLES / "scara.ul")
    for target in ("ros1", "ros2"):
        write(generate(target, spec), tmp_path / target)
    return {target: tmp_path / target / "scara_unity_link" for target in ("ros1", "ros2")}


@pytest.fixture
def environment(tmp_path: Path, packages: dict[str, Path]) -> dict[str, str]:
    """Return an environment in which ROS finds the package; its Python has no Unity-Link, and ours is on the path."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    return {
        **os.environ,
        "ROS_MASTER_URI": f"http://127.0.0.1:{port}",
        "ROS_IP": "127.0.0.1",
        "ROS_HOME": str(tmp_path / "ros"),
        "ROS_PACKAGE_PATH": f"{packages['ros1'].parent}:/usr/share",
        "PATH": f"/usr/bin:/bin:{Path(PROGRAM).parent}",
        "PYTHONPATH": "",
    }


def rostopic(environment: dict[str, str], *arguments: str) -> str:
    command = ["rostopic", *arguments]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=True)
    return done.stdout


@contextmanager
def launched(environment: dict[str, str], *arguments: str) -> Iterator[None]:
    """Run the node of the package by roslaunch; the block begins when its gateway has answered."""
    with subprocess.Popen(
        ["/usr/bin/python3", "-u", shutil.which("roslaunch") or "", "scara_unity_link", "scara.launch", *arguments],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        # roslaunch does not end when a node ends.
        late = threading.Timer(PATIENCE, process.kill)
        late.start()
        try:
            assert process.stderr is not None
            assert any("node /unity_link_scara" in line for line in process.stderr)
            late.cancel()
            yield
        finally:
            late.cancel()
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=PATIENCE)


@needs_ros
@pytest.mark.slow
def test_roslaunch_starts_the_node_of_a_generated_package(environment: dict[str, str], tmp_path: Path) -> None:
    with (
        served(tmp_path, "sim:scara") as url,
        launched(environment, f"link:={url}", "options:=--frame-id base --poll 10"),
        blocking.connect(url) as link,
    ):
        told = rostopic(environment, "pub", "-1", *J2_TO_HALF_A_RADIAN)
        wait_until(lambda: link.read(0x8D) == HALF_A_RADIAN)
        said = rostopic(environment, "echo", "-n1", "/scara/joint_states")
        polled = rostopic(environment, "echo", "-n1", "/scara/j2/pos_sp")
    assert "publishing" in told
    assert 'frame_id: "base"' in said
    assert polled.split()[1].startswith("28.6")


@needs_ros
@pytest.mark.slow
def test_node_samples_and_moves_shared_gateware_on_rmii(
    environment: dict[str, str], tmp_path: Path, gateway: Plugged
) -> None:
    gateway.call("poke", 0x89, HALF_A_RADIAN)
    with served(tmp_path, URL) as url, launched(environment, f"link:={url}?map=any"):
        rostopic(environment, "pub", "-1", *J2_TO_HALF_A_RADIAN)
        wait_until(gateway.written)
        said = rostopic(environment, "echo", "-n1", "/scara/joint_states")
    assert gateway.written() == [(0x8D, HALF_A_RADIAN)]
    (positions,) = [line for line in said.splitlines() if line.startswith("position:")]
    assert [round(float(number), 4) for number in positions[len("position: [") : -1].split(",")] == [0, 0.5, 0, 0]


def test_a_package_of_ros_1_says_what_catkin_must_know(packages: dict[str, Path]) -> None:
    folder = packages["ros1"]
    package: Any = ET.parse(folder / "package.xml").getroot()
    launch: Any = ET.parse(folder / "launch" / "scara.launch").getroot()
    assert package.findtext("name") == "scara_unity_link"
    assert launch.find("node").get("type") == "bridge"
    assert os.access(folder / "scripts" / "bridge", os.X_OK)
    assert (folder / "scripts" / "scara.ul").is_file()
    assert "test/test_spec.py" in {str(path.relative_to(folder)) for path in folder.rglob("*")}


@pytest.mark.parametrize("target", ["ros1", "ros2"])
def test_the_program_of_a_package_becomes_the_bridge_with_its_spec(target: str, packages: dict[str, Path]) -> None:
    place = "scripts/bridge" if target == "ros1" else "scara_unity_link/bridge.py"
    program = [sys.executable, str(packages[target] / place), "--link", "nosuch:", "--help"]
    done = subprocess.run(program, capture_output=True, text=True, timeout=PATIENCE, check=True)
    assert f"unity-link {target} [OPTIONS]" in " ".join(done.stdout.split())
    copy = compile_file(packages[target] / place.rpartition("/")[0] / "scara.ul").interface()
    assert copy.fingerprint == compile_file(EXAMPLES / "scara.ul").interface().fingerprint


def test_a_package_has_the_maps_of_own_cores_and_given_addresses(tmp_path: Path) -> None:
    core = tmp_path / "cores" / "blinker"
    core.mkdir(parents=True)
    (core / "blinker.ul").write_text('BLINKER(): @(BASE) { ENTITY("blinker"); @period = BASE: unsigned READWRITE(); }')
    spec = tmp_path / "lamp.ul"
    spec.write_text("public lamp() { left: BLINKER() @(0x10); }")
    scara = compile_file(EXAMPLES / "scara.ul").given({"ctrl": 0xF0, "comm": 0xF4})
    for target, place in (("ros1", "scripts"), ("ros2", "lamp_unity_link")):
        write(generate(target, compile_file(spec)), tmp_path / target)
        write(generate(target, scara), tmp_path / target)
        folder = tmp_path / target / "lamp_unity_link"
        assert "left.period" in compile_file(folder / place / "lamp.ul").interface().signals
    launch = (tmp_path / "ros1/scara_unity_link/launch/scara.launch").read_text()
    assert "--give ctrl=240 --give comm=244" in launch
    parameters = yaml.safe_load((tmp_path / "ros2/scara_unity_link/config/scara.yaml").read_text())
    assert parameters["/**"]["ros__parameters"]["given"] == {"ctrl": 0xF0, "comm": 0xF4}


def test_a_package_of_ros_2_says_what_colcon_must_know(packages: dict[str, Path]) -> None:
    folder = packages["ros2"]
    package: Any = ET.parse(folder / "package.xml").getroot()
    parameters = yaml.safe_load((folder / "config" / "scara.yaml").read_text())
    assert package.findtext("export/build_type") == "ament_python"
    assert (folder / "resource" / "scara_unity_link").is_file()
    assert parameters["/**"]["ros__parameters"]["namespace"] == "scara"
    for path in folder.rglob("*.py"):
        ast.parse(path.read_text(), str(path))


@pytest.mark.parametrize("target", ["ros1", "ros2"])
def test_every_file_names_the_spec_and_its_hash(target: str) -> None:
    spec = compile_file(EXAMPLES / "walker.ul")
    files = [file for file in generate(target, spec) if file.text]
    assert files == [file for file in generate(target, spec) if file.text]
    for file in files:
        assert spec.sources[0].sha256 in file.text, file.name
        assert not any(line.endswith(" ") for line in file.text.splitlines()), file.name


@pytest.mark.parametrize("target", ["ros1", "ros2"])
def test_a_description_with_signs_of_xml_and_quotes_stays_a_description(target: str, tmp_path: Path) -> None:
    spec = compile_text('/// Arm <1> & "two" -- and \\ more.\npublic Arm() { @a = 1: READ(POLL(1)); }')

    write(generate(target, spec), tmp_path)

    package: Any = ET.parse(tmp_path / "arm_unity_link" / "package.xml").getroot()
    assert package.findtext("description") == 'Arm <1> & "two" -- and \\ more.'
    for path in tmp_path.rglob("*"):
        if path.is_file() and (path.suffix == ".py" or path.name == "bridge"):
            ast.parse(path.read_text(), str(path))


@pytest.mark.parametrize(("interface", "package"), [("Arm_", "arm"), ("_9x", "x9x"), ("__", "x")])
def test_the_name_of_a_package_begins_with_a_letter(interface: str, package: str) -> None:
    spec = compile_text(f"public {interface}() {{ @a = 1: READ(); }}")
    for target in ("ros1", "ros2"):
        assert {file.name.partition("/")[0] for file in generate(target, spec)} == {f"{package}_unity_link"}


def test_joints_of_the_interface_itself_have_its_name() -> None:
    spec = compile_text(
        "group g(1, 10, JOINTS(POSITION=pos));\n"
        "public motor() { @pos = 1: READ(PUBLISH(g)); knee: joint() @(2); motor: joint() @(3); }\n"
        "joint(): @(base) { @pos = base: READ(PUBLISH(g)); }"
    )
    names = topic_names(spec.interface())
    assert [names[joint.name] for joint in spec.interface().groups[0].joints] == ["motor_2", "knee", "motor"]
    assert names["pos"] == "pos"
