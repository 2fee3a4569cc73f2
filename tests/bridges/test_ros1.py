"""The bridge to ROS 1 with the real ROS 1: a rosmaster, nodes of rospy, and `rostopic`."""

from __future__ import annotations

import contextlib
import importlib
import io
import itertools
import json
import math
import shutil
import signal
import socket
import struct
import subprocess
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from support.bridge_programs import (
    FAST_GATEWAY,
    FAST_SPEC,
    PATIENCE,
    Noted,
    bridge_on_shared,
    line_of,
    program,
    wait_for,
    wait_until,
)
from support.own_robots import OWN
from unity_link import ConnectError, blocking, load
from unity_link.bridges.ros1 import environment
from unity_link.bridges.ros_rows import number_rows, stamped_rows
from unity_link.bridges.topics import joint_fields
from unity_link.data.blocking import put

if TYPE_CHECKING:
    from collections.abc import Iterator

SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
SYSTEM_PYTHON = "/usr/bin/python3"
GATEWAY = "sim:scara?base_frequency_millihertz=20000000"

needs_ros = pytest.mark.skipif(
    shutil.which("rosmaster") is None or shutil.which("rostopic") is None,
    reason="needs ROS 1: apt install python3-rospy python3-rostopic python3-rosmaster python3-sensor-msgs",
)
pytestmark = needs_ros

LISTENER = """
import json, sys, threading, rospy
from sensor_msgs.msg import JointState
seen, enough = [], threading.Event()
def take(message):
    seen.append((message.header.seq, message.header.stamp.to_nsec(), message.name, message.position))
    if len(seen) >= int(sys.argv[1]):
        enough.set()
rospy.init_node("listener", anonymous=True, disable_signals=True)
rospy.Subscriber("/scara/joint_states", JointState, take, tcp_nodelay=True)
enough.wait(60)
print(json.dumps(seen))
"""
TALKER = """
import sys, time, rospy
from std_msgs.msg import Float64
rospy.init_node("talker", anonymous=True, disable_signals=True)
publisher = rospy.Publisher("/scara/j1/pos_sp", Float64, tcp_nodelay=True, queue_size=None)
while not publisher.get_num_connections():
    time.sleep(0.01)
for value in map(float, sys.argv[1:]):
    publisher.publish(Float64(value))
time.sleep(0.5)
"""

JOINT_TALKER = """
import json, sys, time, rospy
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64MultiArray
rospy.init_node("talker", anonymous=True, disable_signals=True)
states = rospy.Publisher("/scara/joint_commands", JointState, tcp_nodelay=True, queue_size=None)
arrays = rospy.Publisher("/scara/position_commands", Float64MultiArray, tcp_nodelay=True, queue_size=None)
while not (states.get_num_connections() and arrays.get_num_connections()):
    time.sleep(0.01)
for state in json.loads(sys.argv[1]):
    states.publish(JointState(**state))
time.sleep(0.5)
arrays.publish(Float64MultiArray(data=json.loads(sys.argv[2])))
time.sleep(0.5)
"""
DIAGNOSTICS_LISTENER = """
import json, threading, rospy
from genpy.dynamic import generate_dynamic
seen, enough = [], threading.Event()
def take(message):
    seen.append(message)
    enough.set()
rospy.init_node("listener", anonymous=True, disable_signals=True)
rospy.Subscriber("/diagnostics", rospy.AnyMsg, take)
enough.wait(60)
told = seen[0]._connection_header
kind = generate_dynamic(told["type"], told["message_definition"])[told["type"]]
(status,) = kind().deserialize(seen[0]._buff).status
values = {one.key: one.value for one in status.values}
fields = [status.level, status.name, status.message, status.hardware_id]
print(json.dumps({"sum": told["md5sum"], "status": fields, "values": values}))
"""
SCALES = [360 / 200_000, 360 / 200_000, 10 / 4000, 360 / 80_000]
"""Degrees (joint 3: millimetres) per count, of the joints of the SCARA."""

COUNTING_LISTENER = """
import sys, threading, rospy
from std_msgs.msg import Float64
seen, enough = [0], threading.Event()
def take(message):
    if seen[0] == 0:
        print("listening", flush=True)
    seen[0] += 1
    if seen[0] >= int(sys.argv[1]):
        enough.set()
rospy.init_node("listener", anonymous=True, disable_signals=True)
rospy.Subscriber("/bench/value", Float64, take, tcp_nodelay=True)
enough.wait(600)
print(seen[0] >= int(sys.argv[1]))
"""
COUNTER = """
import itertools, time, rospy
from std_msgs.msg import UInt32
rospy.init_node("counter", anonymous=True, disable_signals=True)
publisher = rospy.Publisher("/plain/target", UInt32, tcp_nodelay=True, queue_size=None)
while not publisher.get_num_connections():
    time.sleep(0.01)
for value in itertools.count():
    publisher.publish(UInt32(value))
    time.sleep(0.001)
"""


