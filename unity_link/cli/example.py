"""`unity-link example`: writes the programs and specs of an example, which the wheel contains."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

import unity_link
from unity_link.cli.arguments import Json, Overwrite
from unity_link.cli.output import may_overwrite, print_json, print_parts, print_result
from unity_link.errors import ArgumentError, did_you_mean

EXAMPLES = {
    "balancer": ("a robot on two wheels that stays upright", ("balance.py", "balancer.ul", "plant.py")),
    "gantry": ("a gantry that draws flowers with stepper motors", ("gantry.py", "gantry.ul", "plant.py")),
    "own_medium": ("a link through the pipes of a program", ("gateway_on_pipes.py", "own_medium.py")),
    "rover": ("a rover with two wheels, and its model", ("rover.py", "rover.ul")),
    "scara": ("the SCARA of the paper, also as a notebook", ("scara.ipynb", "scara.py", "scara.ul")),
    "twelve_axes": ("the spec of a machine with twelve axes and 64 pins", ("twelve_axes.ul",)),
    "walker": ("a walking robot of 18 joints", ("walker.py", "walker.ul")),
}
"""A line about each example, and its files. They are in the folder of this name if there is one."""


def add_to(app: typer.Typer) -> None:
    """Add the command of this file."""
    app.command("example")(example)


def example(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Example to write; without it, the examples are listed.")
    ] = None,
    *,
    output: Annotated[
        Path, typer.Option("--output", "-o", metavar="DIR", help="Where to write; created if it does not exist.")
    ] = Path("examples"),
    overwrite: Overwrite = False,
    json: Json = False,
) -> None:
    """Write an example and its spec to the folder `examples`, or list the examples."""
    if name is None:
        for each, (line, _) in EXAMPLES.items():
            if json:
                print_json({"name": each, "description": line})
            else:
                print_parts((f"{each:<{max(map(len, EXAMPLES))}}", "cyan"), "  ", line)
        return
    if name not in EXAMPLES:
        hint = did_you_mean(name, EXAMPLES) or f"one of {', '.join(EXAMPLES)} was expected"
        raise ArgumentError(f"there is no example {name!r}: {hint}")
    from unity_link.files import check_folder, write_files

    source = _folder()
    place = Path(name) if (source / name).is_dir() else Path()
    paths = [place / file for file in EXAMPLES[name][1]]
    check_folder(output, paths)
    texts = {output / path: (source / path).read_bytes() for path in paths}
    write_files(texts, overwrite=may_overwrite(overwrite))
    for path in texts:
        print_result("file", path, json=json)


def _folder() -> Path:
    """Return the folder of the examples: that of an installed package, or of the project."""
    package = Path(unity_link.__file__).parent
    installed = package / "examples"
    return installed if installed.is_dir() else package.parent / "examples"
