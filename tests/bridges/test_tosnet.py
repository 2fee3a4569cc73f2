"""The paper's figure 1, unchanged, moves the SCARA through the double buffers of a TosNet from ROS 1 and ROS 2."""

from __future__ import annotations

import shutil
import signal
import socket
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from support.bridge_programs import PATIENCE, bridge_on_shared, free_domain, wait_for, wait_until
from support.spec_examples import FIGURE_1
from unity_link import blocking
from unity_link.generate import generate, write
from unity_link.protocol.wire.numbers import to_signed
from unity_link.spec import compile_text

if TYPE_CHECKING:
    from collections.abc import Iterator

pytestmark = pytest.mark.slow
needs_ros = pytest.mark.skipif(
    shutil.which("roslaunch") is None or shutil.which("rosmaster") is None,
    reason="needs ROS 1: apt install python3-rospy python3-roslaunch python3-rosmaster python3-sensor-msgs",
)
GATEWAYS = ["sim:tosnet", pytest.param("rtl:tosnet", marks=pytest.mark.rtl)]
GIVEN = ("--give", "ctrl=0xF0", "--give", "comm=0xF4")
SET_POINTS = {"j1": 1200, "j2": -700, "j3": 345, "j4": 2000}
"""In counts."""
POSITIONS = range(0x88, 0x8C)
PEER = str(Path(__file__).with_name("dds_peer.py"))
SYSTEM_PYTHON = "/usr/bin/python3"
TALKER = """
import sys, time, rospy
from std_msgs.msg import Int32
rospy.init_node("talker", anonymous=True, disable_signals=True)
for given in sys.argv[1:]:
    topic, value = given.split("=")
    publisher = rospy.Publisher(topic, Int32, tcp_nodelay=True, queue_size=None)
    while not publisher.get_num_connections():
        time.sleep(0.01)
    publisher.publish(Int32(int(value)))
time.sleep(0.5)
"""


@pytest.fixture
def spec(tmp_path: Path) -> str:
    path = tmp_path / "figure_1.ul"
    path.write_text(FIGURE_1)
    return str(path)


@pytest.fixture
def ros(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Run a ROS master for all processes of the test."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    monkeypatch.setenv("ROS_MASTER_URI", f"http://127.0.0.1:{port}")
    monkeypatch.setenv("ROS_IP", "127.0.0.1")
    monkeypatch.setenv("ROS_HOME", str(tmp_path))
    with subprocess.Popen(["rosmaster", "--core", "-p", str(port)], stdout=subprocess.DEVNULL) as process:
        try:
            wait_until(lambda: is_listening(port))
            yield
        finally:
            process.kill()


def is_listening(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def wait_for_the_motors(url: str) -> None:
    with blocking.connect(url) as link:
        wait_until(lambda: [to_signed(link.read(at), 32) for at in POSITIONS] == list(SET_POINTS.values()))


def talk_to_ros_1() -> None:
    topics = [f"/scara/{joint}/pos_sp={value}" for joint, value in SET_POINTS.items()]
    subprocess.run([SYSTEM_PYTHON, "-W", "ignore", "-c", TALKER, *topics], timeout=PATIENCE, check=True)


@needs_ros
@pytest.mark.parametrize("gateway", GATEWAYS)
@pytest.mark.usefixtures("ros")
def test_figure_1_moves_the_motors_from_ros_1(gateway: str, spec: str, tmp_path: Path) -> None:
    with bridge_on_shared("ros1", spec, gateway, tmp_path, *GIVEN) as (process, url):
        wait_for(process, "node /unity_link_scara")
        talk_to_ros_1()
        wait_for_the_motors(url)


@needs_ros
@pytest.mark.usefixtures("ros")
def test_a_launch_file_takes_the_parameters(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(generate("ros1", compile_text(FIGURE_1)), tmp_path / "packages")
    monkeypatch.setenv("ROS_PACKAGE_PATH", f"{tmp_path / 'packages'}:/usr/share")
    # The Python of ROS has no Unity-Link: the package finds another Python that has it, on the path.
    program, place = str(Path(sys.executable).parent / "unity-link"), tmp_path / "gateway"
    monkeypatch.delenv("PYTHONPATH", raising=False)
    monkeypatch.setenv("PATH", f"/usr/bin:/bin:{Path(program).parent}")
    with subprocess.Popen([program, "serve", "sim:tosnet", "--unix", str(place)], stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        url = server.stdout.readline().decode().strip()
        arguments = ["scara_unity_link", "scara.launch", f"link:={url}", "options:=--give ctrl=0xF0 --give comm=0xF4"]
        with subprocess.Popen(
            [SYSTEM_PYTHON, shutil.which("roslaunch") or "", *arguments],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        ) as launched:
            try:
                wait_for(launched, "node /unity_link_scara")
                talk_to_ros_1()
                wait_for_the_motors(url)
            finally:
                launched.send_signal(signal.SIGINT)
                launched.communicate(timeout=PATIENCE)
                server.terminate()


@pytest.mark.parametrize("gateway", GATEWAYS)
def test_figure_1_moves_the_motors_from_ros_2(gateway: str, spec: str, tmp_path: Path) -> None:
    domain = str(free_domain())
    with bridge_on_shared("ros2", spec, gateway, tmp_path, "--domain", domain, *GIVEN) as (process, url):
        wait_for(process, "at /scara")
        peers = [
            subprocess.Popen(
                [sys.executable, PEER, domain, "talk", f"rt/scara/{joint}/pos_sp", "std_msgs/msg/Int32", str(value)]
            )
            for joint, value in SET_POINTS.items()
        ]
        assert [peer.wait(PATIENCE) for peer in peers] == [0] * len(peers)
        wait_for_the_motors(url)
