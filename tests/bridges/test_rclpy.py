"""The bridge to ROS 2 as real nodes of rclpy see it, for each distribution that `make ros-venvs` has installed."""

from __future__ import annotations

import math
import os
import re
import signal
import subprocess
import sys
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from support.bridge_programs import FAST_GATEWAY, FAST_SPEC, PATIENCE, PROGRAM, wait_for, wait_until
from support.rclpy_peers import PYTHONS, Ros
from unity_link import blocking
from unity_link.bridges.ros_settings import Quality
from unity_link.generate import generate, write
from unity_link.spec import compile_file

if TYPE_CHECKING:
    from collections.abc import Iterator

    from support.rclpy_peers import Node

pytestmark = pytest.mark.slow
SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
GATEWAY = "sim:scara?base_frequency_millihertz=20000000"
TRANSPORTS = ["dds", "rclpy"]
STATES = ("/scara/joint_states", "sensor_msgs/JointState")
LOOPBACK = (
    '<CycloneDDS><Domain><General><Interfaces><NetworkInterface name="lo"/></Interfaces>'
    "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>"
    '<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>'
)


@pytest.fixture(params=PYTHONS)
def ros(request: pytest.FixtureRequest) -> Ros:
    return Ros(request.param)


@pytest.fixture(params=TRANSPORTS)
def transport(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@contextmanager
def served(folder: Path, gateway: str = GATEWAY) -> Iterator[str]:
    """Share a gateway, so that the test can read the written values; yield its URL."""
    with subprocess.Popen(
        [PROGRAM, "serve", gateway, "--unix", str(folder / "gateway")], stdout=subprocess.PIPE, text=True
    ) as server:
        assert server.stdout is not None
        try:
            yield server.stdout.readline().strip()
        finally:
            server.terminate()


def move(node: Node, topic: str, kind: str, message: dict[str, Any], obeyed: Any) -> None:
    """Publish a set point until the robot has it: the subscriber may match shortly after the publisher does."""

    def is_obeyed() -> bool:
        node.publish(topic, kind, [message])
        return bool(obeyed())

    wait_until(is_obeyed)


def counts(degrees: float) -> int:
    return round(degrees / (360 / 200_000)) % (1 << 32)


@pytest.mark.parametrize("quality", Quality)
def test_every_topic_is_heard_and_set_points_are_obeyed(
    ros: Ros, transport: str, quality: Quality, tmp_path: Path
) -> None:
    of_samples = "sensor_data" if quality is Quality.SENSOR_DATA else "default"
    with (
        served(tmp_path) as url,
        ros.bridge(transport, SPEC, "--link", url, "--quality", quality) as bridge,
        ros.node() as node,
        blocking.connect(url) as link,
    ):
        wait_for(bridge, "8 topics published, 11 subscribed to at /scara")
        numbers = [f"/scara/j{joint}/{signal}" for joint in (1, 2, 3, 4) for signal in ("cpos", "spd")]
        for topic in numbers:
            node.listen(topic, "std_msgs/Float64", quality=of_samples)
        node.listen(*STATES, quality=of_samples)
        node.listen("/diagnostics", "diagnostic_msgs/DiagnosticArray")
        set_points = "/scara/joint_commands", "sensor_msgs/JointState"
        move(node, *set_points, {"name": ["j2"], "position": [-0.5]}, lambda: link.read(0x8D))
        array = {"data": [0.25, math.nan, 0.05, 1]}
        move(node, "/scara/position_commands", "std_msgs/Float64MultiArray", array, lambda: link.read(0x8E) == 20_000)
        move(node, "/scara/j1/pos_sp", "std_msgs/Float64", {"data": 30.0}, lambda: link.read(0x8C) == counts(30))
        assert link.read(0x8D) == counts(-0.5 * 180 / math.pi)
        for topic in [*numbers, STATES[0], "/diagnostics"]:
            assert node.heard(topic), topic
        (status, *_) = node.heard("/diagnostics")[-1]["status"]
        assert status["name"] == "unity_link_scara: link"
        names = node.graph()["nodes"]
        assert names.count("/unity_link_scara") == (transport == "rclpy")


@pytest.mark.parametrize("network", [(), ("--network",)])
def test_own_configurations_of_cyclone_match_types_with_sequences(
    ros: Ros, network: tuple[str, ...], tmp_path: Path
) -> None:
    with (
        served(tmp_path) as url,
        ros.bridge("dds", SPEC, "--link", url, *network, CYCLONEDDS_URI=LOOPBACK) as bridge,
        ros.node() as node,
    ):
        wait_for(bridge, "at /scara")
        node.listen(*STATES)
        assert node.heard(STATES[0])


def test_of_two_robots_in_two_namespaces_one_set_point_moves_one(ros: Ros, transport: str, tmp_path: Path) -> None:
    with ExitStack() as stack:
        links = []
        for name in ("left", "right"):
            (tmp_path / name).mkdir()
            url = stack.enter_context(served(tmp_path / name))
            words = "--ros-args", "-r", f"__ns:=/{name}", "-r", "scara/j2/pos_sp:=elbow", "-p", f"link:={url}"
            wait_for(stack.enter_context(ros.bridge(transport, SPEC, *words)), f"at /{name}/scara")
            links.append(stack.enter_context(blocking.connect(url)))
        node = stack.enter_context(ros.node())
        node.listen("/left/scara/joint_states", "sensor_msgs/JointState")
        move(node, "/left/scara/j1/pos_sp", "std_msgs/Float64", {"data": 30.0}, lambda: links[0].read(0x8C))
        move(node, "/left/elbow", "std_msgs/Float64", {"data": 12.0}, lambda: links[0].read(0x8D))
        assert links[1].read_block(0x8C, 2).tolist() == [0, 0]
        assert node.heard("/left/scara/joint_states")


def test_an_int_in_the_place_of_a_float_moves_nothing_and_is_explained(
    ros: Ros, transport: str, tmp_path: Path
) -> None:
    unchecked = {name: "" for name in os.environ if name == "ROS_PYTHON_CHECK_FIELDS"}
    with (
        served(tmp_path) as url,
        ros.bridge(transport, SPEC, "--link", url) as bridge,
        ros.node(**unchecked) as node,
        blocking.connect(url) as link,
    ):
        wait_for(bridge, "at /scara")
        topic = "/scara/j1/pos_sp", "std_msgs/Float64"
        move(node, *topic, {"data": 30.0}, lambda: link.read(0x8C) == counts(30))
        node.publish(*topic, [{"data": 20}])
        said = wait_for(bridge, "ROS_PYTHON_CHECK_FIELDS=1")
        assert "j1.pos_sp: 4e-323 is subnormal" in said
        assert "[ERROR]" in said or transport == "dds"
        assert link.read(0x8C) == counts(30)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("-p poll_hz:=fast", "a parameter is wrong: Expected `float | null`, got `str` - at `$.poll_hz`"),
        ("-p pol_hz:=5", "a parameter is wrong: Object contains unknown field `pol_hz`"),
        ("-p domain:=5", "domain is no parameter of a node of rclpy: --domain was expected"),
    ],
)
def test_a_wrong_parameter_of_a_node_is_one_sentence(ros: Ros, words: str, message: str) -> None:
    with ros.bridge("rclpy", SPEC, "--link", "sim:scara", "--ros-args", *words.split()) as bridge:
        _, told = bridge.communicate(timeout=PATIENCE)
    assert bridge.returncode == 2
    assert told.startswith(f"error: {message}")
    assert told.count("\n") == 1


