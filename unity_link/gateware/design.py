"""The VHDL of a design in a working folder of GHDL, to be analysed, synthesised and simulated.

Messages contain the path of a user's file as the user wrote it, and the name of a generated file without its folder.
"""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING, NamedTuple

from unity_link.errors import UnityLinkError
from unity_link.files import digest_of
from unity_link.gateware.cache import GATEWARE, LIBRARY
from unity_link.gateware.ghdl import converting_ghdl

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence
    from pathlib import Path

STD = "--std=08"
# Components without an entity are vendors' primitives: GHDL copies their instances into the Verilog.
_UNBOUND = "-Wno-binding"
_MESSAGE = re.compile(r"^(?P<file>.+?):(?P<place>\d+:\d+):(?P<kind>error|warning|\(assert failure\)): *(?P<words>.*)$")
# Ends of a simulation: a run-time error with its place, and a failed assertion.
_BOUND = re.compile(r"error: (?P<words>.+) at (?P<file>\S+):(?P<line>\d+)$", re.MULTILINE)
_STOPPED = re.compile(r"^(?P<file>.+?):(?P<place>\d+:\d+):@\w+:\(\w+ failure\): *(?P<words>.*)$", re.MULTILINE)
_CRASH = re.compile(r"^raised (.+)$", re.MULTILINE)
# GHDL 5.0.1 ends with an internal error if several output ports of instances have these names.
_KEYWORDS = frozenset(
    re.findall(
        r"\w+",
        "always assign automatic buf bufif0 bufif1 casex casez cell cmos config deassign default defparam design "
        "disable edge endcase endconfig endfunction endgenerate endmodule endprimitive endspecify endtable endtask "
        "event force forever fork genvar highz0 highz1 ifnone incdir include initial input instance join large "
        "liblist localparam macromodule medium module negedge nmos noshowcancelled notif0 notif1 output parameter "
        "pmos posedge primitive pull0 pull1 pulldown pullup pulsestyle_ondetect pulsestyle_onevent rcmos realtime "
        "reg release repeat rnmos rpmos rtran rtranif0 rtranif1 scalared showcancelled small specify specparam "
        "strong0 strong1 supply0 supply1 table task tran tranif0 tranif1 tri tri0 tri1 triand trior trireg uwire "
        "vectored wand weak0 weak1 wire wor",
    )
)
_OUTPUTS = re.compile(r"\b(\w+(?:\s*,\s*\w+)*)\s*:\s*(?:out|inout|buffer)\b", re.IGNORECASE)
_COMMENT = re.compile(r"--.*")


class ConversionError(UnityLinkError):
    """A tool refused the sources; the message is the reason."""


class OwnFile(NamedTuple):
    """A user's VHDL file."""

    path: Path
    """Path as the user wrote it."""
    data: bytes

    @property
    def digest(self) -> str:
        """SHA-256 in hex."""
        return digest_of(self.data)


class GhdlMessage(NamedTuple):
    """A message of GHDL about a place in a source."""

    file: str
    """Name of the file for messages."""
    place: str
    """Line and column, as in ``12:3``."""
    kind: str
    """Either `error`, `warning` or `(assert failure)`."""
    words: str
    is_own: bool
    """True if the file is a user's."""

    def __str__(self) -> str:
        return f"{self.file}:{self.place}: {self.words}"


