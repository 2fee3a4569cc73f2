"""Generation: what other languages and the gateware need of a spec, written from it.

One folder a target, with its templates. The module of a target has

- ``DOC``: what it makes, in a line
- ``files(interface, templates)``: the files, one after another; `templates` renders those of its folder
- where users choose something beside the spec, ``Options``, a named tuple that `files` takes as well

A new target is a new folder and a new word of `TargetName`. Output is the same for the same spec, byte for byte, and
each file begins by naming the spec and its hash (`Templates.origin`)::

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
"""Each is a folder of this package."""
TARGETS: tuple[str, ...] = get_args(TargetName)


_QUOTING: dict[str, Callable[..., Any]] = {
    name: function for name, function in vars(quoting).items() if inspect.isfunction(function) and name[0] != "_"
}
"""Functions that every template has for strings from outside, by name."""
_COPIED = ("c", "cpp", "verilog", "vhdl")
"""Targets of which users copy the files into sources of their own."""


_TAKEN_BY = dict.fromkeys(("maintainer", "email", "licence"), "ros1 and ros2") | dict.fromkeys(
    ("clock_hz", "baud", "unchecked"), "verilog"
)
"""The targets that take an option: in their modules, the fields of ``Options``."""


class GeneratedFile(NamedTuple):
    """A file that a target makes."""

    name: str
    """Its path in the directory that is written to, with slashes."""
    text: str
    executable: bool = False
    """True if it is a program."""


class Target(Protocol):
    """Interface of a target's module."""

    DOC: str

    def files(self, interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
        """Make the files of an interface.

        Raises:
            UnsupportedError: where the target cannot say what the spec says.
        """


@functools.cache
def _environment(target: str, filters: tuple[tuple[str, Callable[..., Any]], ...]) -> jinja2.Environment:
    """Return the environment of a target's templates, of which each is compiled once."""
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
        spec: that the files name as their origin; None: they name none.
        filters: of the target.
    """

    def __init__(self, target: str, spec: Spec | None, filters: Mapping[str, Callable[..., Any]]) -> None:
        self._environment = _environment(target, tuple(filters.items()))
        self._spec = spec
        self.vhdl = () if spec is None else tuple(Path(path) for path in spec.vhdl)
        """Files of VHDL of the spec's own cores."""
        self.origin = () if spec is None else _origin(target, spec)
        """Lines that name the sources, for the comment at the top of each file."""

    def render(self, name: str, **values: Any) -> str:
        """Render ``NAME.jinja``, which sees `origin` and the values."""
        return self._environment.get_template(f"{name}.jinja").render(origin=self.origin, **values)

    def of(self, target: str, filters: Mapping[str, Callable[..., Any]]) -> Templates:
        """Return the templates of another target, for one that builds on it."""
        return Templates(target, self._spec, filters)


def generate(target: str, spec: Spec, interface: str | None = None, **options: str | int) -> list[GeneratedFile]:
    """Make the files of a target.

    Args:
        target: one of `TARGETS`.
        spec: a compiled spec.
        interface: which public interface, where there are several.
        options: ``maintainer``, ``email`` and ``licence`` of a package of ROS, ``clock_hz``, ``baud`` and
            ``unchecked`` of Verilog.

    Raises:
        ArgumentError: for a target or an interface that there is not, or an option that belongs to another target.
        UnsupportedError: where the target cannot say what the spec says.
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
        ArgumentError: where there is none of that name.
    """
    if name not in TARGETS:
        raise ArgumentError(f"there is no target {name!r}: one of {', '.join(TARGETS)} was expected")
    return cast("Target", importlib.import_module(f"unity_link.generate.{name}"))


def write(files: list[GeneratedFile], directory: Path, *, overwrite: Overwrite = False) -> list[Path]:
    """Write files below a directory, which is made; those of before are replaced, when all are written.

    Args:
        files: what is written.
        directory: where to.
        overwrite: whether files that this package did not make may go.

    Raises:
        ArgumentError: where that cannot be done; nothing of it is left then, and what was there before is as it was.
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
