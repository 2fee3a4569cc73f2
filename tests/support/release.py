"""Build the wheel and the source archive, and test the wheel in an empty environment: ``make release``.

The commands and programs of the README run there, outside of the repository, and so does a copy of the gateware.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[2]
_PYTHON = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_BEFORE, _BEHIND = "import asyncio\nimport unity_link\n", "\nasyncio.run(main())\n"
"""Lines before and after a block of the README that relies on the block before it."""


def run(*command: str | Path, cwd: Path = ROOT) -> str:
    """Run a command, return its output; if it fails, end with its command line and output."""
    done = subprocess.run([str(word) for word in command], cwd=cwd, check=False, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


def build() -> tuple[Path, Path]:
    """Build the wheel and the source archive in `dist`; return their paths."""
    shutil.rmtree(ROOT / "dist", ignore_errors=True)
    run(sys.executable, "-m", "hatchling", "build")
    (wheel,), (archive,) = (ROOT / "dist").glob("*.whl"), (ROOT / "dist").glob("*.tar.gz")
    return wheel, archive


def try_wheel(wheel: Path, folder: Path) -> None:
    """Install a wheel into an empty environment with the locked versions, and run the commands of the README."""
    run(sys.executable, "-m", "venv", folder / "env")
    programs = folder / "env" / "bin"
    install = (programs / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check")
    run(*install, "--no-deps", "--require-hashes", "-r", ROOT / "requirements" / "core.lock")
    run(*install, "--no-deps", wheel)
    elsewhere = folder / "elsewhere"
    elsewhere.mkdir()
    for name in ("scara", "gantry"):
        run(programs / "unity-link", "example", name, cwd=elsewhere)
    for place, block in enumerate(_PYTHON.findall((ROOT / "README.md").read_text())):
        program = elsewhere / f"block{place}.py"
        program.write_text(_BEFORE + block + ("" if "asyncio.run(" in block else _BEHIND))
        run(programs / "python", program, cwd=elsewhere)
    run(programs / "unity-link", "read", "sim:scara", "0x88", cwd=elsewhere)
    run(programs / "unity-link", "read", "rtl:scara", "0x88", cwd=elsewhere)
    run(programs / "unity-link", "gateware", "copy", "gateware", cwd=elsewhere)
    run(
        programs / "unity-link", "generate", "vhdl", "examples/scara.ul", "-o", "vhdl", "--with-gateware", cwd=elsewhere
    )


def main() -> int:
    """Build and test; return the exit status."""
    wheel, archive = build()
    files = len(zipfile.ZipFile(wheel).namelist())
    sys.stdout.write(f"{wheel.relative_to(ROOT)} ({files} files, {wheel.stat().st_size // 1024} kB)\n")
    sys.stdout.write(f"{archive.relative_to(ROOT)} ({archive.stat().st_size // 1024} kB)\n")
    with tempfile.TemporaryDirectory() as folder:
        try_wheel(wheel, Path(folder))
    sys.stdout.write("the wheel works in an empty environment: the README's programs, sim:, rtl:, the gateware\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
