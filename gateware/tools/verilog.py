"""The gateway as Verilog: `make verilog` writes it to `build/verilog`, one file for each configuration.

python -m gateware.tools.verilog [FOLDER]
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import NamedTuple

from gateware.tools import parser_of
from gateware.tools.synth import MINIMAL
from unity_link.errors import UnityLinkError
from unity_link.gateware.cache import GATEWARE
from unity_link.gateware.release import release

_FOLDER = GATEWARE.parent / "build" / "verilog"


class Release(NamedTuple):
    """A configuration of the gateway."""

    about: str
    top: str
    generics: dict[str, object]

    def text(self, name: str) -> str:
        """Return the text of the Verilog file.

        Raises:
            ConversionError: if GHDL rejects the sources.
            ToolMissingError: if there is no usable GHDL.
        """
        chosen = [f"  {generic} => {value}" for generic, value in self.generics.items()]
        about = [self.about, "", f"Of the entity {self.top}, with", *(chosen or ["  all generics at their defaults"])]
        return release(name, about, self.top, self.generics)


RELEASES = {
    "unity_link_uart": Release("The gateway on a UART of 1 Mbaud, at 50 MHz.", "unity_link", {"physical": "uart"}),
    "unity_link_uart_3m": Release(
        "The gateway on a UART of 3 Mbaud with RTS# and CTS#, at 48 MHz.",
        "unity_link",
        {"physical": "uart", "baud": 3_000_000, "flow_control": True, "clock_hz": 48_000_000},
    ),
    "unity_link_minimal_uart": Release(
        "The smallest gateway that a host can use, on a UART of 1 Mbaud, at 50 MHz.",
        "unity_link",
        {"physical": "uart", **MINIMAL},
    ),
    "unity_link_ft245": Release(
        "The gateway on an FT245 (asynchronous), at 50 MHz.", "unity_link", {"physical": "ft245"}
    ),
    "unity_link_ft245_sync": Release(
        "The gateway on an FT245 (synchronous), at 50 MHz.", "unity_link", {"physical": "ft245_sync"}
    ),
    "unity_link_rmii": Release(
        "The gateway with an Ethernet port, by RMII, at 50 MHz.", "unity_link", {"physical": "rmii", "block_words": 160}
    ),
    "unity_link_fifo": Release("The gateway on a stream of bytes, for any other medium.", "unity_link_fifo", {}),
}


def main() -> int:
    """Write all files, and return the exit status."""
    parser = parser_of(__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=_FOLDER, help="default: build/verilog")
    folder = parser.parse_args().folder
    try:
        texts = {name: chosen.text(name) for name, chosen in RELEASES.items()}
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in texts.items():
            (folder / f"{name}.v").write_text(text)
            sys.stdout.write(f"{folder / name}.v: {len(text) // 1000} kB\n")
    except (UnityLinkError, OSError) as error:
        sys.stderr.write(f"{error}\n")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
