"""The bridge to ROS 2 with a participant of CycloneDDS in another process, and ROS 2's own type definitions."""

from __future__ import annotations

import contextlib
import json
import math
import os
import signal
import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rosbags.typesys import Stores, get_typestore

from support.bridge_programs import (
    FAST_GATEWAY,
    FAST_SPEC,
    PATIENCE,
    PROGRAM,
    Noted,
    bridge_on_shared,
    free_domain,
    line_of,
    program,
    wait_for,
    wait_until,
)
from support.own_robots import OWN
from unity_link import ArgumentError, blocking, load
from unity_link.bridges.ros2.arguments import NodeNames, read_arguments
from unity_link.bridges.ros2.domain import domain_number, open_participant
from unity_link.bridges.ros2.messages import TYPES
from unity_link.bridges.ros_rows import number_rows, stamped_rows
from unity_link.bridges.ros_settings import BridgeSettings, Quality, read_parameters, settings_of
from unity_link.bridges.topics import joint_fields
from unity_link.data.blocking import put

if TYPE_CHECKING:
    from collections.abc import Iterator

    from support.own_robots import Own

PEER = str(Path(__file__).with_name("dds_peer.py"))
SPEC = str(Path(__file__).parents[2] / "examples" / "scara.ul")
GATEWAY = "sim:scara?base_frequency_millihertz=20000000"
LEASED = """
group state(RATE=10);
public rover() {
  GATEWAY(ADDRESS_BITS=12);
  drive: LEASE(TIMEOUT=20) @(0xE0);
  @speed = 0x10: signed READWRITE(SAFE(0, drive), PUBLISH(state));
}
"""
ROS = get_typestore(Stores.ROS2_JAZZY)

SCALES = [360 / 200_000, 360 / 200_000, 10 / 4000, 360 / 80_000]
"""Degrees (joint 3: millimetres) per count, of the joints of the SCARA."""
VALUES: dict[str, Any] = {
    "Bool": True,
    **{f"{sign}Int{bits}": (1 << (bits - 1)) - 1 for sign in ("", "U") for bits in (8, 16, 32, 64)},
    "Float32": 1.5,
    "Float64": -2.25,
}


@pytest.mark.parametrize("name", VALUES)
def test_standard_message_has_the_bytes_name_and_hash_of_ros_2(name: str) -> None:
    known = TYPES[name]
    full_name = f"std_msgs/msg/{name}"

    ours = number_rows(name, np.array([VALUES[name]]), cdr=True).tobytes()

    theirs = bytes(ROS.serialize_cdr(ROS.types[full_name](data=VALUES[name]), full_name))
    assert ours == theirs.ljust(len(ours), b"\0")
    assert ours == known.struct(data=VALUES[name]).serialize()
    assert known.struct.__idl_typename__ == f"std_msgs::msg::dds_::{name}_"
    assert known.hash == ROS.hash_rihs01(full_name)


@pytest.mark.parametrize("name", VALUES)
def test_message_of_either_byte_order_is_read_and_a_short_one_has_no_value(name: str) -> None:
    struct, full_name = TYPES[name].struct, f"std_msgs/msg/{name}"
    for little_endian in (True, False):
        message = ROS.types[full_name](data=VALUES[name])
        theirs = bytes(ROS.serialize_cdr(message, full_name, little_endian=little_endian))
        assert struct.deserialize(theirs).data == VALUES[name]
        assert struct.deserialize(theirs[:4]).data is None


@given(
    names=st.lists(st.text(max_size=9).filter(lambda text: "\0" not in text), max_size=4),
    there=st.tuples(st.booleans(), st.booleans(), st.booleans()),
    frame_id=st.sampled_from(["", "base", "base_link"]),
)
def test_the_states_of_joints_are_the_bytes_that_ros_2_gives_them(
    names: list[str], there: tuple[bool, ...], frame_id: str
) -> None:
    name = "sensor_msgs/msg/JointState"
    parts = {
        part: np.arange(2 * len(names) * given, dtype=float).reshape(2, -1)
        for part, given in zip(("position", "velocity", "effort"), there, strict=True)
    }
    types = ROS.types
    stamps = [types["builtin_interfaces/msg/Time"](sec=12, nanosec=nanosec) for nanosec in (500_000_000, 750_000_000)]

    ours = stamped_rows(np.array([12.5, 12.75]), joint_fields(names, parts), frame_id)

    for number, (row, stamp) in enumerate(zip(ours, stamps, strict=True)):
        header = types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame_id)
        message = types[name](header=header, name=names, **{part: column[number] for part, column in parts.items()})
        assert row.tobytes() == bytes(ROS.serialize_cdr(message, name))


