"""GNU Octave for tests: runs scripts beside generated code, and reads their output.

Octave takes a second to start, so a script makes many calls, and prints the results as lines of ``LABEL<TAB>TEXT``,
which the tests check. Numbers are printed without loss, in the forms that `doubles` and `words` return.
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
"""Compiler options of the MEX file in tests."""
LONGEST_RUN = 300
"""Seconds after which a script that hangs is killed."""
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
    """Return the reason why these tests cannot run, or "" if they can."""
    octave = shutil.which("octave-cli")
    if octave is None:
        return "octave-cli is not installed (Debian: apt install octave)"
    if shutil.which("mkoctfile") is None:
        return "mkoctfile is not installed (Debian: apt install liboctave-dev)"
    return ""


class Octave:
    """Octave in a folder with generated code; the code is built already if a MEX file is given."""

    def __init__(self, folder: Path, mex_file: Path | None = None) -> None:
        self.folder = folder
        self._mex_file = mex_file

    def generate(self, spec: Spec) -> None:
        """Generate the class of a spec into the folder."""
        write(generate("matlab", spec), self.folder)
        if self._mex_file is not None:
            shutil.copy2(self._mex_file, self.folder)

    def start(self, script: str, environment: Mapping[str, str] | None = None) -> subprocess.Popen[str]:
        """Start a script, with further variables in its environment."""
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
        """Run a script to its end; return the texts that it printed, by their labels."""
        with self.start(script, environment) as process:
            try:
                output, errors = process.communicate(timeout=LONGEST_RUN)
            finally:
                process.kill()
        assert process.returncode == 0, f"{output}\n{errors}"
        return dict(line.split("\t", 1) for line in output.splitlines())


def doubles(*values: float) -> str:
    """Return the text that `show` prints for doubles."""
    return " ".join(["double", *(struct.pack(">d", value).hex() for value in values)])


def words(*values: float, kind: str = "uint64") -> str:
    """Return the text that `show` prints for whole numbers of 64 bits."""
    return " ".join([kind, *(f"{int(value) & (1 << 64) - 1:016x}" for value in values)])


def numbers(text: str) -> list[float]:
    """Return the doubles of a text that `show` printed."""
    kind, *values = text.split()
    assert kind == "double"
    return [struct.unpack(">d", bytes.fromhex(value))[0] for value in values]