def test_a_node_has_its_settings_as_parameters_and_takes_integers_for_floats(ros: Ros) -> None:
    words = "-r", "__node:=arm", "-p", "poll_hz:=5", "-p", "topics.j1/cpos.quality:=sensor_data"
    with ros.bridge("rclpy", SPEC, "--link", "sim:scara", "--ros-args", *words) as bridge, ros.node() as node:
        # With poll_hz, the bridge also publishes signals that no group samples.
        wait_for(bridge, "16 topics published")
        request = {"names": ["poll_hz", "link", "quality"]}
        answer = node.call(service="/arm/get_parameters", kind="rcl_interfaces/GetParameters", request=request)
        values = answer["values"]
        assert [values[0]["integer_value"], values[1]["string_value"], values[2]["string_value"]] == [
            5,
            "sim:scara",
            "reliable",
        ]


def test_a_second_bridge_at_the_same_topics_is_refused(ros: Ros, transport: str) -> None:
    with ros.bridge(transport, SPEC, "--link", "sim:scara") as first:
        wait_for(first, "at /scara")
        with ros.bridge(transport, SPEC, "--link", "sim:scara") as second:
            said = wait_for(second, "another bridge is at /scara, and both would write")
            # After slow discovery, the bridge has started already, and reports this as an error of its node.
            assert "[ERROR]" in said or second.wait(PATIENCE) == 1


