"""Finds a GHDL with a correct `synth`: the system's if its version is 4 or later, otherwise 5.0.1 of Debian 13.

GHDL 2.0 of Debian 12 must not be used: it simulates correctly, but its Verilog lacks the default of every `case`. If
the system has no later GHDL, apt fetches five packages of Debian 13 from the system's mirror. They are unpacked into
the cache and run with their own loader and C library; they are not installed.
"""

from __future__ import annotations

import dataclasses
import os
import re
import shutil
import subprocess
from pathlib import Path

from unity_link.gateware.cache import ToolMissingError, cache_folder
from unity_link.gateware.external import run, temporary_folder

__all__ = ["Ghdl", "ToolMissingError", "converting_ghdl"]

_LEAST_ROOM = 1_000_000
"""Bytes; if a tool fails and the disk has fewer bytes left, the error reports that the disk is full."""
_LEAST_VERSION = 4
_SUITE = "trixie"
_PACKAGES = ("ghdl-mcode", "ghdl-common", "libc6", "libgcc-s1", "zlib1g")
_KEYRING = "/usr/share/keyrings/debian-archive-keyring.gpg"
_DEFAULT_MIRROR = "http://deb.debian.org/debian"
_MULTIARCH = "x86_64-linux-gnu"
_LOADER = "usr/lib64/ld-linux-x86-64.so.2"


@dataclasses.dataclass(frozen=True)
class Ghdl:
    """A command that runs GHDL, and its environment variables."""

    command: tuple[str, ...]
    environment: dict[str, str]

    def run(self, *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
        """Run GHDL in a `temporary_folder`, and return its output.

        Raises:
            subprocess.CalledProcessError: if GHDL fails; the error holds its output.
        """
        done = run([*self.command, *arguments], cwd, cwd=cwd, environment=self.environment)
        done.check_returncode()
        return done

    def version(self) -> str:
        """Return the first line of `ghdl --version`; names of cached files depend on it."""
        command = [*self.command, "--version"]
        environment = {**os.environ, **self.environment}
        done = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
        return done.stdout.splitlines()[0]


def converting_ghdl() -> Ghdl:
    """Return a GHDL of version 4 or later.

    Raises:
        ToolMissingError: if none is installed and none can be fetched.
    """
    if shutil.which("ghdl"):
        system = Ghdl(("ghdl",), {})
        match = re.match(r"GHDL (\d+)", system.version())
        if match and int(match[1]) >= _LEAST_VERSION:
            return system
    root = cache_folder("tools") / f"ghdl-{_SUITE}"
    if not root.exists():
        _fetch(root)
    return Ghdl(
        (
            str(root / _LOADER),
            "--library-path",
            str(root / "usr/lib" / _MULTIARCH),
            str(root / "usr/bin/ghdl-mcode"),
        ),
        {"GHDL_PREFIX": str(root / "usr/lib/ghdl/mcode/vhdl")},
    )


def _fetch(root: Path) -> None:
    """Fetch and unpack the packages; `root` is created only once it is complete."""
    if not (shutil.which("apt-get") and Path(_KEYRING).exists()):
        raise ToolMissingError(
            f"GHDL {_LEAST_VERSION} or later converts the gateware, and there is none: install one from "
            "https://github.com/ghdl/ghdl (on Debian 12 it is fetched by apt-get, on Debian 13: apt install ghdl)"
        )
    with temporary_folder(root.parent) as work:
        for folder in ("lists/partial", "cache/archives/partial", "root"):
            (work / folder).mkdir(parents=True)
        sources = work / "sources.list"
        sources.write_text(f"deb [signed-by={_KEYRING}] {_mirror()} {_SUITE} main\n")
        apt = [
            "apt-get",
            "-q",
            f"-oDir::Etc::SourceList={sources}",
            "-oDir::Etc::SourceParts=/dev/null",
            f"-oDir::State::Lists={work / 'lists'}",
            f"-oDir::Cache={work / 'cache'}",
            # Ignore installed packages: otherwise apt would look for their versions.
            "-oDir::State::status=/dev/null",
            "-oAPT::Sandbox::User=root",
            # Fail if a list cannot be fetched: otherwise apt only warns, and then reports that packages do not exist.
            "-oAcquire::Retries=3",
            "-oAPT::Update::Error-Mode=any",
        ]
        for command in ([*apt, "update"], [*apt, "download", *_PACKAGES]):
            _call(command, work)
        for package in work.glob("*.deb"):
            _call(["dpkg", "-x", str(package), str(work / "root")], work)
        # Write the files to the disk before the rename: otherwise a power failure could leave `root` with empty files.
        os.sync()
        try:
            (work / "root").rename(root)
        except OSError:
            # Another program may have created it in the meantime.
            if not root.exists():
                raise


def _call(command: list[str], work: Path) -> None:
    """Run a tool that fetches or unpacks.

    Raises:
        ToolMissingError: if it fails.
    """
    done = run(command, work, cwd=work, environment={"LC_ALL": "C"})
    if done.returncode:
        lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        # If the disk is full, the last line of apt-get is misleading: it may report a missing signature.
        reason = next((line for line in lines if "No space left" in line), (lines or ["no reason given"])[-1])
        free = shutil.disk_usage(work).free
        if free < _LEAST_ROOM:
            reason = f"{work.parent} has {free:,} bytes left ({reason})"
        raise ToolMissingError(
            f"GHDL {_LEAST_VERSION} or later converts the gateware; fetching Debian {_SUITE}'s failed: {reason}"
        )


def _mirror() -> str:
    """Return the Debian mirror that apt uses on this machine."""
    listing = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(LABEL) $(REPO_URI)", "Created-By: Packages"],
        check=False,
        capture_output=True,
        text=True,
    ).stdout
    mirrors = [line.split()[1] for line in listing.splitlines() if line.startswith("Debian ")]
    return mirrors[0] if mirrors else _DEFAULT_MIRROR
