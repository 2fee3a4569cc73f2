"""ROS 2: by rclpy if this Python has it, otherwise by CycloneDDS, because the topics of ROS 2 are topics of DDS.

- `arguments`: names and parameters of a node, from outside
- `node`: the bridge, with two ways to ROS 2: `over_rclpy`, and `over_dds` with its `domain`, `messages` and `inlets`

ROS 2 calls the topic ``/scara/j1/cpos`` ``rt/scara/j1/cpos`` on DDS, and the type ``std_msgs/msg/Float64``
``std_msgs::msg::dds_::Float64_`` (https://design.ros2.org/articles/topic_and_service_names.html).
"""