def test_twenty_thousand_joint_states_at_1_khz_all_arrive(ros: Ros, transport: str) -> None:
    with (
        ros.bridge(transport, SPEC, "--link", "sim:scara?base_frequency_millihertz=100000000") as bridge,
        ros.node() as node,
    ):
        wait_for(bridge, "at /scara")
        node.listen(*STATES, quality="all")
        for count in range(1_000, 21_000, 1_000):
            wait_until(lambda count=count: node.heard_count(STATES[0]) >= count)  # type: ignore[misc]
        # On a busy machine, the node may be seconds late. The bridge waits only a few seconds at its end.
        assert node.heard_recent(STATES[0], seconds=0.5)
        bridge.send_signal(signal.SIGINT)
        summary = wait_for(bridge, "messages sent")
        sent = int(re.search("([0-9,]+) messages sent", summary)[1].replace(",", ""))  # type: ignore[index]
        wait_until(lambda: node.heard_count(STATES[0]) >= sent)
        # A busy machine loses samples before they become messages.
        assert node.heard_count(STATES[0]) == sent


def test_a_slow_subscriber_delays_the_end_of_a_bridge_by_seconds(ros: Ros, transport: str, tmp_path: Path) -> None:
    spec = tmp_path / "bench.ul"
    spec.write_text(FAST_SPEC)
    with ros.bridge(transport, str(spec), "--link", FAST_GATEWAY) as bridge, ros.node() as node:
        wait_for(bridge, "at /bench")
        # Each message is confirmed just in time; the samples that wait for it would need a quarter of an hour.
        node.listen("/bench/value", "std_msgs/Float64", quality="all", seconds=0.02)
        wait_until(lambda: node.heard_count("/bench/value") >= 200)
        bridge.send_signal(signal.SIGINT)
        wait_for(bridge, "messages sent")
        assert bridge.wait(PATIENCE) == 130


def test_a_generated_package_is_built_and_started_in_two_namespaces(ros: Ros, tmp_path: Path) -> None:
    write(generate("ros2", compile_file(SPEC)), tmp_path / "src")
    python, site = PYTHONS[ros.distribution], str(tmp_path / "site")
    build = ["-m", "uv", "pip", "install", "--quiet", "--offline", "--no-deps", "--no-build-isolation"]
    package = str(tmp_path / "src" / "scara_unity_link")
    subprocess.run([sys.executable, *build, "--python", python, "--target", site, package], check=True)
    path = f"{Path(python).parent}:{os.environ['PATH']}"
    environment = ros.environment | {"PYTHONPATH": f"{site}:{os.environ.get('PYTHONPATH', '')}", "PATH": path}
    parameters = f"{site}/share/scara_unity_link/config/scara.yaml"
    with ExitStack() as stack:
        links = []
        for name in ("left", "right"):
            (tmp_path / name).mkdir()
            url = stack.enter_context(served(tmp_path / name))
            # A launch file with a namespace starts the bridge like this.
            words = "-r", "__node:=unity_link_scara", "-r", f"__ns:=/{name}", "--params-file", parameters
            process = subprocess.Popen(
                [f"{site}/bin/bridge", "--ros-args", *words, "-p", f"link:={url}"],
                stderr=subprocess.PIPE,
                text=True,
                env=environment,
            )
            stack.callback(process.communicate)
            stack.callback(process.kill)
            wait_for(process, f"at /{name}/scara")
            links.append(stack.enter_context(blocking.connect(url)))
        node = stack.enter_context(ros.node())
        move(node, "/left/scara/j1/pos_sp", "std_msgs/Float64", {"data": 30.0}, lambda: links[0].read(0x8C))
        assert links[1].read(0x8C) == 0
        wait_until(lambda: {"/left/unity_link_scara", "/right/unity_link_scara"} <= set(node.graph()["nodes"]))
    test = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"{package}/test"]
    subprocess.run(test, env={**os.environ, "PATH": path}, check=True, stdout=subprocess.DEVNULL, cwd=package)
