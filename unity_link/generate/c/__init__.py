"""Target ``c``: a client in C99 without dynamic allocation.

A header and a source are generated from the spec: constants that describe its signals, in structures that mirror its
components. The runtime is the same for every spec and has a header and a source of its own, so that two robots in one
program share it. A third source has the transports for POSIX; a microcontroller can leave it out.

The runtime is written in several C files in ``runtime/``, which ``unity_link.c.jinja`` joins.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from unity_link.generate import GeneratedFile
from unity_link.generate.c.layout import Layout
from unity_link.generate.c.names import number
from unity_link.generate.c.signals import decoding, describe, examples, initializer, schedule
from unity_link.protocol.host import trial
from unity_link.protocol.window.constants import TABLE
from unity_link.protocol.wire import compact, path
from unity_link.protocol.wire.configuration import Feature
from unity_link.protocol.wire.frames import LARGEST_DATAGRAM
from unity_link.protocol.wire.numbers import MOST_SECONDS
from unity_link.transport.polling import REMEMBERED_WAITS, SPIN
from unity_link.transport.udp import RECEIVE_BUFFER

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from unity_link.generate import Templates
    from unity_link.spec import Interface

DOC = "a client in C99, without allocation, with transports for POSIX"
FILTERS: dict[str, Callable[..., Any]] = {
    "decoding": decoding,
    "describe": describe,
    "number": number,
    "pad": str.ljust,
    "schedule": schedule,
}
RUNTIME = ("unity_link.h", "unity_link.c", "unity_link_posix.c")
RUNTIME_VALUES = {
    "constants": TABLE,
    "FEATURES": {name: int(bit) for name, bit in Feature.__members__.items()},
    "SPIN": SPIN,
    "REMEMBERED_WAITS": REMEMBERED_WAITS,
    "LARGEST_DATAGRAM": LARGEST_DATAGRAM,
    "MOST_SECONDS": MOST_SECONDS,
    "RECEIVE_BUFFER": RECEIVE_BUFFER,
    "COMPACT": {
        "START": compact.START[0],
        "END": compact.END[0],
        "ESCAPE": compact.ESCAPE[0],
        "STUFFED": compact.STUFFED,
        "COMMANDS": compact.COMMANDS,
    },
    "PATH": path,
    "TRIAL": {"IDS": trial.IDS, "ID_ALONE": trial.ID_ALONE, "FIRST_IDS": trial.FIRST_IDS},
}
"""Constants that the runtime shares with the host in Python."""


def files(interface: Interface, templates: Templates) -> Iterator[GeneratedFile]:
    """Yield the header and the source of an interface, and the runtime."""
    layout = Layout(interface)
    values = {"layout": layout, "prefix": layout.prefix}
    body = initializer(layout)
    yield GeneratedFile(f"{layout.prefix}.h", templates.render("interface.h", examples=examples(layout), **values))
    yield GeneratedFile(f"{layout.prefix}.c", templates.render("interface.c", initializer=body, **values))
    for name in RUNTIME:
        yield GeneratedFile(name, templates.render(name, **RUNTIME_VALUES))