@pytest.fixture
def ros(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """Choose a port for the master; each process of the test gets it from the environment."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        port: int = free.getsockname()[1]
    monkeypatch.setenv("ROS_MASTER_URI", f"http://127.0.0.1:{port}")
    monkeypatch.setenv("ROS_IP", "127.0.0.1")
    monkeypatch.setenv("ROS_HOME", str(tmp_path))
    return port


@contextmanager
def master(port: int) -> Iterator[None]:
    with subprocess.Popen(["rosmaster", "--core", "-p", str(port)], stdout=subprocess.DEVNULL) as process:
        wait_until(lambda: is_listening(port))
        try:
            yield
        finally:
            process.kill()


def is_listening(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


def peer(script: str, *arguments: str) -> str:
    result = subprocess.run(
        [SYSTEM_PYTHON, "-W", "ignore", "-c", script, *arguments],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=True,
    )
    return result.stdout


def rostopic(*arguments: str) -> str:
    return subprocess.run(["rostopic", *arguments], capture_output=True, text=True, timeout=PATIENCE, check=True).stdout


def with_length(message: Any) -> bytes:
    """Return a message as rospy serialises it, after its length."""
    buffer = io.BytesIO()
    message.serialize(buffer)
    return struct.pack("<I", len(buffer.getvalue())) + buffer.getvalue()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("Bool", True),
        *((f"{sign}Int{bits}", (1 << (bits - 1)) - 1) for sign in ("", "U") for bits in (8, 16, 32, 64)),
        ("Float32", 1.5),
        ("Float64", -2.25),
    ],
)
def test_a_standard_message_is_the_bytes_that_rospy_gives_it(name: str, value: float) -> None:
    environment.find_rospy()
    message = getattr(importlib.import_module("std_msgs.msg"), name)(data=value)

    rows = number_rows(name, np.array([value, value]), cdr=False)

    assert rows.tobytes() == 2 * with_length(message)


@pytest.mark.slow
@given(
    names=st.lists(st.text(max_size=9), max_size=4),
    there=st.tuples(st.booleans(), st.booleans(), st.booleans()),
    frame_id=st.sampled_from(["", "base", "base_link"]),
)
def test_the_states_of_joints_are_the_bytes_that_rospy_gives_them(
    names: list[str], there: tuple[bool, ...], frame_id: str
) -> None:
    environment.find_rospy()
    genpy, messages = importlib.import_module("genpy"), importlib.import_module("sensor_msgs.msg")
    parts = {
        part: np.arange(2 * len(names) * given, dtype=float).reshape(2, -1)
        for part, given in zip(("position", "velocity", "effort"), there, strict=True)
    }
    theirs = b""
    for number, at in enumerate((12.5, 12.75)):
        message = messages.JointState(name=names, **{part: column[number].tolist() for part, column in parts.items()})
        message.header.seq, message.header.stamp = 7 + number, genpy.Time.from_sec(at)
        message.header.frame_id = frame_id
        theirs += with_length(message)

    ours = stamped_rows(np.array([12.5, 12.75]), joint_fields(names, parts), frame_id, 7)
    assert ours.tobytes() == theirs


@pytest.mark.slow
def test_signals_are_topics_of_their_types_and_commands_are_subscribed_to(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, _):
        said = wait_for(process, "node /unity_link_scara")

        topics = rostopic("list").split()
        types = [rostopic("type", topic).strip() for topic in ("/scara/j1/cpos", "/scara/j4/pos_sp")]

        assert "8 topics published, 11 subscribed to at /scara" in said
        assert {"/scara/j1/cpos", "/scara/j4/spd", "/scara/j2/pos_sp", "/scara/joint_states"} <= set(topics)
        assert types == ["std_msgs/Float64", "std_msgs/Float64"]
        assert rostopic("echo", "-n1", "/scara/j1/cpos").split()[:2] == ["data:", "0.0"]


@pytest.mark.slow
def test_a_robot_of_ones_own_has_its_topics(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", OWN["sim"].spec, OWN["sim"].url, tmp_path) as (process, _):
        wait_for(process, "node /unity_link_scara")
        assert 0 < float(rostopic("echo", "-n1", "/scara/j1/cpos").split()[1]) < 1.001


@pytest.mark.slow
def test_samples_arrive_once_in_order_with_the_gateways_distances_in_time(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, _):
        wait_for(process, "node /unity_link_scara")

        seen = json.loads(peer(LISTENER, "1000"))

    sequence = [number for number, *_ in seen]
    distances = [later[1] - earlier[1] for earlier, later in itertools.pairwise(seen)]
    assert sequence == list(range(sequence[0], sequence[0] + len(seen)))
    assert seen[0][2] == ["j1", "j2", "j3", "j4"]
    # Within a batch, distances are those of the gateway's clock; between batches, the arrival has an influence.
    exact = [distance for distance in distances if abs(distance - 5_000_000) < 1000]
    assert len(exact) > 0


@pytest.mark.slow
def test_values_on_a_topic_are_written_in_order_and_bad_ones_reported(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, url):
        wait_for(process, "node /unity_link_scara")

        peer(TALKER, *(str(value / 10) for value in range(200)), "500", "25")

        said = wait_for(process, "outside of its limits")
        with blocking.connect(url) as link:
            wait_until(lambda: link.read(0x8C) == round(25 / (360 / (50 * 4000))))
            process.send_signal(signal.SIGINT)
            summary = wait_for(process, "values written")
        assert process.wait(PATIENCE) == 130
    assert "j1.pos_sp: 500.0 is outside of its limits, -130 to 130 deg" in said
    assert "201 values written" in summary


def test_one_message_sets_all_joints_and_one_that_is_wrong_sets_none(ros: int, tmp_path: Path) -> None:
    options = ("--frame-id", "arm_base")
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path, *options) as (process, url):
        wait_for(process, "node /unity_link_scara")
        wrong = {"name": ["j1", "j3"], "position": [0.1, 5.0]}
        right = {"name": ["j2", "j3"], "position": [-0.5, 0.1], "velocity": [1.0, 0.2]}

        peer(JOINT_TALKER, json.dumps([wrong, right]), "[0.25, NaN, 0.05, 1.0]")

        assert "j3.pos_sp: 5000.0 is outside of its limits, 0 to 150 mm" in wait_for(process, "outside")
        with blocking.connect(url) as link:
            wanted = [0.25 * 180 / math.pi, -0.5 * 180 / math.pi, 50, 180 / math.pi]
            counts = [round(value / scale) for value, scale in zip(wanted, SCALES, strict=True)]
            wait_until(lambda: link.read_block(0x8C, 4).tolist() == [count % (1 << 32) for count in counts])
            assert link.read(0x95) == round(180 / math.pi / SCALES[1])
        assert 'frame_id: "arm_base"' in rostopic("echo", "-n1", "/scara/joint_states")


@pytest.mark.slow
def test_of_two_robots_in_two_namespaces_one_set_point_moves_one(
    ros: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with master(ros), contextlib.ExitStack() as bridges:
        links = []
        for name in ("left", "right"):
            (tmp_path / name).mkdir()
            # roslaunch starts the nodes of a <group ns="left"> like this.
            monkeypatch.setenv("ROS_NAMESPACE", name)
            bridge = bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path / name, "scara/j2/pos_sp:=elbow")
            process, url = bridges.enter_context(bridge)
            wait_for(process, f"node /{name}/unity_link_scara")
            links.append(bridges.enter_context(blocking.connect(url)))
        monkeypatch.delenv("ROS_NAMESPACE")
        peer(TALKER.replace("/scara", "/left/scara"), "25")
        peer(TALKER.replace("/scara/j1/pos_sp", "/left/elbow"), "12")
        wait_until(lambda: links[0].read_block(0x8C, 2).tolist() == [round(v / SCALES[0]) for v in (25, 12)])
        assert links[1].read_block(0x8C, 2).tolist() == [0, 0]


@pytest.mark.slow
def test_a_refused_value_is_an_error_on_rosout(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, _):
        wait_for(process, "node /unity_link_scara")
        peer(TALKER, "500")
        logged = rostopic("echo", "-n1", "/rosout")
    assert "level: 8" in logged
    assert "j1.pos_sp: 500.0 is outside of its limits" in logged


@pytest.mark.slow
def test_diagnostics_tell_of_the_link(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, url):
        wait_for(process, "node /unity_link_scara")

        assert rostopic("type", "/diagnostics").strip() == "diagnostic_msgs/DiagnosticArray"
        seen = json.loads(peer(DIAGNOSTICS_LISTENER))

    assert seen["sum"] == "60810da900de1dd6ddd437c3503511da"
    level, name, message, hardware = seen["status"]
    # A busy machine may have lost samples, or retransmitted a request.
    assert (level, message.partition(" ")[0]) in ((0, "connected"), (1, "samples"))
    assert (name, hardware) == ("unity_link_scara: link", url)
    assert seen["values"]["connected"] == "True"
    assert int(seen["values"]["samples lost"]) >= 0
    assert float(seen["values"]["round trip (ms)"]) > 0


@pytest.mark.slow
def test_the_master_may_come_late_and_go_in_between(ros: int, tmp_path: Path) -> None:
    with bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, _):
        wait_for(process, "waiting for the ROS master")
        with master(ros):
            wait_for(process, "node /unity_link_scara")
            assert json.loads(peer(LISTENER, "10"))
        wait_for(process, "is away")
        with master(ros):
            wait_for(process, "registered with the ROS master again")
            assert json.loads(peer(LISTENER, "10"))


@contextmanager
def node(script: str, *arguments: str) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [SYSTEM_PYTHON, "-W", "ignore", "-c", script, *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


@contextmanager
def bench_bridge(folder: Path, gateway: str) -> Iterator[subprocess.Popen[str]]:
    spec = folder / "bench.ul"
    spec.write_text(FAST_SPEC)
    with program("ros1", str(spec), "--link", gateway) as process:
        wait_for(process, "node /unity_link_bench")
        yield process


def listening_at(process: subprocess.Popen[str]) -> set[str]:
    """Return the addresses at which a program listens for TCP, as Linux writes them."""
    ours = set()
    for file in Path(f"/proc/{process.pid}/fd").iterdir():
        # Some files are closed meanwhile.
        with contextlib.suppress(OSError):
            ours.add(str(file.readlink()))
    lines = [line.split() for name in ("tcp", "tcp6") for line in Path("/proc/net", name).read_text().splitlines()[1:]]
    return {line[1].partition(":")[0] for line in lines if line[3] == "0A" and f"socket:[{line[9]}]" in ours}


@pytest.mark.slow
def test_a_master_that_stands_still_is_away_and_holds_up_no_end(ros: int) -> None:
    command = ["rosmaster", "--core", "-p", str(ros)]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as standing, contextlib.ExitStack() as bridges:
        try:
            wait_until(lambda: is_listening(ros))
            early = bridges.enter_context(program("ros1", SPEC, "--link", GATEWAY))
            wait_for(early, "node /unity_link_scara")
            standing.send_signal(signal.SIGSTOP)
            wait_for(early, "is away: nodes that are connected stay so")
            late = bridges.enter_context(program("ros1", SPEC, "--link", GATEWAY))
            wait_for(late, "waiting for the ROS master")
            for process in (early, late):
                process.send_signal(signal.SIGINT)
                wait_for(process, "values written")
                assert process.wait(PATIENCE) == 130
        finally:
            standing.kill()


@pytest.mark.slow
def test_it_listens_at_this_machine_alone_unless_ros_is_told_otherwise(
    ros: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("ROS_IP")
    with master(ros):
        with bench_bridge(tmp_path, "sim:?data_bits=64") as process, node(COUNTING_LISTENER, "10") as listener:
            assert line_of(listener) == "listening"
            assert listening_at(process) == {"0100007F"}
        monkeypatch.setenv("ROS_HOSTNAME", socket.gethostname())
        with bench_bridge(tmp_path, "sim:?data_bits=64") as process:
            assert listening_at(process) == {"00000000"}


@pytest.mark.slow
def test_a_master_on_another_machine_needs_an_address_of_this_one(ros: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ROS_IP")
    monkeypatch.setenv("ROS_MASTER_URI", "http://192.0.2.1:11311")
    with program("ros1", "examples/scara.ul", "--link", "sim:scara") as process:
        assert "http://192.0.2.1:11311 is not on this machine: set ROS_IP" in wait_for(process, "error")
        assert process.wait(PATIENCE) == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "master_uri", "words"),
    [
        (["--namespace", "a b"], None, "'a b' is no namespace of ROS"),
        (["--namespace", "arm//left"], None, "'arm//left' is no namespace of ROS"),
        (["--namespace", "1st"], None, "'1st' is no namespace of ROS"),
        (["--poll", "inf"], None, "--poll inf: more than 0 Hz was expected"),
        ([], "robot-pc", "ROS_MASTER_URI=robot-pc names no master"),
    ],
)
def test_wrong_use_is_told_in_one_sentence(
    ros: int, arguments: list[str], master_uri: str | None, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    if master_uri is not None:
        monkeypatch.setenv("ROS_MASTER_URI", master_uri)
    with program("ros1", SPEC, "--link", "sim:scara", *arguments) as process:
        assert process.stderr is not None
        assert words in process.stderr.readline()
        assert process.stderr.read() == ""
        assert process.wait(PATIENCE) == 2


@pytest.mark.slow
def test_a_subscriber_that_is_killed_takes_no_sample_from_the_others(ros: int, tmp_path: Path) -> None:
    # Every machine is fast enough for so few samples.
    gateway = FAST_GATEWAY.replace("20000000", "2000000")
    with master(ros), bench_bridge(tmp_path, gateway) as process, node(COUNTING_LISTENER, "20000") as other:
        assert line_of(other) == "listening"
        with node(COUNTING_LISTENER, "1000000000") as killed:
            assert line_of(killed) == "listening"
            killed.kill()
        assert line_of(other) == "True"
        process.send_signal(signal.SIGINT)
        assert " 0 lost" in wait_for(process, "samples published")
        assert process.wait(PATIENCE) == 130


@pytest.mark.slow
def test_subscriber_that_stops_reading_delays_no_other_and_may_resume(ros: int, tmp_path: Path) -> None:
    with (
        master(ros),
        bench_bridge(tmp_path, FAST_GATEWAY) as process,
        node(COUNTING_LISTENER, "600000") as stopped,
        node(COUNTING_LISTENER, "1000000000") as late,
    ):
        assert line_of(stopped) == line_of(late) == "listening"
        stopped.send_signal(signal.SIGSTOP)
        assert "listener" in wait_for(process, "reads /bench/value too slowly: it loses messages")
        with node(COUNTING_LISTENER, "20000") as other:
            assert line_of(other) == "listening"
            assert line_of(other) == "True"
        peer(TALKER.replace("/scara/j1/pos_sp", "/bench/target"), *map(str, range(100)))
        stopped.send_signal(signal.SIGCONT)
        assert line_of(stopped) == "True"

        late.send_signal(signal.SIGSTOP)
        process.send_signal(signal.SIGINT)
        assert "100 values written" in wait_for(process, "values written")
        assert process.wait(PATIENCE) == 130


@pytest.mark.slow
def test_gateway_may_start_late_and_restart_and_no_value_is_written_twice(ros: int, tmp_path: Path) -> None:
    gateway = Noted(tmp_path)
    with master(ros), contextlib.ExitStack() as bridge:
        process = bridge.enter_context(program("ros1", gateway.spec, "--link", gateway.url))
        wait_for(process, "waiting for the gateway")
        with gateway.running():
            wait_for(process, "node /unity_link_plain")
            bridge.enter_context(node(COUNTER))
            gateway.wait_for_more()
        wait_for(process, "the gateway is away")
        with gateway.running():
            wait_for(process, "the gateway is back")
            gateway.wait_for_more()
            assert rostopic("echo", "-n1", "/plain/value").split()[:2] == ["data:", "0"]
            process.send_signal(signal.SIGINT)
            wait_for(process, "values written")
    assert gateway.values == sorted(set(gateway.values))


@pytest.mark.slow
def test_value_that_is_no_number_is_reported_and_the_next_value_is_written(ros: int, tmp_path: Path) -> None:
    with master(ros), bridge_on_shared("ros1", SPEC, GATEWAY, tmp_path) as (process, url):
        wait_for(process, "node /unity_link_scara")

        peer(TALKER, "nan", "inf", "-1e300", "25")

        assert "j1.pos_sp: nan is no value of" in wait_for(process, "told once")
        with blocking.connect(url) as link:
            wait_until(lambda: link.read(0x8C) == round(25 / (360 / (50 * 4000))))


@pytest.mark.slow
def test_second_bridge_takes_the_name_of_the_first_which_ends_with_an_error(ros: int, tmp_path: Path) -> None:
    with master(ros), bench_bridge(tmp_path, FAST_GATEWAY) as first, bench_bridge(tmp_path, FAST_GATEWAY):
        assert "new node registered with same name" in wait_for(first, "ROS ended the node /unity_link_bench")
        assert first.wait(PATIENCE) == 1


@pytest.mark.slow
def test_a_machine_without_ros_is_told_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(environment, "_PLACE", "/nosuch")
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)

    with pytest.raises(ConnectError, match="apt install python3-rospy"):
        environment.find_rospy()


ARMER = """
import json, sys, time, rospy
from std_msgs.msg import Bool, Int32
from std_srvs.srv import SetBool
rospy.init_node("armer", anonymous=True, disable_signals=True)
arm = rospy.ServiceProxy("/rover/drive/arm", SetBool)
arm.wait_for_service(60)
said = [arm(True).message]
publisher = rospy.Publisher("/rover/speed", Int32, tcp_nodelay=True, queue_size=None)
while not publisher.get_num_connections():
    time.sleep(0.01)
deadline = time.monotonic() + 60
while not said[-1].startswith("drive is armed for") or said[-1].startswith("drive is armed for one"):
    assert time.monotonic() < deadline
    said.append(arm(True).message)
said.append(arm(True).message)
armed = []
rospy.Subscriber("/rover/drive/armed", Bool, lambda one: armed.append(one.data))
print(json.dumps(said), flush=True)
while time.monotonic() < deadline:
    publisher.publish(int(sys.argv[1]))
    time.sleep(0.05)
"""


@pytest.mark.slow
def test_a_program_arms_by_a_service_moves_and_is_killed(ros: int, tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(
        "group state(RATE=10); public rover() { GATEWAY(ADDRESS_BITS=12); drive: LEASE(TIMEOUT=0.5) @(0xE0);"
        " @speed = 0x10: signed READWRITE(SAFE(0, drive)); @way = 0x11: signed READ(PUBLISH(state)); }"
    )
    with master(ros), bridge_on_shared("ros1", str(spec), f"sim:{spec}", tmp_path, "--allow-arm") as (process, url):
        wait_for(process, "node /unity_link_rover")
        assert rostopic("echo", "-n1", "/rover/drive/armed").split()[:2] == ["data:", "False"]
        with blocking.connect(url) as link, node(ARMER, "250") as armer:
            robot = put(load(str(spec)), link)
            said = json.loads(line_of(armer))
            assert "and there are: none" in said[0]
            assert said[-1] == "drive is armed already"
            wait_until(lambda: robot.speed.get() == 250)
            armer.kill()
            wait_until(lambda: not robot.drive.armed_.get())
            assert robot.speed.get() == 0
        # The connection of a killed program ends at once; the bridge detects that before the silence.
        assert "drive" in wait_for(process, "drive is ")


PLANNER = """
import time, rospy
from std_srvs.srv import SetBool
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
rospy.init_node("planner", anonymous=True, disable_signals=True)
arm = rospy.ServiceProxy("/arm/drive/arm", SetBool)
arm.wait_for_service(60)
publisher = rospy.Publisher("/arm/joint_trajectory", JointTrajectory, queue_size=10)
while not (publisher.get_num_connections() and arm(True).success):
    time.sleep(0.05)
points = [JointTrajectoryPoint(positions=[0.1 * n], time_from_start=rospy.Duration(0.2 * n)) for n in range(4)]
publisher.publish(JointTrajectory(joint_names=["elbow"], points=points))
time.sleep(60)
"""


@pytest.mark.slow
def test_a_trajectory_of_ros_1_is_played_point_by_point(ros: int, tmp_path: Path) -> None:
    spec = tmp_path / "arm.ul"
    spec.write_text(
        "group state(RATE=10, TIMESTAMPS, JOINTS(POSITION=position, SET_POSITION=target)); public arm() {"
        " GATEWAY(ADDRESS_BITS=12); drive: LEASE(TIMEOUT=1) @(0xC0); plan: SCHEDULE() @(0xE0);"
        " elbow: joint(drive, plan) @(0x10); } joint(lease, plan): @(base) {"
        ' @position = base: signed READ(SCALE=0.001, UNIT="rad", PUBLISH(state));'
        ' @target = base + 1: signed READWRITE(SCALE=0.001, UNIT="rad", SAFE(0, lease), TIMED(plan)); }'
    )
    with master(ros), bridge_on_shared("ros1", str(spec), f"sim:{spec}", tmp_path, "--allow-arm") as (process, url):
        wait_for(process, "node /unity_link_arm")
        with blocking.connect(url) as link, node(PLANNER):
            assert "4 points are played" in wait_for(process, "joint_trajectory:")
            assert "4 points have acted" in wait_for(process, "joint_trajectory:")
            assert put(load(str(spec)), link).elbow.target.get() in {0, 0.3}