# With a peer


def peer(domain: int, *arguments: str) -> Any:
    result = subprocess.run(
        [sys.executable, PEER, str(domain), *arguments],
        capture_output=True,
        text=True,
        timeout=2 * PATIENCE,
        check=True,
    )
    return json.loads(result.stdout) if result.stdout else None


def listen(domain: int, topic: str, name: str, count: int) -> list[Any]:
    seen: list[Any] = peer(domain, "listen", topic, name, str(count))
    assert len(seen) >= count
    return seen


@pytest.mark.slow
def test_every_sample_arrives_once_and_in_order(tmp_path: Path) -> None:
    domain = free_domain()
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, "--domain", str(domain)) as (process, url):
        assert "8 topics published, 11 subscribed to at /scara" in wait_for(process, "topics published")

        seen = listen(domain, "rt/scara/joint_states", "sensor_msgs/msg/JointState", 400)
        with blocking.connect(url) as link:
            link.write(0x8C, 1000)
        values = listen(domain, "rt/scara/j1/cpos", "std_msgs/msg/Float64", 100)

        process.send_signal(signal.SIGINT)
        summary = wait_for(process, "samples published")
        assert process.wait(PATIENCE) == 130

    stamps = [message["header"]["stamp"] for message in seen]
    instants = [stamp["sec"] * 1_000_000_000 + stamp["nanosec"] for stamp in stamps]
    assert instants == sorted(instants)
    assert seen[0]["name"] == ["j1", "j2", "j3", "j4"]
    assert values[-1]["data"] > 0
    assert " 0 lost" in summary


@pytest.mark.slow
@pytest.mark.parametrize("own", [OWN["sim"], pytest.param(OWN["rtl"], marks=pytest.mark.campaign)], ids=OWN)
def test_a_robot_of_ones_own_has_its_topics_and_moves_by_them(own: Own, tmp_path: Path) -> None:
    domain = free_domain()
    with bridge_on_shared("ros2", own.spec, own.url, tmp_path, "--domain", str(domain), "--namespace", "own") as (
        process,
        _,
    ):
        wait_for(process, "topics published")
        peer(domain, "talk", topic_of(own.set_point), "std_msgs/msg/Float64", "0.5")
        positions = [one["data"] for one in listen(domain, topic_of(own.position), "std_msgs/msg/Float64", 300)]
    assert positions[-1] == pytest.approx(0.5, abs=0.001)


def topic_of(path: str) -> str:
    return f"rt/own/{path.replace('.', '/').replace('[', '_').replace(']', '')}"


@pytest.mark.slow
def test_values_on_a_topic_are_written_in_order_and_bad_ones_reported(tmp_path: Path) -> None:
    domain = free_domain()
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, "--domain", str(domain), "--namespace", "arm") as (
        process,
        url,
    ):
        wait_for(process, "at /arm")

        values = [str(value / 10) for value in range(200)]
        peer(domain, "talk", "rt/arm/j1/pos_sp", "std_msgs/msg/Float64", *values, "500", "25.0")

        said = wait_for(process, "outside of its limits")
        with blocking.connect(url) as link:
            wait_until(lambda: link.read(0x8C) == round(25 / (360 / (50 * 4000))))
        process.send_signal(signal.SIGINT)
        summary = wait_for(process, "values written")
    assert "j1.pos_sp: 500.0 is outside of its limits, -130 to 130 deg" in said
    assert "201 values written" in summary


def test_one_message_sets_all_joints_and_one_that_is_wrong_sets_none(tmp_path: Path) -> None:
    domain = free_domain()
    options = ("--domain", str(domain), "--frame-id", "arm_base")
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, *options) as (process, url):
        wait_for(process, "at /scara")
        state, array = "sensor_msgs/msg/JointState", "std_msgs/msg/Float64MultiArray"
        wrong = {"name": ["j1", "j3"], "position": [0.1, 5.0]}
        right = {"name": ["j2", "j3"], "position": [-0.5, 0.1], "velocity": [1.0, 0.2]}

        peer(domain, "talk", "rt/scara/joint_commands", state, json.dumps(wrong), json.dumps(right))
        peer(domain, "talk", "rt/scara/position_commands", array, '{"data": [0.25, NaN, 0.05, 1.0]}')

        assert "j3.pos_sp: 5000.0 is outside of its limits, 0 to 150 mm" in wait_for(process, "outside")
        with blocking.connect(url) as link:
            wanted = [0.25 * 180 / math.pi, -0.5 * 180 / math.pi, 50, 180 / math.pi]
            counts = [round(value / scale) for value, scale in zip(wanted, SCALES, strict=True)]
            wait_until(lambda: link.read_block(0x8C, 4).tolist() == [count % (1 << 32) for count in counts])
            assert link.read(0x95) == round(180 / math.pi / SCALES[1])
        (seen, *_) = listen(domain, "rt/scara/joint_states", state, 1)
        assert seen["header"]["frame_id"] == "arm_base"