class Renaming:
    """Renames output ports whose names are keywords of Verilog before GHDL reads VHDL, and back in GHDL's output.

    A new name differs from all words of the design and has the length of the old one, so that columns in messages stay
    correct.

    Args:
        texts: all VHDL of a design.
    """

    def __init__(self, texts: Iterable[str]) -> None:
        code = [_COMMENT.sub("", text) for text in texts]
        named = {name.strip().lower() for text in code for names in _OUTPUTS.findall(text) for name in names.split(",")}
        words = {word for text in code for word in re.findall(r"\w+", text.lower())} if named & _KEYWORDS else set()
        self._others: dict[str, str] = {}
        for name in sorted(named & _KEYWORDS):
            free = (f"{name[:-1]}{end}" for end in "0123456789" if f"{name[:-1]}{end}" not in words)
            self._others[name] = next(free)
            words.add(self._others[name])
        back = {other: name for name, other in self._others.items()}
        self._there = re.compile(rf"'.'|\"[^\"\n]*\"|\\[^\\\n]*\\|--.*|\b({'|'.join(self._others)})\b", re.IGNORECASE)
        self._back = re.compile(rf"\b(\w*?)({'|'.join(back)})(\w*)", re.IGNORECASE)
        self._names = back

    def __bool__(self) -> bool:
        return bool(self._others)

    def vhdl(self, text: str) -> str:
        """Return a VHDL text with the new names."""
        if not self:
            return text

        def other_of(found: re.Match[str]) -> str:
            return found[0][:-1] + self._others[found[1].lower()][-1] if found[1] else found[0]

        return self._there.sub(other_of, text)

    def verilog(self, text: str) -> str:
        """Return a Verilog text with the original names."""
        return self._restored(text, "\\{} ")

    def plain(self, text: str) -> str:
        """Return a message or another text with the original names."""
        return self._restored(text, "{}")

    def _restored(self, text: str, whole: str) -> str:
        if not self:
            return text

        def name_of(found: re.Match[str]) -> str:
            name = found[2][:-1] + self._names[found[2].lower()][-1]
            return whole.format(name) if not found[1] and not found[3] else f"{found[1]}{name}{found[3]}"

        return self._back.sub(name_of, text)


