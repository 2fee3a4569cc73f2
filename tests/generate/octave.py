"""GNU Octave as the tests use it: scripts that run beside generated code, and what they print.

Octave takes a second to start, so a script asks for many things at once and prints what it got, ``LABEL<TAB>TEXT`` a
line; the tests look at the lines. Numbers are printed so that no bit is lost: `doubles` and `words` say how.
"""

from __future__ import annotations

import functools
import os
import shutil
import struct
import subprocess
from typing import TYPE_CHECKING

from unity_link.generate import generate, write

if TYPE_CHECKING:
    from collections.abc import Mapping
    from pathlib import Path

    from unity_link.spec import Spec

MEX_FILE = "unity_link_mex.mex"
CAREFULLY = {"CFLAGS": "-O1 -Wall -Wextra -Werror"}
"""Compiler options of the MEX file for the tests."""
LONGEST_RUN = 300
"""Seconds after which a script is ended that hangs."""
_PRELUDE = """\
1;
function show(label, value)
  if iscell(value)
    text = strjoin(cellfun(@describe, value, 'UniformOutput', false), ' ');
  else
    text = describe(value);
  end
  printf('%s\\t%s\\n', label, text);
  fflush(stdout);
end
function text = describe(value)
  if ischar(value)
    text = value;
  elseif isa(value, 'double')
    text = strjoin(cellstr(num2hex(value(:))).', ' ');
  elseif isa(value, 'uint64') || isa(value, 'int64')
    text = strtrim(sprintf('%08x%08x ', flipud(reshape(typecast(value(:).', 'uint32'), 2, []))));
  else
    text = strtrim(sprintf('%d ', value));
  end
  if ~ischar(value)
    text = strtrim([class(value), ' ', text]);
  end
end
function attempt(label, action)
  try
    action();
    show(label, 'no error');
  catch reason
    show(label, [reason.identifier, ' ', reason.message]);
  end
end
"""


@functools.cache
def why_not() -> str:
    """Return the reason why these tests cannot run; empty where they can."""
    octave = shutil.which("octave-cli")
    if octave is None:
        return "octave-cli is not installed (Debian: apt install octave)"
    if shutil.which("mkoctfile") is None:
        return "mkoctfile is not installed (Debian: apt install liboctave-dev)"
    return ""


class Octave:
    """Octave in a folder with generated code, which is built already where a MEX file is given."""

    def __init__(self, folder: Path, mex_file: Path | None = None) -> None:
        self.folder = folder
        self._mex_file = mex_file

    def generate(self, spec: Spec) -> None:
        """Add the class of a spec."""
        write(generate("matlab", spec), self.folder)
        if self._mex_file is not None:
            shutil.copy2(self._mex_file, self.folder)

    def start(self, script: str, environment: Mapping[str, str] | None = None) -> subprocess.Popen[str]:
        """Run a script, with some more variables in its environment."""
        (self.folder / "script.m").write_text(f"{_PRELUDE}{script}\nexit(0);\n", encoding="utf-8")
        return subprocess.Popen(
            ["octave-cli", "--no-init-file", "--quiet", "script.m"],
            cwd=self.folder,
            env={**os.environ, **(environment or {})},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def run(self, script: str, environment: Mapping[str, str] | None = None) -> dict[str, str]:
        """Run a script to its end, and return what it showed, by its labels."""
        with self.start(script, environment) as process:
            try:
                output, errors = process.communicate(timeout=LONGEST_RUN)
            finally:
                process.kill()
        assert process.returncode == 0, f"{output}\n{errors}"
        return dict(line.split("\t", 1) for line in output.splitlines())


def doubles(*values: float) -> str:
    """Return what `show` prints for doubles."""
    return " ".join(["double", *(struct.pack(">d", value).hex() for value in values)])


def words(*values: float, kind: str = "uint64") -> str:
    """Return what `show` prints for whole numbers of 64 bits."""
    return " ".join([kind, *(f"{int(value) & (1 << 64) - 1:016x}" for value in values)])


def numbers(text: str) -> list[float]:
    """Read what `show` printed for doubles."""
    kind, *values = text.split()
    assert kind == "double"
    return [struct.unpack(">d", bytes.fromhex(value))[0] for value in values]