@pytest.mark.slow
@pytest.mark.parametrize("quality", Quality)
def test_diagnostics_tell_of_the_link_to_reliable_readers(quality: Quality, tmp_path: Path) -> None:
    domain = free_domain()
    options = "--domain", str(domain), "--quality", quality
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, *options) as (process, url):
        wait_for(process, "at /scara")

        (first, *_) = listen(domain, "rt/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", 1)

    (status,) = first["status"]
    values = {one["key"]: one["value"] for one in status["values"]}
    # A busy machine may have lost samples, or retransmitted a request.
    assert (status["level"], status["message"].partition(" ")[0]) in ((0, "connected"), (1, "samples"))
    assert (status["name"], status["hardware_id"]) == ("unity_link_scara: link", url)
    assert values["connected"] == "True"
    assert int(values["samples lost"]) >= 0
    assert int(values["samples published"]) >= 0
    assert float(values["round trip (ms)"]) > 0


@pytest.mark.slow
def test_diagnostics_tell_of_each_lease(tmp_path: Path) -> None:
    spec = tmp_path / "rover.ul"
    spec.write_text(LEASED)
    domain = free_domain()
    with bridge_on_shared("ros2", str(spec), f"sim:{spec}", tmp_path, "--domain", str(domain)) as (process, url):
        wait_for(process, "at /rover")
        (first, *_) = listen(domain, "rt/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", 1)
        with blocking.connect(url) as link, put(load(str(spec)), link).drive.armed():
            (second, *_) = listen(domain, "rt/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", 1)

    def told(message: dict[str, Any]) -> tuple[int, str, str]:
        (lease,) = (one for one in message["status"] if one["name"] == "unity_link_rover: lease drive")
        return lease["level"], lease["message"], {one["key"]: one["value"] for one in lease["values"]}["e-stop"]

    assert told(first) == (1, "disarmed: nobody has armed it since the reset", "closed")
    assert told(second) == (0, "armed", "closed")


def test_the_types_of_ros_2_have_its_hashes() -> None:
    known = {"Float64MultiArray": "std_msgs", "DiagnosticArray": "diagnostic_msgs"}
    known |= dict.fromkeys(("JointState", "Imu", "BatteryState", "Range"), "sensor_msgs")
    for name, package in {**known, "JointTrajectory": "trajectory_msgs"}.items():
        assert TYPES[name].hash == ROS.hash_rihs01(f"{package}/msg/{name}")


@pytest.mark.slow
def test_a_peer_may_come_late_and_go_in_between(tmp_path: Path) -> None:
    domain = free_domain()
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, "--domain", str(domain)) as (process, _):
        wait_for(process, "topics published")
        for _ in range(2):
            listen(domain, "rt/scara/j1/cpos", "std_msgs/msg/Float64", 20)
        process.send_signal(signal.SIGINT)
        assert " 0 lost" in wait_for(process, "samples published")


@contextmanager
def running_peer(domain: int, *arguments: str) -> Iterator[subprocess.Popen[str]]:
    with subprocess.Popen(
        [sys.executable, PEER, str(domain), *arguments], stdout=subprocess.PIPE, text=True
    ) as process:
        try:
            yield process
        finally:
            process.kill()


@pytest.mark.slow
def test_stuck_reader_delays_no_write_and_no_end_and_is_given_up(
    tmp_path: Path,
) -> None:
    spec = tmp_path / "bench.ul"
    spec.write_text(FAST_SPEC)
    domain = free_domain()
    follow = ("follow", "rt/bench/value", "std_msgs/msg/Float64")
    with (
        program("ros2", str(spec), "--link", FAST_GATEWAY, "--domain", str(domain)) as process,
        running_peer(domain, *follow, "1000000000") as stuck,
    ):
        wait_for(process, "topics published")
        assert line_of(stuck) == "listening"
        stuck.send_signal(signal.SIGSTOP)
        wait_for(process, "a reader of /bench/value takes nothing: messages are lost")
        peer(domain, "talk", "rt/bench/target", "std_msgs/msg/Float64", *map(str, range(100)))
        with running_peer(domain, *follow, "20000") as other:
            assert line_of(other) == "listening"
            assert line_of(other) == "enough"

        with running_peer(domain, *follow, "1000000000") as late:
            assert line_of(late) == "listening"
            late.send_signal(signal.SIGSTOP)
            process.send_signal(signal.SIGINT)
            assert "100 values written" in wait_for(process, "values written")
            assert process.wait(PATIENCE) == 130


