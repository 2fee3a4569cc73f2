"""Generation: writes code for other languages and the gateware from a spec.

Each target has a folder with its templates. The module of a target has

- ``DOC``: one line that describes its output
- ``files(interface, templates)``: yields the generated files; `templates` renders the templates of its folder
- ``Options``, if users can set options besides the spec: a named tuple, which `files` takes as a further argument

To add a target, add a folder and a word in `TargetName`. The output for a spec is always the same, byte for byte. Each
file begins with the name of the spec and its hash (`Templates.origin`)::

    for file in generate("c", compile_file("robot.ul")):
        print(file.name, len(file.text))
"""

from __future__ import annotations

import functools
import importlib
import inspect
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol, cast, get_args

from unity_link import quoting
from unity_link.errors import ArgumentError
from unity_link.files import MARK, write_texts
from unity_link.gateware import LICENCE

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping

    import jinja2

    from unity_link.files import Overwrite
    from unity_link.spec import Interface, Spec

TargetName = Literal["c", "cpp", "docs", "matlab", "python", "ros1", "ros2", "verilog", "vhdl"]
"""Names of targets; each is a folder of this package."""
TARGETS: tuple[str, ...] = get_args(TargetName)


_QUOTING: dict[str, Callable[..., Any]] = {
    name: function for name, function in vars(quoting).items() if inspect.isfunction(function) and name[0] != "_"
}
"""Functions that quote strings from outside, by name; every template has them as filters."""
_COPIED = ("c", "cpp", "verilog", "vhdl")
"""Targets whose files users copy into their own sources; these files name a licence."""


_TAKEN_BY = dict.fromkeys(("maintainer", "email", "licence"), "ros1 and ros2") | dict.fromkeys(
    ("clock_hz", "baud", "unchecked"), "verilog"
)
"""The targets that take each option; in their modules, the options are the fields of ``Options``."""


class GeneratedFile(NamedTuple):
    """A generated file."""

    name: str
    """Path relative to the output directory, with slashes."""
    text: str
    executable: bool = False
    """True if the file is to be made executable."""


class Target(Protocol):
    """The contents of a target's module."""

    DOC: str

    def files(self, interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
        """Yield the files of an interface.

        Raises:
            UnsupportedError: if the target cannot express something in the spec.
        """


@functools.cache
def _environment(target: str, filters: tuple[tuple[str, Callable[..., Any]], ...]) -> jinja2.Environment:
    """Return the Jinja environment of a target; it compiles each template once."""
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).with_name(target)),
        undefined=jinja2.StrictUndefined,
        autoescape=jinja2.select_autoescape(enabled_extensions=("html.jinja",)),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        finalize=lambda value: quoting.terminal(value) if isinstance(value, str) else value,
    )
    environment.filters.update(_QUOTING | dict(filters))
    return environment


class Templates:
    """The templates of a target, ``NAME.jinja`` in its folder.

    Args:
        target: one of `TARGETS`.
        spec: the spec that the files name as their origin; None if they name none.
        filters: additional filters of the target, by name.
    """

    def __init__(self, target: str, spec: Spec | None, filters: Mapping[str, Callable[..., Any]]) -> None:
        self._environment = _environment(target, tuple(filters.items()))
        self._spec = spec
        self.vhdl = () if spec is None else tuple(Path(path) for path in spec.vhdl)
        """VHDL files of the spec's own cores."""
        self.origin = () if spec is None else _origin(target, spec)
        """Lines that name the source files, for the comment at the top of each generated file."""

    def render(self, name: str, **values: Any) -> str:
        """Render ``NAME.jinja`` with `origin` and the given values."""
        return self._environment.get_template(f"{name}.jinja").render(origin=self.origin, **values)

    def of(self, target: str, filters: Mapping[str, Callable[..., Any]]) -> Templates:
        """Return the templates of another target, for a target that builds on it."""
        return Templates(target, self._spec, filters)


def generate(target: str, spec: Spec, interface: str | None = None, **options: str | int) -> list[GeneratedFile]:
    """Return the files of a target.

    Args:
        target: one of `TARGETS`.
        spec: a compiled spec.
        interface: name of the public interface, if the spec has several.
        options: ``maintainer``, ``email`` and ``licence`` of a ROS package, ``clock_hz``, ``baud`` and ``unchecked`` of
            Verilog.

    Raises:
        ArgumentError: for an unknown target or interface, or an option of another target.
        UnsupportedError: if the target cannot express something in the spec.
    """
    module = load_target(target)
    templates = Templates(target, spec, getattr(module, "FILTERS", {}))
    described = getattr(module, "Options", None)
    for option in options:
        if described is None or option not in described._fields:
            raise ArgumentError(f"{target} takes no {option}: it is for {_TAKEN_BY[option]}")
    if described is not None:
        return list(cast("Any", module).files(spec.interface(interface), templates, described(**options)))
    return list(module.files(spec.interface(interface), templates))


def load_target(name: str) -> Target:
    """Import the module of a target.

    Raises:
        ArgumentError: if there is no target of this name.
    """
    if name not in TARGETS:
        raise ArgumentError(f"there is no target {name!r}: one of {', '.join(TARGETS)} was expected")
    return cast("Target", importlib.import_module(f"unity_link.generate.{name}"))


def write(files: list[GeneratedFile], directory: Path, *, overwrite: Overwrite = False) -> list[Path]:
    """Write files to a directory, which is created if needed. Files of an earlier run are replaced, all or none.

    Args:
        files: the files to write.
        directory: the directory.
        overwrite: whether files that this package did not make may be replaced.

    Raises:
        ArgumentError: if a file cannot be written; existing files are then unchanged.
    """
    texts = {file.name: file.text for file in files}
    return write_texts(texts, directory, overwrite=overwrite, programs=[file.name for file in files if file.executable])


def _origin(target: str, spec: Spec) -> tuple[str, ...]:
    first, *imported = (f"{Path(source.name).name}, SHA-256 {source.sha256}" for source in spec.sources)
    return (
        f"{MARK} generate {target}` from {first}",
        *(f"which imports {source}" for source in imported),
        "Do not edit: change the spec and generate again.",
        *((LICENCE,) if target in _COPIED else ()),
    )
