"""Arguments of a node, as `ros2 run` and launch files give them: ``--ros-args -r __ns:=/left -p poll_hz:=5``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from unity_link.bridges.ros_settings import read_parameters
from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from collections.abc import Sequence

BEGIN, END = "--ros-args", "--"


class NodeNames(NamedTuple):
    """Names that ROS gives a node from outside."""

    node: str | None = None
    """None: the program chooses the name."""
    namespace: str = "/"
    remaps: tuple[tuple[str, str], ...] = ()
    """Names of topics, before and after."""

    def resolve(self, name: str) -> str:
        """Return the full name of a topic: resolved in the namespace of the node, and remapped."""
        full = self._full(name)
        return next((self._full(after) for before, after in self.remaps if self._full(before) == full), full)

    def _full(self, name: str) -> str:
        if name.startswith("~"):
            name = f"{self.node or ''}/{name[1:].lstrip('/')}"
        return "/" + (name if name.startswith("/") else f"{self.namespace}/{name}").strip("/").replace("//", "/")


def split(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """Return the words of a command line that are for the program, and those that are for ROS."""
    own: list[str] = []
    ros: list[str] = []
    into = own
    for word in words:
        if word == BEGIN:
            into = ros
        elif word == END and into is ros:
            into = own
        else:
            into.append(word)
    return own, ros


def read_arguments(words: Sequence[str]) -> tuple[NodeNames, dict[str, Any]]:
    """Read arguments for ROS; return the names and the parameters that they give.

    Raises:
        ArgumentError: for arguments that are none, or a file of parameters that cannot be read.
    """
    import yaml

    names: dict[str, str] = {}
    remaps: list[tuple[str, str]] = []
    parameters: dict[str, Any] = {}
    rest = list(words)
    while rest:
        option, value = rest.pop(0), rest.pop(0) if rest else ""
        before, arrow, after = value.partition(":=")
        if option == "--params-file" and value:
            parameters |= read_parameters(Path(value))
        elif option in {"-r", "--remap"} and arrow:
            # A remapping may name the node that it is for.
            before = before.rpartition(":")[2]
            if before in {"__ns", "__node", "__name"}:
                names[before] = after
            else:
                remaps.append((before, after))
        elif option in {"-p", "--param"} and arrow:
            try:
                set_parameter(parameters, before.rpartition(":")[2], yaml.safe_load(after))
            except yaml.YAMLError:
                raise ArgumentError(f"{option} {value}: the value is no YAML") from None
        elif option != "--log-level":
            raise ArgumentError(
                f"{BEGIN} {option} {value}: -r FROM:=TO, -p NAME:=VALUE, --params-file FILE or --log-level LEVEL "
                "was expected"
            )
    return NodeNames(names.get("__node", names.get("__name")), names.get("__ns", "/"), tuple(remaps)), parameters


def set_parameter(parameters: dict[str, Any], name: str, value: Any) -> None:
    """Set a parameter in nested dictionaries, by its name with dots: ``topics.j1/cpos.quality``."""
    *parts, last = name.split(".")
    for part in parts:
        parameters = parameters.setdefault(part, {})
    parameters[last] = value
