"""`unity-link ros1`, `ros2`: runs a robot as a ROS node."""

from __future__ import annotations

import contextlib
import functools
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import msgspec
import typer
from typer.core import TyperCommand

from unity_link.cli.arguments import check_poll
from unity_link.cli.completion import complete_url
from unity_link.cli.output import print_note
from unity_link.cli.running import run
from unity_link.cli.spec import Given, Name, SpecOrBoard, compile_or_exit, url_and_spec
from unity_link.errors import ArgumentError, UnityLinkError

if TYPE_CHECKING:
    from collections.abc import Callable

    from unity_link.bridges.ros1 import Ros1Bridge
    from unity_link.bridges.ros2.node import Ros2Bridge
    from unity_link.bridges.ros_settings import BridgeSettings
    from unity_link.bridges.zenoh import ZenohBridge
    from unity_link.spec import Spec

BridgeUrl = Annotated[
    str | None,
    typer.Argument(
        metavar="[URL]",
        help="Where the gateway is, such as sim:scara.",
        autocompletion=complete_url,
        show_default=False,
    ),
]
LinkUrl = Annotated[str | None, typer.Option("--link", metavar="URL", help="The URL, as in SPEC --link URL.")]
Namespace = Annotated[
    str | None,
    typer.Option("--namespace", metavar="NAME", help="Namespace of all topics; the interface's name without."),
]
Poll = Annotated[
    float | None,
    typer.Option(
        "--poll", metavar="HZ", help="Also publish signals that no group samples, by reading them at this rate."
    ),
]
AllowArm = Annotated[
    bool,
    typer.Option("--allow-arm", help="Let any program on ROS arm the leases of the robot, without authentication."),
]
Timeout = Annotated[
    float | None,
    typer.Option(
        "--timeout",
        metavar="SECONDS",
        help="Time from a set point until a lease that ROS has armed ends; the longest allowed without.",
    ),
]
FrameId = Annotated[
    str | None, typer.Option("--frame-id", metavar="NAME", help="The frame that states of joints name; none without.")
]


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command(cls=_Ros1Command)(ros1)
    app.command(cls=_Ros2Command)(ros2)


ROS = "ros"
"""Key of the arguments for ROS in the context of a command."""


class _Ros1Command(TyperCommand):
    """A command whose remappings, ``FROM:=TO`` and ``__name:=VALUE``, rospy reads from `sys.argv` itself."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        return super().parse_args(ctx, [word for word in args if ":=" not in word or word.startswith("-")])


class _Ros2Command(TyperCommand):
    """A command that leaves its words after ``--ros-args`` to ROS."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        from unity_link.bridges.ros2.arguments import split

        own, ctx.meta[ROS] = split(args)
        return super().parse_args(ctx, own)


def ros1(
    url: BridgeUrl = None,
    spec: SpecOrBoard = None,
    *,
    link: LinkUrl = None,
    namespace: Namespace = None,
    poll: Poll = None,
    frame_id: FrameId = None,
    allow_arm: AllowArm = False,
    timeout: Timeout = None,
    interface: Name = None,
    given: Given = None,
) -> None:
    """Run a ROS 1 node: publish sampled signals as topics, and write signals from topics.

    Needs rospy of the distribution; ROS_MASTER_URI is the address of the master. Master and gateway may come and go.
    Accepts remappings like any node: __ns:=/left, scara/j1/pos_sp:=elbow.
    """
    from unity_link.bridges.ros_settings import BridgeSettings

    check_poll(poll)
    settings = BridgeSettings(
        namespace=namespace, poll_hz=poll, frame_id=frame_id or "", allow_arm=allow_arm, timeout=timeout
    )
    url, spec = url_and_spec(url, spec, link)
    run(_ros1(compile_or_exit(spec, interface=interface, given=given), interface, url, settings))


async def _ros1(spec: Spec, interface: str | None, url: str, settings: BridgeSettings) -> None:
    from unity_link.bridges.ros1 import Ros1Bridge, find_rospy
    from unity_link.bridges.waiting import connect_when_there
    from unity_link.data import load
    from unity_link.data.describing import robot_behind

    robot_type = load(spec, interface)
    find_rospy()
    async with connect_when_there(url, print_note) as link:
        await run_and_sum_up(Ros1Bridge(await robot_behind(link, robot_type), settings, print_note))


