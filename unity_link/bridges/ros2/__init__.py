"""ROS 2 without a ROS installation: its topics are DDS topics, and CycloneDDS speaks DDS.

- `messages`: ROS 2's own types, as DDS sees them
- `domain`: which network and which domain
- `node`: the bridge

ROS 2 calls the topic ``/scara/j1/cpos`` ``rt/scara/j1/cpos`` on DDS, and the type ``std_msgs/msg/Float64``
``std_msgs::msg::dds_::Float64_`` (https://design.ros2.org/articles/topic_and_service_names.html).
"""

from unity_link.bridges.ros2.domain import find_dds
from unity_link.bridges.ros2.node import Ros2Bridge
from unity_link.bridges.ros2.settings import BridgeSettings, Quality, read_settings

__all__ = ["BridgeSettings", "Quality", "Ros2Bridge", "find_dds", "read_settings"]
