"""Bridges: one link, carried to other programs and in other forms.

Each bridge is a room of its own. Its package offers what a program calls; a thin file in `unity_link.cli` makes a
command of it, and holds all that is said to people. A bridge reports through a callable that it is given, ends when its
context ends, and says by one exception why it can't go on.

- `serve`: the protocol itself, for several programs at once
- `ros1`, `ros2`: topics of ROS; `ros` is what both do, `topics` says how signals are named and typed there, `commands`
  how values come back
- `zenoh`: links, samples and values for other machines
- `waiting`: a link to a gateway that may be away at the start, and samples of one
- `thread_queue` and `gateway_time`: how samples get to a thread that sends them, and when they were taken
- `presence`: whether the gateway is away, also where a server is between
- `recording`: what a robot published, on the disk and back; `sampled` says what that is, for other bridges, too,
  and `messages` how a sample is written
- `live`: a page of moving pictures, and the same for the Foxglove app
"""