class GhdlDesign:
    """The VHDL of a design in a working folder of GHDL.

    Args:
        folder: an empty folder, which must exist as long as the object is used.
        gateware: sources of the gateware's library.
        others: further sources, in the library `work`.
        own: a user's files, in the library `work`; GHDL gets copies with generated names.

    Attributes:
        messages: GHDL's warnings so far.
        version: version line of GHDL.

    Raises:
        ConversionError: if GHDL cannot read a file.
        ToolMissingError: if there is no GHDL that can be used.
    """

    def __init__(
        self, folder: Path, gateware: Sequence[Path] = (), others: Sequence[Path] = (), own: Sequence[OwnFile] = ()
    ) -> None:
        self.messages: list[GhdlMessage] = []
        self._ghdl = converting_ghdl()
        self.version = self._ghdl.version()
        self._folder = folder.resolve()
        self._own = {f"own-{number}.vhd": file for number, file in enumerate(own)}
        texts = {path.resolve(): path.read_bytes().decode("latin-1") for path in (*gateware, *others)}
        texts |= {self._folder / name: file.data.decode("latin-1") for name, file in self._own.items()}
        self.renaming = Renaming(texts.values())
        self.copies = {file: self._folder / name for name, file in self._own.items()}
        """Path of GHDL's copy of each of the user's files."""
        staged: dict[Path, Path] = {}
        for number, (path, text) in enumerate(texts.items()):
            staged[path] = path
            renamed = self.renaming.vhdl(text)
            if renamed != text and path.parent != self._folder:
                staged[path] = self._folder / f"renamed-{number}" / path.name
                staged[path].parent.mkdir()
            if renamed != text or path.parent == self._folder:
                staged[path].write_bytes(renamed.encode("latin-1"))
        self._staged = staged
        self._shown = {str(staged[path.resolve()]): _shown(path) for path in (*gateware, *others)}
        # Import sources in any order: GHDL finds their dependencies.
        for library, paths in ((LIBRARY, gateware), ("work", others), ("work", self.copies.values())):
            if paths:
                self.run("import", f"--work={library}", *(str(staged[path.resolve()]) for path in paths))

    def make(self, top: str, library: str = "work") -> None:
        """Analyse an entity and the units that it depends on."""
        self.run("make", f"--work={library}", top)

    def verilog(self, top: str, generics: Mapping[str, object], library: str = "work") -> str:
        """Return GHDL's Verilog of an entity, without assertions, because Yosys does not support them."""
        written = self.run("synth", f"--work={library}", "--no-formal", "--out=verilog", *as_options(generics), top)
        return self.renaming.verilog(written)

    def netlist(self, top: str, generics: Mapping[str, object], library: str = "work") -> str:
        """Return an entity's netlist in GHDL's own format, with the same net numbers as the Verilog."""
        return self.run("synth", f"--work={library}", "--no-formal", "--out=raw", *as_options(generics), top)

    def description(self, *paths: Path, library: str = "work") -> str:
        """Return the syntax tree of sources of a library in XML."""
        files = (str(self._staged.get(path.resolve(), path)) for path in paths)
        return self.renaming.plain(self.run("--file-to-xml", f"--work={library}", *files))

    def add(self, name: str, text: str) -> None:
        """Add a source to the library `work`."""
        path = self._folder / name
        path.write_text(self.renaming.vhdl(text))
        self._shown[str(path)] = name
        self.run("import", str(path))

    def simulate(self, top: str) -> str:
        """Simulate an entity without ports until it ends; return the reason if it fails, or an empty string."""
        try:
            self._ghdl.run("-r", STD, f"--workdir={self._folder}", top, "--ieee-asserts=disable", cwd=self._folder)
        except subprocess.CalledProcessError as error:
            said = f"{error.stdout}\n{error.stderr}"
        else:
            return ""
        if stopped := _STOPPED.search(said):
            return f"{self._name(stopped['file'])[0]}:{stopped['place']}: {stopped['words']}"
        if bound := _BOUND.search(said):
            return f"{self._name(bound['file'])[0]}:{bound['line']}: {bound['words']}"
        return self._reason(said)

    def run(self, command: str, *arguments: str) -> str:
        """Run GHDL; return its output, and keep its warnings.

        Raises:
            ConversionError: if GHDL fails; the message is GHDL's first error, with the path that the user wrote.
        """
        options = (STD,) if command == "-f" else (STD, _UNBOUND, f"--workdir={self._folder}")
        try:
            done = self._ghdl.run(command, *options, *arguments, cwd=self._folder)
        except subprocess.CalledProcessError as error:
            raise ConversionError(self._reason(error.stderr)) from error
        found = self._messages(done.stderr)
        if any(message.kind == "error" for message in found):
            raise ConversionError(self._reason(done.stderr))
        self.messages += [message for message in found if message.kind == "warning"]
        return done.stdout

    def _reason(self, said: str) -> str:
        """Return the most useful message from GHDL's output after a failure."""
        found = self._messages(said)
        # GHDL prints a failed assertion with its text, and then as an error without the text.
        failed = [message for message in found if message.kind == "(assert failure)"]
        errors = failed or [message for message in found if message.kind == "error"]
        if errors:
            more = f" (and {len(errors) - 1} more)" if errors[1:] else ""
            return f"{errors[0]}{more}"
        if crash := _CRASH.search(said):
            return f"{self.version} ended with an internal error, {crash[1]}"
        lines = [line.rpartition("error: ")[2].strip(" *") for line in said.splitlines()]
        return f"GHDL failed: {([line for line in lines if line] or ['no reason given'])[-1]}"

    def line(self, file: str, line: int) -> tuple[str, str]:
        """Return the name for messages of a file that GHDL names, and the text of one of its lines."""
        path = self._folder / file
        lines = path.read_bytes().decode("latin-1").splitlines() if path.is_file() else []
        return self._name(file)[0], lines[line - 1] if line <= len(lines) else ""

    def _name(self, file: str) -> tuple[str, bool]:
        name = re.split(r"[/\\]", file)[-1]
        if name in self._own:
            return str(self._own[name].path), True
        return self._shown.get(file, file), False

    def _messages(self, said: str) -> list[GhdlMessage]:
        found = []
        for line in said.splitlines():
            if match := _MESSAGE.match(line):
                shown, is_own = self._name(match["file"])
                words = self.renaming.plain(match["words"])
                found.append(GhdlMessage(shown, match["place"], match["kind"], words, is_own))
        return found


def as_options(generics: Mapping[str, object]) -> list[str]:
    """Return GHDL's options for values of generics."""
    return [f"-g{name}={_as_vhdl(value)}" for name, value in sorted(generics.items())]


def _as_vhdl(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _shown(path: Path) -> str:
    try:
        return f"gateware/{path.resolve().relative_to(GATEWARE.resolve()).as_posix()}"
    except ValueError:
        return path.name