@pytest.mark.slow
def test_gateway_may_start_late_and_restart_and_no_value_is_written_twice(tmp_path: Path) -> None:
    gateway, domain = Noted(tmp_path), free_domain()
    with contextlib.ExitStack() as bridge:
        process = bridge.enter_context(program("ros2", gateway.spec, "--link", gateway.url, "--domain", str(domain)))
        wait_for(process, "waiting for the gateway")
        with gateway.running():
            wait_for(process, "topics published")
            bridge.enter_context(running_peer(domain, "count", "rt/plain/target", "std_msgs/msg/UInt32"))
            gateway.wait_for_more()
        wait_for(process, "the gateway is away")
        with gateway.running():
            wait_for(process, "the gateway is back")
            gateway.wait_for_more()
            listen(domain, "rt/plain/value", "std_msgs/msg/UInt32", 10)
            process.send_signal(signal.SIGINT)
            wait_for(process, "values written")
    assert gateway.values == sorted(set(gateway.values))


@pytest.mark.slow
def test_value_that_is_no_number_is_reported_and_the_next_value_is_written(tmp_path: Path) -> None:
    domain = free_domain()
    with bridge_on_shared("ros2", SPEC, GATEWAY, tmp_path, "--domain", str(domain)) as (process, url):
        wait_for(process, "topics published")

        peer(domain, "talk", "rt/scara/j1/pos_sp", "std_msgs/msg/Float64", "NaN", "Infinity", "-1e300", "25.0")

        assert "j1.pos_sp: nan is no value of" in wait_for(process, "told once")
        with blocking.connect(url) as link:
            wait_until(lambda: link.read(0x8C) == round(25 / (360 / (50 * 4000))))


@pytest.mark.slow
def test_second_bridge_at_the_same_topics_is_refused_and_one_elsewhere_not() -> None:
    domain = str(free_domain())
    command = ("ros2", SPEC, "--link", "sim:scara", "--domain", domain)
    with program(*command) as first, program(*command, "--namespace", "left") as other:
        wait_for(first, "topics published")
        wait_for(other, "topics published")
        second = subprocess.run([PROGRAM, *command], capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert second.returncode == 1
    assert second.stderr.startswith("error: another bridge is at /scara, and both would write")


# Settings


def test_parameters_stand_in_a_file_as_ros_2_writes_them(tmp_path: Path) -> None:
    file = tmp_path / "bridge.yaml"
    file.write_text(
        "unity_link_scara:\n  ros__parameters:\n    link: sim:scara\n    namespace: arm\n    poll_hz: 10.0\n"
        "    topics:\n      j1/cpos: {quality: sensor_data}\n"
    )

    settings = settings_of(read_parameters(file))

    assert (settings.link, settings.namespace, settings.poll_hz) == ("sim:scara", "arm", 10.0)
    assert settings.quality_of("j1/cpos") is Quality.SENSOR_DATA
    assert settings.quality_of("j2/cpos") is Quality.RELIABLE


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("node: {ros__parameters: {lnk: x}}", "unknown field `lnk`"),
        ("node: {ros__parameters: {quality: best}}", "Invalid enum value 'best'"),
        ("a: [", "while parsing"),
        ("a: " + "[" * 100_000, "it is nested too deeply"),
        ("{}", "parameters of 0 nodes"),
    ],
)
def test_a_file_of_parameters_that_is_wrong_is_told_why(tmp_path: Path, text: str, words: str) -> None:
    file = tmp_path / "bridge.yaml"
    file.write_text(text)

    with pytest.raises(ArgumentError, match=words):
        read_parameters(file)


def test_arguments_of_a_node_give_names_parameters_and_ints_for_floats(tmp_path: Path) -> None:
    file = tmp_path / "bridge.yaml"
    file.write_text("/**: {ros__parameters: {poll_hz: 5, frame_id: base}}")
    words = f"--params-file {file} -r __ns:=/left -r arm/joint_states:=states -p topics.j1/cpos.quality:=sensor_data"

    names, parameters = read_arguments([*words.split(), "-p", "frame_id:=tool", "--remap", "n:/diagnostics:=told"])

    settings = settings_of(parameters)
    assert (settings.poll_hz, settings.frame_id) == (5.0, "tool")
    assert settings.quality_of("j1/cpos") is Quality.SENSOR_DATA
    assert names.resolve("arm/joint_states") == "/left/states"
    assert names.resolve("/diagnostics") == "/left/told"
    assert names.resolve("arm/j1/cpos") == "/left/arm/j1/cpos"
    assert NodeNames().resolve("arm/") == "/arm"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("-p poll_hz:=fast", "a parameter is wrong: Expected `float | null`, got `str` - at `$.poll_hz`"),
        ("-p pol_hz:=5", "a parameter is wrong: Object contains unknown field `pol_hz`"),
        ("-r left", "--ros-args -r left: -r FROM:=TO"),
        ("--params-file /nosuch", "/nosuch cannot be read"),
    ],
)
def test_a_wrong_argument_of_a_node_is_refused_in_a_sentence(words: str, message: str) -> None:
    with pytest.raises(ArgumentError) as error:
        settings_of(read_arguments(words.split())[1])
    assert str(error.value).startswith(message)


