"""`unity-link check`, `fmt`, `show`: specs, without a gateway. `import rdl`, `export rdl`: SystemRDL.

Errors and warnings of a spec are printed on stderr like those of a compiler; under ``--json`` on stdout, as data.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from unity_link.cli.arguments import DEFAULT_TIMEOUT, Json, Overwrite
from unity_link.cli.output import console_on, may_overwrite, out, print_json, print_line, print_note
from unity_link.cli.running import run
from unity_link.files import write_file

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from unity_link.spec import ComponentArray, ComponentSpec, Diagnostic, Interface, ModuleSpec, Signal, Spec

STDIN = "-"
SPEC_VARIABLE = "UNITY_LINK_SPEC"
"""Environment variable with the spec for commands that are given none."""
FAILED = 1
_MOST_COLUMNS = 1000

SpecFile = Annotated[
    str,
    typer.Argument(
        metavar="SPEC",
        help="A spec, such as robot.ul; - is stdin; or the URL of a board that carries its own.",
        show_default=False,
    ),
]
SpecOrBoard = Annotated[
    str | None,
    typer.Argument(
        metavar="[SPEC]",
        help="A spec, such as robot.ul; without one, that which the board carries.",
        show_default=False,
    ),
]
SpecFiles = Annotated[
    list[Path], typer.Argument(metavar="SPEC...", help="Specs, such as robot.ul; - is stdin.", show_default=False)
]
AddressBits = Annotated[
    int | None, typer.Option("--address-bits", min=8, max=32, help="Width of the gateway's addresses.")
]
DataBits = Annotated[int | None, typer.Option("--data-bits", min=8, max=64, help="Width of the gateway's words.")]
Output = Annotated[Path | None, typer.Option("--output", "-o", metavar="FILE", help="Where to write; stdout without.")]
Name = Annotated[str | None, typer.Option("--interface", help="Which public interface, where there are several.")]
Given = Annotated[
    list[str] | None,
    typer.Option(
        "--give", metavar="NAME=ADDRESS", help="A parameter of the interface, such as ctrl=0xF0; may be repeated."
    ),
]


def add_to(app: typer.Typer) -> None:
    """Add the commands of this file."""
    app.command()(check)
    app.command()(fmt)
    app.command()(show)
    importing = typer.Typer(help="Convert another description of registers to a spec.", no_args_is_help=True)
    importing.command("rdl")(import_rdl)
    app.add_typer(importing, name="import")


def check(spec: SpecFile, *, json: Json = False, address_bits: AddressBits = None, data_bits: DataBits = None) -> None:
    """Check a spec, and report all of its errors."""
    from unity_link.spec import SpecError

    compiled: Spec | None = None
    diagnostics: Iterable[Diagnostic]
    try:
        compiled = _compile(spec, address_bits, data_bits)
        diagnostics = compiled.warnings
    except SpecError as error:
        diagnostics = error.diagnostics
    if json:
        print_json({"spec": str(spec), "valid": compiled is not None, "diagnostics": diagnostics})
    else:
        print_diagnostics(diagnostics)
        if compiled is not None:
            print_line(f"{spec}: {_described(compiled)}")
    if compiled is None:
        raise typer.Exit(FAILED)


def fmt(
    specs: SpecFiles,
    *,
    check: Annotated[bool, typer.Option("--check", help="Change nothing; fail if a file would change.")] = False,
    diff: Annotated[bool, typer.Option("--diff", help="Change nothing; print what would change.")] = False,
) -> None:
    """Put specs into the canonical layout. Comments stay."""
    from unity_link.spec import SpecError, format_text

    failed = changed = False
    for spec in specs:
        try:
            text = _read(spec)
            formatted = format_text(text, str(spec))
        except SpecError as error:
            print_diagnostics(error.diagnostics)
            failed = True
            continue
        if diff:
            _print_diff(str(spec), text, formatted)
        elif str(spec) == STDIN and not check:
            sys.stdout.write(formatted)
        elif text != formatted and not check:
            # Overwrite without asking: the user named this file to be formatted.
            write_file(spec, formatted.encode(), overwrite=True)
        if text != formatted:
            changed = True
            if not diff and str(spec) != STDIN:
                print_note(f"{'would change' if check else 'changed'} {spec}")
    if failed or (check and changed):
        raise typer.Exit(FAILED)


def show(
    spec: SpecFile,
    *,
    interface: Name = None,
    json: Json = False,
    address_bits: AddressBits = None,
    data_bits: DataBits = None,
) -> None:
    """Show all signals of a spec in a tree, and the pins of the board that it names.

    For a signal: address, kind, access, scale, unit, limits, group, value after a reset, safe value with the lease that
    guards it, schedule if it is TIMED, and pin. For a core: entity and pins.
    """
    compiled = compile_or_exit(spec, address_bits, data_bits)
    chosen = compiled.interfaces if interface is None else (compiled.interface(interface),)
    if json:
        for one in chosen:
            print_json(one)
        return
    console = out()
    if not console.is_terminal:
        # Do not wrap or cut the tree in a pipe.
        console.width = _MOST_COLUMNS
    for one in chosen:
        console.print(_tree(one))


def import_rdl(
    files: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILE...", help="SystemRDL; later files use what earlier ones declare.", show_default=False
        ),
    ],
    *,
    output: Output = None,
    top: Annotated[str | None, typer.Option("--top", help="The address map; the last one without.")] = None,
    include: Annotated[
        list[Path] | None,
        typer.Option("--include", "-I", metavar="FOLDER", help="Folder of included files; may be repeated."),
    ] = None,
    perl: Annotated[
        bool, typer.Option("--perl", help="Run the Perl in it, in a sandbox, for 5 seconds at most.")
    ] = False,
    seconds: Annotated[int, typer.Option("--seconds", min=1, help="Limit of its processor time.")] = 30,
    overwrite: Overwrite = False,
) -> None:
    """Convert a SystemRDL description to a spec, and verify that both describe the same registers."""
    from unity_link.cli.bounded import call_bounded
    from unity_link.spec import SpecError
    from unity_link.spec.systemrdl import import_file

    try:
        # Run it in a process of its own: a few lines of macros can use any amount of time and memory.
        imported = call_bounded(
            lambda: import_file(*files, top=top, include=include or (), perl=perl), str(files[-1]), seconds
        )
    except SpecError as error:
        print_diagnostics(error.diagnostics)
        raise typer.Exit(FAILED) from None
    print_diagnostics(imported.warnings)
    _write(output, imported.text, overwrite=overwrite)


def export_rdl(spec: SpecFile, *, interface: Name = None, output: Output = None, overwrite: Overwrite = False) -> None:
    """Convert a spec to a SystemRDL description."""
    from unity_link.spec.systemrdl import export_text

    compiled = compile_or_exit(spec)
    _write(output, export_text(compiled.interface(interface)), overwrite=overwrite)


# For commands that need a spec


def compile_or_exit(
    spec: Path | str,
    address_bits: int | None = None,
    data_bits: int | None = None,
    *,
    interface: str | None = None,
    given: list[str] | None = None,
) -> Spec:
    """Compile a spec for a command. If it has errors, print them and end the command.

    Args:
        spec: path of the file, or URL of a board that carries its own spec.
        address_bits: as for `compile_file`.
        data_bits: as for `compile_file`.
        interface: name of the interface that the command uses.
        given: parameters of that interface, as ``NAME=ADDRESS``.

    Raises:
        typer.Exit: with code 1 if the spec has errors.
        ArgumentError: for an unknown parameter, a value that is not an address, or a board without a spec.
    """
    from unity_link.spec import SpecError

    try:
        compiled = _compile(spec, address_bits, data_bits)
    except SpecError as error:
        print_diagnostics(error.diagnostics)
        raise typer.Exit(FAILED) from None
    print_diagnostics(compiled.warnings)
    return compiled.given(read_given(given or []), interface)


def spec_behind(url: str, spec: str | None) -> str:
    """Return the spec that a command was given, otherwise the URL of the board, which may carry one.

    Raises:
        ArgumentError: if URL and spec are swapped.
    """
    from unity_link.errors import ArgumentError
    from unity_link.transport import is_url

    if spec is not None and is_url(spec) and not is_url(url):
        raise ArgumentError(f"URL and SPEC are swapped: {spec} {url} was expected")
    return spec or url


def url_and_spec(
    place: str | None, spec: str | None, link: str | None, configured: str | None = None
) -> tuple[str, str]:
    """Return the URL of a bridge and its spec; without a spec, the URL twice, for the spec that the board carries.

    Args:
        place: the first argument: the URL; or the spec, if `link` or `configured` is the URL.
        spec: the second argument.
        link: the URL of ``--link``.
        configured: the URL in a parameter file; the other URLs override it.

    Raises:
        ArgumentError: if no URL is given, or two are, or URL and spec are swapped.
    """
    from unity_link.errors import ArgumentError
    from unity_link.transport import is_url

    if link is not None and spec is not None:
        raise ArgumentError(f"the gateway is {place} and --link {link}: one URL was expected")
    if link is None and place is not None and (spec is not None or is_url(place)):
        return place, spec_behind(place, spec)
    url = link or configured
    if url is None:
        raise ArgumentError("nothing says where the gateway is: a URL such as sim:scara was expected before the SPEC")
    return url, place or url


def read_given(texts: list[str]) -> dict[str, int]:
    """Parse parameters that are given as ``NAME=ADDRESS``.

    Raises:
        ArgumentError: for a text of another form, or a repeated name.
    """
    from unity_link.cli.words import parse_number
    from unity_link.errors import ArgumentError

    values: dict[str, int] = {}
    for text in texts:
        name, equals, number = (part.strip() for part in text.partition("="))
        if not equals or not name:
            raise ArgumentError(f"--give {text}: NAME=ADDRESS was expected, such as ctrl=0xF0")
        if name in values:
            raise ArgumentError(f"--give {text}: {name} was given twice")
        try:
            values[name] = parse_number(number)
        except ValueError as error:
            raise ArgumentError(f"--give {text}: {error}") from None
    return values


def print_diagnostics(diagnostics: Iterable[Diagnostic]) -> None:
    """Print diagnostics and their number on stderr; print nothing if there are none."""
    from rich.text import Text

    from unity_link.spec.diagnostics import MOST_SHOWN, summary

    found = list(diagnostics)
    if not found:
        return
    console = console_on(sys.stderr, soft_wrap=True)
    for diagnostic in found[:MOST_SHOWN]:
        text = Text(diagnostic.render())
        colour = "red" if diagnostic.severity == "error" else "yellow"
        text.highlight_regex(rf"(?<=: ){diagnostic.severity}: .*", f"bold {colour}")
        text.highlight_regex(r"(?m)^ +\| [\t ]*\^+$", colour)
        text.highlight_regex(r"(?m)^  help: ", "bold cyan")
        text.highlight_regex(r"(?<=: )note: ", "bold")
        console.print(text)
    console.print(Text(summary(found)))


# Helpers of this module


def _read(spec: Path) -> str:
    from unity_link.spec import Diagnostic, Span, SpecError
    from unity_link.spec.loading import read_text

    try:
        if str(spec) == STDIN:
            return sys.stdin.buffer.read().decode("utf-8-sig").replace("\r\n", "\n")
        return read_text(spec)
    except ValueError as error:
        message = "stdin is no UTF-8 text" if isinstance(error, UnicodeDecodeError) else str(error)
        raise SpecError([Diagnostic("error", "unreadable", message, Span(str(spec), 1, 1, 1, 1))]) from None


async def _carried(url: str) -> Spec:
    """Return the spec that a board carries.

    Raises:
        ArgumentError: if it carries none.
        UnsupportedError: if this version cannot read it.
        ConnectError: if the gateway cannot be reached.
    """
    from unity_link.data.describing import read_spec
    from unity_link.errors import ArgumentError
    from unity_link.link.connecting import connect
    from unity_link.protocol.wire.configuration import Feature

    async with connect(url, timeout=DEFAULT_TIMEOUT) as link:
        if Feature.DESCRIPTION not in link.gateway.features:
            raise ArgumentError(
                f"no SPEC says which signals there are, and the gateway of {url} carries no description of its own: "
                f"give a spec, such as robot.ul, or set {SPEC_VARIABLE}"
            )
        return await read_spec(link)


def _compile(spec: Path | str, address_bits: int | None, data_bits: int | None) -> Spec:
    from unity_link.spec import compile_text
    from unity_link.transport import is_url

    if is_url(str(spec)):
        return run(_carried(str(spec)))
    path = None if str(spec) == STDIN else Path(spec)
    return compile_text(_read(Path(spec)), str(spec), path=path, address_bits=address_bits, data_bits=data_bits)


def _described(spec: Spec) -> str:
    parts = [f"{one.name} with {_counted(len(one.signals), 'signal')}" for one in spec.interfaces]
    return f"no errors; {', '.join(parts) or 'no public interface'}"


def _counted(count: int, noun: str) -> str:
    return f"{count} {noun}{'s' * (count != 1)}"


def _print_diff(name: str, before: str, after: str) -> None:
    import difflib

    lines = difflib.unified_diff(
        before.splitlines(keepends=True), after.splitlines(keepends=True), f"{name} as it is", f"{name} formatted"
    )
    for line in lines:
        sys.stdout.write(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n")
    sys.stdout.flush()


def _write(output: Path | None, text: str, *, overwrite: bool) -> None:
    if output is None or str(output) == STDIN:
        sys.stdout.write(text)
        sys.stdout.flush()
        return
    write_file(output, text.encode(), overwrite=may_overwrite(overwrite))


def _tree(interface: Interface) -> Any:
    from rich.text import Text
    from rich.tree import Tree

    from unity_link.spec import words

    digits = -(-interface.address_bits // 4)
    head = f"  {interface.address_bits} address bits, {interface.data_bits} data bits"
    tree = Tree(Text.assemble((interface.name, "bold"), (head, "dim")))
    for module in interface.modules:
        if module.path is None:
            tree.add(Text.assemble((module.type, "magenta"), (f"  {_module(module, digits)}", "dim")))
    for group in interface.groups:
        when = [
            f"base frequency / {group.divisor}" if group.divisor is not None else "",
            f"{group.published_hz:.6g} Hz" if group.rate_hz is not None and group.published_hz is not None else "",
            "on its trigger" if group.trigger else "",
            f"{_counted(len(group.signals), 'signal')} in {_counted(len(group.addresses), 'word')}",
        ]
        number = "" if group.number is None else f" {group.number}"
        text = ", ".join(filter(None, when))
        tree.add(Text.assemble(("group ", "magenta"), (group.name, "bold"), (f"{number}: {text}", "dim")))
    _add_component(tree, interface, interface.root, digits)
    if pins := list(words.wired(interface)):
        branch = tree.add(Text("pins of the board", "magenta"))
        for site, way, path in pins:
            branch.add(Text.assemble((site, "green"), f": {path}", (f"  {way}", "dim")))
    return tree


def _add_component(tree: Any, interface: Interface, component: ComponentSpec, digits: int) -> None:
    from rich.text import Text

    from unity_link.spec import words

    for number in component.modules:
        module = interface.modules[number]
        name = (module.path or "").rpartition(".")[2]
        tree.add(Text.assemble((name, "bold cyan"), f": {module.type}", (f"  {_module(module, digits)}", "dim")))
    for signal in component.signals:
        tree.add(_signal(signal, digits))
    for name, word, said in _ports(component):
        tree.add(Text.assemble((name, "bold"), f": {word}", (f"  {said}", "dim")))
    for part in component.parts:
        for item in _items(part):
            index = "" if item.index is None else f"[{item.index}]"
            behind = "" if item.core is None else f"  {words.entity(item.core)}"
            branch = tree.add(Text.assemble((item.name + index, "bold cyan"), f": {item.type}", (behind, "dim")))
            _add_component(branch, interface, item, digits)


def _ports(component: ComponentSpec) -> Iterator[tuple[str, str, str]]:
    """Yield the pins and triggers of a component: name, word, and connection."""
    from unity_link.spec import words

    if component.core is not None:
        yield from ((pin.name, f"PIN({pin.way})", words.site(pin)) for pin in component.core.pins)
        yield from ((one.name, "TRIGGER", words.triggered(one)) for one in component.core.triggers)


def _items(part: ComponentSpec | ComponentArray) -> tuple[ComponentSpec, ...]:
    items: tuple[ComponentSpec, ...] | None = getattr(part, "items", None)
    return (part,) if items is None else items  # type: ignore[return-value]


def _module(module: ModuleSpec, digits: int) -> str:
    size = f", {module.words} words" if module.words is not None else ""
    return f"at 0x{module.base:0{digits}X}{size}"


def _signal(signal: Signal, digits: int) -> Any:
    from rich.text import Text

    from unity_link.spec.words import at_hardware

    high = signal.lowest_bit + signal.width - 1
    whole = signal.lowest_bit == 0 and signal.width == signal.word_bits * signal.words
    bits = "" if whole else f"[{high}]" if signal.width == 1 else f"[{high}:{signal.lowest_bit}]"
    low, high_value = signal.minimum, signal.maximum
    notes = [
        "FIFO" if signal.fifo else "",
        f"published by {signal.group}" if signal.group else "",
        f"polled at {signal.poll_hz:g} Hz" if signal.poll_hz else "",
        *at_hardware(signal),
    ]
    details = [
        f"x {signal.kind.scale:.6g}" if signal.kind.scale != 1 else "",
        f"+ {signal.kind.offset:.6g}" if signal.kind.offset else "",
        signal.unit,
        f"{'' if low is None else f'{low:g}'}..{'' if high_value is None else f'{high_value:g}'}"
        if (low, high_value) != (None, None)
        else "",
        ", ".join(filter(None, notes)),
        f'"{signal.id}"' if signal.id != signal.path else "",
    ]
    return Text.assemble(
        (f"0x{signal.address:0{digits}X}{bits}", "green"),
        f" {signal.label}: {signal.kind} {signal.access}",
        (f"  {' '.join(filter(None, details))}", "dim"),
    )
