"""The settings of a bridge: on the command line, or in a file of parameters of ROS 2; ros.md has an example."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Any

import msgspec

from unity_link.errors import ArgumentError

if TYPE_CHECKING:
    from pathlib import Path


class Quality(enum.StrEnum):
    """Profiles of quality of service, by ROS 2's names for them."""

    RELIABLE = "reliable"
    """All samples arrive; a reader that is too slow holds up the bridge, which then loses samples and counts them."""
    SENSOR_DATA = "sensor_data"
    """Best effort: a sample that is not taken at once is lost. Readers must ask for best effort, too."""


class TopicSettings(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Settings of one topic."""

    quality: Quality


class BridgeSettings(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The parameters of the bridge."""

    link: str | None = None
    """The URL of the gateway."""
    namespace: str | None = None
    """Prefix of all topics, in the namespace of the node unless it begins with a slash; None: the interface's name."""
    poll_hz: float | None = None
    """Reads a second, for publication, of signals that nothing samples."""
    frame_id: str = ""
    """Frame ID in the headers of joint states."""
    quality: Quality = Quality.RELIABLE
    topics: dict[str, TopicSettings] = {}
    """Settings of topics by their names without namespace."""
    given: dict[str, int] = {}
    """Addresses for the parameters of the interface; -1 for one that is not needed."""
    allow_arm: bool = False
    """True to let any program on ROS arm the leases of the robot."""
    timeout: float | None = None
    """Seconds from a set point to the end of a lease that ROS has armed; None: the most that the spec allows."""
    network: bool = False
    """True to speak to other machines too; else only to programs of this one."""
    domain: int | None = None
    """The domain; None for ROS_DOMAIN_ID, or 0 without that variable."""

    def quality_of(self, topic: str) -> Quality:
        """Return the profile of a topic."""
        return self.topics[topic].quality if topic in self.topics else self.quality


class _Node(msgspec.Struct, forbid_unknown_fields=True):
    ros__parameters: BridgeSettings


def settings_of(parameters: dict[str, Any]) -> BridgeSettings:
    """Return the settings that parameters give.

    Raises:
        ArgumentError: for parameters that there are not, or values of another type.
    """
    try:
        return msgspec.convert(parameters, BridgeSettings)
    except msgspec.ValidationError as error:
        raise ArgumentError(f"a parameter is wrong: {error}") from None


def read_parameters(path: Path) -> dict[str, Any]:
    """Read the parameters in a file of one node, whatever its name.

    Raises:
        ArgumentError: if the file cannot be read, or does not contain parameters of one node.
    """
    import yaml

    try:
        # libyaml, which msgspec prefers, overflows the stack of the process if a file is nested deeply.
        read = yaml.load(path.read_bytes(), Loader=yaml.SafeLoader)
        nodes = msgspec.convert(read, dict[str, _Node])
    except OSError as error:
        raise ArgumentError(f"{path} cannot be read: {error.strerror or error}") from None
    except RecursionError:
        raise ArgumentError(f"{path}: it is nested too deeply") from None
    except (msgspec.ValidationError, yaml.YAMLError, ValueError) as error:
        raise ArgumentError(f"{path}: {error}") from None
    if len(nodes) != 1:
        raise ArgumentError(f"{path} has parameters of {len(nodes)} nodes: one was expected")
    (node,) = read.values()
    parameters: dict[str, Any] = node["ros__parameters"]
    return parameters