@pytest.mark.parametrize(
    ("text", "number"),
    [("", 0), ("0", 0), ("10", 10), ("010", 8), ("0x1F", 31), ("232", 232), ("233", None), ("x", None)],
)
def test_the_domain_id_is_read_as_rcl_reads_it(text: str, number: int | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_DOMAIN_ID", text)
    if number is None:
        with pytest.raises(ArgumentError, match=f"DDS domain {text}: a number from 0 to 232 was expected"):
            domain_number(BridgeSettings())
    else:
        assert domain_number(BridgeSettings()) == number


@pytest.mark.slow
def test_of_two_robots_in_two_namespaces_one_set_point_moves_one(tmp_path: Path) -> None:
    domain, folders = free_domain(), [tmp_path / name for name in ("left", "right")]
    with contextlib.ExitStack() as bridges:
        links = []
        for folder in folders:
            folder.mkdir()
            words = "--domain", str(domain), "--ros-args", "-r", f"__ns:=/{folder.name}"
            process, url = bridges.enter_context(bridge_on_shared("ros2", SPEC, GATEWAY, folder, *words))
            wait_for(process, f"at /{folder.name}/scara")
            links.append(bridges.enter_context(blocking.connect(url)))
        peer(domain, "talk", "rt/left/scara/j1/pos_sp", "std_msgs/msg/Float64", "25.0")
        wait_until(lambda: links[0].read(0x8C) == round(25 / SCALES[0]))
        assert links[1].read(0x8C) == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ([], "nothing says where the gateway is"),
        (["--link", "sim:scara", "--quality", "best"], "one of reliable, sensor_data was expected"),
        (["--link", "sim:scara", "--domain", "233"], "a number from 0 to 232 was expected"),
        (["--params", "/nosuch"], "/nosuch cannot be read"),
        (["--link", "sim:scara", "--namespace", "a b"], "'a b' is no namespace of ROS"),
        (["--link", "sim:scara", "--poll", "inf"], "--poll inf: more than 0 Hz was expected"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else "",
)
def test_wrong_use_is_told_in_one_sentence(arguments: list[str], words: str) -> None:
    result = subprocess.run(
        [PROGRAM, "ros2", SPEC, *arguments], capture_output=True, text=True, timeout=PATIENCE, check=False
    )
    assert result.returncode == 2
    assert words in result.stderr
    assert "Traceback" not in result.stderr


def test_a_quality_for_a_topic_that_there_is_not_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "bridge.yaml"
    file.write_text("node: {ros__parameters: {link: 'sim:scara', topics: {j9/cpos: {quality: sensor_data}}}}")
    result = subprocess.run(
        [PROGRAM, "ros2", SPEC, "--params", str(file)], capture_output=True, text=True, timeout=PATIENCE, check=False
    )
    assert result.returncode == 2
    assert "a quality for 'j9/cpos', which is no topic here: did you mean 'j" in result.stderr


def devices_of_ports() -> set[bytes]:
    """Return the devices to which UDP sockets of this process with the address 0.0.0.0 are bound; "" is no device."""
    found = set()
    for file in Path("/proc/self/fd").iterdir():
        with contextlib.suppress(OSError):
            if str(file.readlink()).startswith("socket:"):
                with socket.socket(fileno=os.dup(int(file.name))) as one:
                    if one.type == socket.SOCK_DGRAM and one.getsockname()[0] == "0.0.0.0":
                        found.add(one.getsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, 16).rstrip(b"\0"))
    return found


@pytest.mark.parametrize(("network", "devices"), [(False, {b"lo"}), (True, {b""})])
def test_other_machines_are_heard_only_where_that_is_asked_for(network: bool, devices: set[bytes]) -> None:
    opened = open_participant(BridgeSettings(network=network, domain=free_domain()))
    assert devices_of_ports() == devices
    del opened
