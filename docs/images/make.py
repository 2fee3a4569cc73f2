"""Makes `demo.svg`, the picture of `unity-link demo` in the README: ``python docs/images/make.py``.

It runs the demo without a terminal and draws it as it stands at a good moment.
"""

import asyncio
import io
import re
from pathlib import Path

from rich.console import Console

import unity_link
from unity_link.cli.demo import Demo
from unity_link.cli.demo_view import render

URL = "sim:scara"
MOMENT = 6.6
"""Seconds after the beginning of the motion."""
WIDTH, HEIGHT = 110, 40


async def draw() -> str:
    """Run the demo and give the picture as SVG."""
    console = Console(
        record=True,
        force_terminal=True,
        color_system="truecolor",
        width=WIDTH,
        height=HEIGHT,
        file=io.StringIO(),
        legacy_windows=False,
    )
    async with unity_link.connect(URL) as link:
        demo = Demo(URL, link, 10.0)
        moment = asyncio.Event()
        running = asyncio.create_task(demo.run(picture=lambda: moment.set() if demo.elapsed >= MOMENT else None))
        await moment.wait()
        console.print(render(demo, console.size))
        running.cancel()
        await asyncio.wait([running])
    # A fixed name instead of one made of the content keeps the difference between two pictures small.
    return console.export_svg(title="unity-link demo", unique_id="demo")


def without_remote_fonts(svg: str) -> str:
    """Take out the fonts that rich names on the network: a page must not fetch them, and the reader's own will do."""
    return re.sub(r"\s*@font-face \{.*?\}", "", svg, flags=re.DOTALL)


if __name__ == "__main__":
    Path(__file__).with_name("demo.svg").write_text(without_remote_fonts(asyncio.run(draw())) + "\n")
