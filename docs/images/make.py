"""Makes the pictures of the documents: ``make docs-images``, or ``python -m docs.images.make [NAME...]`` for some.

Each picture shows the real program at work: commands in a terminal (tmux), the live page in Chromium, and the plot of
the rover's tutorial. The measurements make `peers.png` and the pictures of docs/paper.md: `make bench-peers` and
`make table1`.
"""

import contextlib
import functools
import io
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Self

from rich.console import Console
from rich.text import Text

from docs.images import wiring
from docs.images.balancer import draw_balancer
from docs.images.gantry import draw_gantry
from docs.images.live import draw_live
from docs.tables import SYMBOL, CoreEntry, installed_cores
from docs.walkthrough import follow
from unity_link.spec import Way

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
ROVER = "sim:examples/rover.ul?model=examples/rover.py:Rover"
FRAMES = 12
"""Number of frames of the animated picture."""
FRAME_SECONDS = 0.6
"""Seconds from one frame to the next."""
DRIVEN_FOR = 1.0
"""Seconds of real time of each movement in the picture of `watch`."""
PATIENCE = 60.0
"""Seconds after which waiting for a pattern fails."""


def demo(picture: Path) -> None:
    """Draw the motion of `unity-link demo`, in frames that a browser shows in turn, without a script."""
    frames = []
    with Terminal(80, 20) as terminal:
        terminal.enter("unity-link demo")
        terminal.wait_for("rate_hz")
        for number in range(FRAMES):
            time.sleep(FRAME_SECONDS)
            frames.append(terminal.draw("unity-link demo", f"demo{number}"))
    turn = FRAMES * FRAME_SECONDS
    style = (
        f".frame {{ visibility: hidden; animation: show {turn:g}s step-end infinite }}\n"
        f"@keyframes show {{ 0% {{ visibility: visible }} {100 / FRAMES:g}% {{ visibility: hidden }} }}\n"
        "@media (prefers-reduced-motion) { .frame { animation: none } .frame:last-child { visibility: visible } }"
    )
    shown = [
        f'<g class="frame" style="animation-delay: {number * FRAME_SECONDS - turn:g}s">{frame}</g>\n'
        for number, frame in enumerate(frames)
    ]
    size = re.search(r'viewBox="[^"]*"', frames[0])
    assert size is not None
    head = f'<svg {size[0]} xmlns="http://www.w3.org/2000/svg">\n<style>\n{style}\n</style>\n'
    picture.write_text(head + "".join(shown) + "</svg>\n")


def doctor(picture: Path) -> None:
    """Draw `unity-link doctor` on a line that damages bytes."""
    with Terminal(110, 40) as terminal:
        terminal.enter('unity-link doctor "sim:?flip=0.001"')
        terminal.wait_for(r"throughput[^$]*\n\$$")
        picture.write_text(terminal.draw("unity-link doctor"))


def watch(picture: Path) -> None:
    """Draw `unity-link watch` of a rover that is being driven."""
    url = "unix:rover"
    with Terminal(90, 14) as terminal, _beside("serve", ROVER, "--unix", f"{terminal.folder}/rover"):
        terminal.enter(f"cd {terminal.folder}; clear")
        terminal.wait_for(r"\A\$$")
        terminal.enter(f"unity-link watch {url} {ROOT}/examples/rover.ul left.speed left.position right.speed")
        terminal.wait_for("right.speed.* 0")
        for left, right in ((0.5, 0.5), (0.9, 0.2), (-0.3, 0.6)):
            _run(
                "set", f"unix:{terminal.folder}/rover", "examples/rover.ul", f"left.duty={left}", f"right.duty={right}"
            )
            time.sleep(DRIVEN_FOR)
        picture.write_text(terminal.draw("unity-link watch"))


def rover(picture: Path) -> None:
    """Take the plot of the tutorial."""
    with tempfile.TemporaryDirectory() as folder:
        follow(ROOT / "docs" / "tutorials" / "rover.md", Path(folder))
        picture.write_bytes(Path(folder, "run.png").read_bytes())


def symbol(core: CoreEntry, picture: Path) -> None:
    """Draw a core with its pins."""
    assert core.component.core is not None
    arrows = {Way.IN: "<-", Way.OUT: "->", Way.INOUT: "<->"}
    wiring.symbol(core.word, {pin.name: arrows[pin.way] for pin in core.component.core.pins}, picture)


