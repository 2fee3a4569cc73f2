"""ROS 1: the samples of a robot as topics, and topics as writes, by rospy itself.

- `environment`: finds rospy, and chooses the address of the node
- `node`: the bridge

The master may be away at the start and go in between; the node waits for it, and registers again with one that does not
know it. rospy's threads and the event loop meet in two places: samples go to a thread that publishes, and values that
arrive go through `unity_link.bridges.commands`.
"""

from unity_link.bridges.ros1.environment import find_rospy
from unity_link.bridges.ros1.node import Ros1Bridge

__all__ = ["Ros1Bridge", "find_rospy"]
