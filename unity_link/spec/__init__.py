"""UL-spec: declares the signals of a robot once, for all programs, languages and gateways that use them.

The stages of compilation and their modules:

- `tokens`, `grammar.lark`, `parser`, `comments`: text to syntax tree; `recovery` finds the faults after the first one
- `syntax`: the syntax tree; `printer`: syntax tree to text
- `loading`: reads the file and its imports
- `cores`: finds and reads the files of the cores that the spec names
- `elaborate`, `placing`, `building`: syntax tree to model in a `context`, by `expressions`, `arguments`, `signals`,
  `modules`
- `interface`: checks of a whole interface
- `model`, `kinds`, `columns`: the checked model, conversion of bits to values, and the same for arrays
- `ranges`: checks the numbers of a model that was read from a file
- `diagnostics`: messages to the author
- `systemrdl`: conversion from and to SystemRDL

Other packages use these names::

    spec = compile_file("robot.ul")
    for signal in spec.interface().signals.values():
        print(signal.path, hex(signal.address), signal.kind)
"""

from __future__ import annotations

import functools
import gc
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from unity_link.spec.diagnostics import Diagnostic, Reporter, SourceText, Span, SpecError
from unity_link.spec.kinds import Enumeration, EnumValue, Kind, KindName, Value
from unity_link.spec.model import (
    STAGE_BITS,
    Access,
    ComponentArray,
    ComponentSpec,
    Core,
    Effect,
    GroupSpec,
    Interface,
    Joint,
    ModuleSpec,
    Parameter,
    ParameterReference,
    Pin,
    Safe,
    Sensor,
    Signal,
    SourceFile,
    Spec,
    Trigger,
    Way,
)

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

__all__ = [
    "STAGE_BITS",
    "Access",
    "ComponentArray",
    "ComponentSpec",
    "Core",
    "Diagnostic",
    "Effect",
    "EnumValue",
    "Enumeration",
    "GroupSpec",
    "Interface",
    "Joint",
    "Kind",
    "KindName",
    "ModuleSpec",
    "Parameter",
    "ParameterReference",
    "Pin",
    "Safe",
    "Sensor",
    "Signal",
    "SourceFile",
    "Span",
    "Spec",
    "SpecError",
    "Trigger",
    "Value",
    "Way",
    "compile_description",
    "compile_file",
    "compile_text",
    "format_text",
]


def compile_file(path: str | Path, *, address_bits: int | None = None, data_bits: int | None = None) -> Spec:
    """Compile a spec file.

    Args:
        path: the file.
        address_bits: width of the gateway's addresses, if it is known; a different width in the spec is an error.
        data_bits: width of the gateway's words, likewise.

    Raises:
        SpecError: with all faults of the spec, or the reason why the file cannot be read.
    """
    from unity_link.spec.loading import read_text

    try:
        text = read_text(Path(path))
    except ValueError as error:
        place = Span(str(path), 1, 1, 1, 1)
        raise SpecError([Diagnostic("error", "unreadable", str(error), place)]) from None
    return compile_text(text, str(path), path=Path(path), address_bits=address_bits, data_bits=data_bits)


def compile_text(
    text: str,
    name: str = "<text>",
    *,
    path: Path | None = None,
    address_bits: int | None = None,
    data_bits: int | None = None,
) -> Spec:
    """Compile the text of a spec.

    Args:
        text: the spec.
        name: name of the text in messages.
        path: file that contains the text; imports are relative to its folder, without a path to the working directory.
        address_bits: as for `compile_file`.
        data_bits: as for `compile_file`.

    Raises:
        SpecError: with all faults of the spec.
    """
    # Recordings and generated files store this name as text, but a file name may be any bytes.
    name = name.encode(errors="backslashreplace").decode()
    return _compile(text, name, path, None, (address_bits, data_bits), Reporter())


def compile_description(description: bytes, address_bits: int | None = None, data_bits: int | None = None) -> Spec:
    """Compile the description that a board carries. No file of the user is read, and no code is executed.

    Args:
        description: compressed description of one interface.
        address_bits: as for `compile_file`.
        data_bits: as for `compile_file`.

    Raises:
        ValueError: if the bytes are not a description, or need more work or memory than the largest allowed spec.
        SpecError: with the first error of its text, for example if the board has another version of this package.
    """
    from unity_link.spec.description import DescriptionReporter, unpack
    from unity_link.spec.known import misfits

    text, maps = unpack(description)
    reporter = DescriptionReporter([text, *maps.values()])
    spec = _compile(text, "<description>", None, maps, (address_bits, data_bits), reporter)
    for interface in spec.interfaces:
        vars(interface)["misfits"] = misfits(
            interface, lambda text, maps: _compile(text, "<core>", None, maps, (None, None), Reporter())
        )
    return spec


def _compile(
    text: str,
    name: str,
    path: Path | None,
    maps: Mapping[str, str] | None,
    widths: tuple[int | None, int | None],
    reporter: Reporter,
) -> Spec:
    """Compile a spec, as `compile_text`; `maps` has the maps of all cores by word, if they come with the spec."""
    from unity_link.spec.cores import Cores
    from unity_link.spec.description import describe
    from unity_link.spec.elaborate import Elaborator
    from unity_link.spec.loading import Loader, read_import, refuse_import

    with _no_garbage_collection():
        loader = Loader(reporter, read_import if maps is None else refuse_import)
        loader.load(name, text, path)
        # Do not elaborate after a syntax error: its file declares nothing, so every use would be reported as a fault.
        beside = None if maps is not None else Path() if path is None else path.parent
        cores = Cores(reporter, beside, maps)
        interfaces = () if reporter.failed else Elaborator(loader.declarations, reporter, cores, *widths).run()
    if not interfaces and not reporter.failed:
        first = loader.declarations.sources[0]
        advice = "mark the outermost component with 'public'"
        reporter.warning(first, (0, 0), "no-interface", "nothing in this file is public", help=advice)
    if reporter.failed:
        raise SpecError(reporter.diagnostics)
    for interface in interfaces:
        words = {part.core.word for part in interface.cores if part.core is not None}
        known = {word: cores.found[word].context.declarations for word in words & {*cores.found}}
        # Keep the texts out of the model, because generated modules contain the model.
        texts = {
            word: tuple(source.text for source in declarations.declared)
            for word, declarations in {"": loader.declarations, **known}.items()
        }
        vars(interface)["describe"] = functools.partial(describe, interface.name, texts)
    sources = tuple(SourceFile(source.name, source.sha256) for source in (*loader.declarations.sources, *cores.sources))
    return Spec(interfaces=interfaces, sources=sources, warnings=reporter.diagnostics)


def format_text(text: str, name: str = "<text>") -> str:
    """Return the text of a spec in its canonical layout, comments included.

    Raises:
        SpecError: if the text cannot be parsed; other faults are not reported.
    """
    from unity_link.spec.parser import parse
    from unity_link.spec.printer import print_file

    reporter = Reporter()
    with _no_garbage_collection():
        file = parse(SourceText(name, text), reporter)
    if file is None:
        raise SpecError(reporter.diagnostics)
    return print_file(file)


@contextmanager
def _no_garbage_collection() -> Iterator[None]:
    """Pause garbage collection while trees grow; collections would take a quarter of the time of a large spec."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