def ros2(
    ctx: typer.Context,
    url: BridgeUrl = None,
    spec: SpecOrBoard = None,
    *,
    link: LinkUrl = None,
    params: Annotated[
        Path | None, typer.Option("--params", metavar="FILE", help="Parameters of the node, as ROS 2's YAML has them.")
    ] = None,
    namespace: Namespace = None,
    poll: Poll = None,
    frame_id: FrameId = None,
    allow_arm: AllowArm = False,
    timeout: Timeout = None,
    quality: Annotated[
        str | None, typer.Option(metavar="PROFILE", help="reliable (the default) or sensor_data, for all topics.")
    ] = None,
    domain: Annotated[int | None, typer.Option(metavar="N", help="The DDS domain; ROS_DOMAIN_ID without.")] = None,
    network: Annotated[
        bool, typer.Option("--network", help="Communicate with other machines, not only within this one.")
    ] = False,
    interface: Name = None,
    given: Given = None,
) -> None:
    """Publish sampled signals as ROS 2 topics, and write signals from topics; a ROS installation is not needed.

    With a Python that has rclpy it is a node; otherwise it uses CycloneDDS: pip install "unity-link[ros2]".

    Options override --params. Names and parameters of the node follow --ros-args, as for any node of ROS 2:
    -r __ns:=/left, -p poll_hz:=5, --params-file FILE.
    """
    from unity_link.bridges.ros2.arguments import read_arguments
    from unity_link.bridges.ros2.domain import find_dds
    from unity_link.bridges.ros2.over_rclpy import RclpyBridge, declare, has_rclpy, log, open_node, parameters_of
    from unity_link.bridges.ros_settings import Quality, read_parameters, settings_of
    from unity_link.transport import is_url

    if quality is not None and quality not in set(Quality):
        raise ArgumentError(f"--quality {quality}: one of {', '.join(Quality)} was expected")
    check_poll(poll)
    options = {
        "namespace": namespace,
        "poll_hz": poll,
        "frame_id": frame_id,
        "allow_arm": allow_arm or None,
        "timeout": timeout,
        "quality": None if quality is None else Quality(quality),
        "domain": domain,
        "network": network or None,
    }
    said = {name: value for name, value in options.items() if value is not None}
    over_rclpy = has_rclpy()
    if not over_rclpy:
        find_dds()
    named = next((one for one in (spec, url) if one is not None and not is_url(one)), None)
    compiled = None if named is None else compile_or_exit(named, interface=interface, given=given)
    with contextlib.ExitStack() as node_open:
        report: Callable[..., None] = print_note
        make: Callable[..., Ros2Bridge]
        parameters = {} if params is None else read_parameters(params)
        if over_rclpy:
            of_robot = "robot" if compiled is None else compiled.interface(interface).name
            name = (namespace or of_robot).strip("/").replace("/", "_")
            node = node_open.enter_context(open_node(f"unity_link_{name}", ctx.meta[ROS], domain, network=network))
            settings = settings_of(parameters | parameters_of(node) | said)
            url, spec = url_and_spec(url, spec, link, settings.link)
            declare(node, msgspec.structs.replace(settings, link=url))
            report, make = functools.partial(log, node), functools.partial(RclpyBridge, node=node)
        else:
            from unity_link.bridges.ros2.over_dds import DdsBridge

            names, given_to_node = read_arguments(ctx.meta[ROS])
            settings = settings_of(parameters | given_to_node | said)
            url, spec = url_and_spec(url, spec, link, settings.link)
            make = functools.partial(DdsBridge, names=names, report=print_note)
        compiled = compiled or compile_or_exit(spec, interface=interface, given=given)
        run(_ros2(_with_settings(compiled, interface, settings), interface, url, settings, make, report))


def _with_settings(spec: Spec, interface: str | None, settings: BridgeSettings) -> Spec:
    """Return the spec with the parameters from the file that were not given by --give."""
    known = {parameter.name: parameter.value for parameter in spec.interface(interface).parameters}
    left = {name: value for name, value in settings.given.items() if value != -1 and known.get(name) is None}
    return spec.given(left, interface)


async def _ros2(
    spec: Spec,
    interface: str | None,
    url: str,
    settings: BridgeSettings,
    make: Callable[..., Ros2Bridge],
    report: Callable[[str], None],
) -> None:
    from unity_link.bridges.waiting import connect_when_there
    from unity_link.data import load
    from unity_link.data.describing import robot_behind

    robot_type = load(spec, interface)
    async with connect_when_there(url, report) as link:
        await run_and_sum_up(make(await robot_behind(link, robot_type), settings))


async def run_and_sum_up(bridge: Ros1Bridge | Ros2Bridge | ZenohBridge) -> None:
    """Run a bridge; at the end print its counts, unless it failed before it carried anything."""
    could_not = False
    try:
        await bridge.run()
    except UnityLinkError:
        could_not = not bridge.published and not bridge.written
        raise
    finally:
        if not could_not:
            print_note(
                f"{bridge.published:,} samples published, {bridge.lost:,} lost; "
                f"{bridge.messages:,} messages sent, {bridge.written:,} values written"
            )
