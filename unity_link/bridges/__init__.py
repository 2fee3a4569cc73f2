"""Bridges: a link's signals and samples for other programs and in other formats.

Each bridge is a package or module of its own, with the functions that a program calls; a small file in `unity_link.cli`
makes a command of it, and has all texts for users. A bridge reports by a callable that it is given, ends when its
context ends, and raises one exception if it cannot continue.

- `serve`: the protocol itself, for several programs at once
- `ros1`, `ros2`: topics of ROS; `ros` has the common parts, `topics` the topics of signals and joints, `topic_names`
  their names and types, `commands` the values that ROS sends
- `zenoh`: links, samples and values for other machines
- `waiting`: a link to a gateway that may be away at the start, and its samples
- `thread_queue` and `gateway_time`: the way of samples to a thread that sends them, and the instants of samples
- `presence`: whether the gateway is away, even behind a server
- `recording`: files with the samples of a robot, and their replay; `sampled` selects the groups, for other bridges,
  too, and `messages` writes samples
- `live`: a page with moving plots, and the same data for the Foxglove app
"""
