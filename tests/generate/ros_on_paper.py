"""Runs the bridge of a generated package without ROS, on any Python from 3.8: what it would publish is written down.

``ros_on_paper.py FOLDER PREFIX LINK``; ``PREFIX`` stands before the names of the package's modules. It sets joints by
each kind of topic, and prints what came of that as JSON.
"""

from __future__ import annotations

import importlib
import json
import sys
import time
import types
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

PARAMETERS = {
    "namespace": "arm",
    "poll_hz": 20.0,
    "frame_id": "base",
    "queue_size": 10,
    "diagnostics_hz": 20.0,
    "given_ctrl": "",
    "given_comm": "",
}
PATIENCE = 60.0


class Paper:
    """Stand-in for ROS on paper, as far as a bridge needs it."""

    def __init__(self, link: str, **parameters: Any) -> None:
        self._parameters = dict(PARAMETERS, link=link, **parameters)
        self.last: dict[str, Any] = {}
        self.taking: dict[str, Any] = {}
        self.warnings: list[str] = []

    def parameter(self, name: str) -> Any:
        """Return a parameter."""
        return self._parameters[name]

    def warn(self, text: str) -> None:
        """Note a sentence."""
        self.warnings.append(text)

    def now(self) -> float:
        """Return the time."""
        return time.time()

    def publisher(self, topic: str, package: str, message: str) -> Any:
        """Note what is published last."""

        def publish(value: Any) -> None:
            self.last[topic] = [package + "/" + message, value]

        return types.SimpleNamespace(publish=publish, is_wanted=lambda: True, number=lambda value: value)

    def subscribe(self, topic: str, package: str, message: str, take: Any) -> None:
        """Note who takes messages."""
        self.taking[topic] = [package + "/" + message, take]

    def joint_state(self, *fields: Any) -> Any:
        """Return a message."""
        return fields

    def diagnostics(self, *fields: Any) -> Any:
        """Return a message."""
        return fields

    def say(self, topic: str, **fields: Any) -> None:
        """Deliver a message to its callback."""
        self.taking[topic][1](types.SimpleNamespace(**fields))


def wait_until(condition: Callable[[], object]) -> None:
    """Wait, but not for ever."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise SystemExit("nothing more happened")
        time.sleep(0.01)


def is_near(values: Sequence[float], wanted: Sequence[float]) -> bool:
    """Return whether values are those that are wanted."""
    return all(abs(value - one) < 1e-3 for value, one in zip(values, wanted))  # noqa: B905  (Python 3.8 has no `strict`)


def main() -> None:
    """Be the program."""
    folder, prefix, link = sys.argv[1:]
    sys.path.insert(0, folder)
    robot, bridge = (importlib.import_module(prefix + name) for name in ("robot", "bridge"))
    paper = Paper(link)
    one = bridge.Bridge(paper, robot)
    one.start()
    wait_until(lambda: "/arm/joint_states" in paper.last)

    def positions() -> Any:
        return paper.last["/arm/joint_states"][1][3][0]

    paper.say("/arm/j1/pos_sp/set", data=500.0)
    paper.say("/arm/j1/pos_sp/set", data=-15.0)
    nothing: dict[str, Any] = {"position": [], "velocity": [], "effort": []}
    paper.say("/arm/joint_commands", **dict(nothing, name=["j4", "j2"], position=[1.0, float("inf")]))
    paper.say("/arm/joint_commands", **dict(nothing, name=["j4", "j2"], position=[1.0, -0.5]))
    wait_until(lambda: is_near(positions(), [-0.2618, -0.5, 0.0, 1.0]))
    paper.say("/arm/position_commands", data=[0.25, float("nan"), 0.1, 0.0])
    wait_until(lambda: is_near(positions(), [0.25, -0.5, 0.1, 0.0]))
    wait_until(lambda: paper.last.get("/arm/j1/pos_sp", [0, 0])[1] > 0)
    wait_until(lambda: paper.last["/diagnostics"][1][1][0][0] == 0)
    told = {
        "version": sys.version_info[:2],
        "last": paper.last,
        "subscribed": {topic: message for topic, (message, _) in paper.taking.items()},
        "warnings": paper.warnings,
        "written": one.written,
        "lost": one.lost,
    }
    one.close()
    sys.stdout.write(json.dumps(told))


if __name__ == "__main__":
    main()