PICTURES: dict[str, Callable[[Path], None]] = {
    "demo.svg": demo,
    "balancer.svg": draw_balancer,
    "gantry.svg": draw_gantry,
    "wiring-uart.svg": wiring.uart,
    "wiring-ft245.svg": wiring.ft245,
    "wiring-rs485.svg": wiring.rs485,
    "wiring-motor.svg": wiring.motor,
    "core-of-your-own.svg": wiring.own_core,
    "lease.svg": wiring.lease,
    **{SYMBOL.format(core.folder): functools.partial(symbol, core) for core in installed_cores()},
    "doctor.svg": doctor,
    "watch.svg": watch,
    "rover.png": rover,
    "live.png": draw_live,
    "live-phone.png": lambda picture: draw_live(picture, on_phone=True),
}


class Terminal:
    """A shell in a terminal of tmux.

    Args:
        width: columns.
        height: rows.
    """

    def __init__(self, width: int, height: int) -> None:
        self._width, self._height = width, height
        self._scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self._scratch.name)
        """Folder that is deleted with the terminal."""

    def __enter__(self) -> Self:
        """Open it."""
        size = ("-x", str(self._width), "-y", str(self._height))
        self._tmux("-f", os.devnull, "new-session", "-d", *size, "-c", str(ROOT), "sh")
        self.enter("PS1='$ '; clear")
        self.wait_for(r"\A\$$")
        return self

    def __exit__(self, *_: object) -> None:
        """Close it."""
        self._tmux("kill-server")
        self._scratch.cleanup()

    def enter(self, line: str) -> None:
        """Type a line."""
        self._tmux("send-keys", "-l", line)
        self._tmux("send-keys", "Enter")

    def wait_for(self, pattern: str) -> None:
        """Wait until a pattern is on the screen.

        Raises:
            TimeoutError: the pattern did not appear in time.
        """
        end = time.monotonic() + PATIENCE
        while not re.search(pattern, self._tmux("capture-pane", "-p").rstrip()):
            if time.monotonic() > end:
                raise TimeoutError(f"{pattern} does not come, this stays:\n{self._tmux('capture-pane', '-p')}")
            time.sleep(0.05)

    def draw(self, title: str, name: str | None = None) -> str:
        """Return the screen as SVG, without empty lines and a prompt at its end.

        Args:
            title: title of the window.
            name: prefix of its styles; by default the last word of the title.
        """
        screen = re.sub(r"(\n\$ ?)?\s*\Z", "", self._tmux("capture-pane", "-p", "-e"))
        console = Console(
            record=True,
            force_terminal=True,
            color_system="truecolor",
            width=self._width,
            file=io.StringIO(),
            legacy_windows=False,
        )
        console.print(Text.from_ansi(screen))
        # A fixed name instead of one made of the content keeps the difference between two pictures small.
        svg = console.export_svg(title=title, unique_id=name or title.rpartition(" ")[2])
        # A page must not fetch the fonts that rich names on the network, and the reader's own will do.
        return re.sub(r"\s*@font-face \{.*?\}", "", svg, flags=re.DOTALL) + "\n"

    def _tmux(self, *arguments: str) -> str:
        command = ["tmux", "-u", "-S", str(self.folder / "tmux"), *arguments]
        return subprocess.run(command, env=_environment(), capture_output=True, text=True, check=True).stdout  # noqa: S603


def _environment() -> dict[str, str]:
    own = {name: value for name, value in os.environ.items() if name not in {"TMUX", "COLUMNS", "LINES"}}
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    return own | {"PATH": path, "LC_ALL": "C.UTF-8", "COLORTERM": "truecolor"}


def _run(*arguments: str) -> None:
    command = ["unity-link", *arguments]
    subprocess.run(command, cwd=ROOT, env=_environment(), check=True, stdout=subprocess.DEVNULL)  # noqa: S603


@contextlib.contextmanager
def _beside(*arguments: str) -> Iterator[None]:
    command = ["unity-link", *arguments]
    with subprocess.Popen(command, cwd=ROOT, env=_environment(), stdout=subprocess.PIPE) as process:  # noqa: S603
        try:
            assert process.stdout is not None
            process.stdout.readline()
            yield
        finally:
            process.terminate()


def main(names: list[str]) -> None:
    """Make pictures."""
    for name in names or PICTURES:
        if name not in PICTURES:
            sys.exit(f"error: there is no picture {shlex.quote(name)}: those are {', '.join(PICTURES)}")
        PICTURES[name](HERE / name)
        print(HERE / name)  # noqa: T201  (a command)


if __name__ == "__main__":
    main(sys.argv[1:])
