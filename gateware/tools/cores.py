"""The cores of the gateware for the tools: the folders of `gateware/cores`, and the contents of each `core.toml`.

That file describes how the core is proved, and its budget in an FPGA; everything else is found by name. In core `NAME`:

    [[proofs]]                          any number; the properties of the entity `ul_NAME` are in `ul_NAME.sv`
    entity = "ul_NAME_part"             another entity; its properties are in the file of that name
    generics = { axes = 1 }
    defines = ["COUNTER"]               for the preprocessor of the properties; they distinguish proofs
    cover_steps = 20                    within which every `cover` is reached from reset
    induction_steps = 2
    bits = true                         makes z3 faster if there is much arithmetic
    faults."the filter is open" = ["signal", "1'b1"]
                                        a fault with which the proof must fail: a signal of the converted Verilog, as a
                                        regular expression, and the expression that drives it instead

    [sizes.6]                           any number; the configuration is called `NAME_6`
    generics = { axes = 6 }
    ecp5 = { logic = 900, memory = 0, fmax_mhz = 100 }
                                        the maximum size and the minimum speed on a device of
                                        `gateware/tools/synth.py`; the configuration is not placed on other devices;
                                        `seed = 2` selects another seed if the router does not finish with 1
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import msgspec

from unity_link.gateware.cache import core_folders

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


class Proof(msgspec.Struct, forbid_unknown_fields=True):
    """A proof of a core."""

    entity: str = ""
    generics: dict[str, bool | int | str] = {}
    defines: tuple[str, ...] = ()
    cover_steps: int = 20
    induction_steps: int = 2
    bits: bool = False
    faults: dict[str, tuple[str, str]] = {}


class Limits(msgspec.Struct, forbid_unknown_fields=True):
    """Limits of a configuration on a device."""

    logic: int
    memory: int
    fmax_mhz: int
    seed: int = 1
    """Seed of the placer."""


class Size(msgspec.Struct, forbid_unknown_fields=True):
    """A configuration of a core to place."""

    generics: dict[str, bool | int | str] = {}
    ice40: Limits | None = None
    up5k: Limits | None = None
    ecp5: Limits | None = None

    @property
    def limits(self) -> dict[str, Limits]:
        """Limits by device."""
        on_each = {"ice40": self.ice40, "up5k": self.up5k, "ecp5": self.ecp5}
        return {device: limits for device, limits in on_each.items() if limits is not None}


class _Data(msgspec.Struct, forbid_unknown_fields=True):
    proofs: tuple[Proof, ...] = ()
    sizes: dict[str, Size] = {}
    per_axis: tuple[str, ...] = ()


class Core(NamedTuple):
    """A core of the gateware."""

    folder: Path
    proofs: tuple[Proof, ...]
    sizes: dict[str, Size]
    """Configurations by their names."""

    @property
    def entity(self) -> str:
        """Name of the core's entity."""
        return f"ul_{self.folder.name}"


def cores() -> Iterator[Core]:
    """Yield each core of the gateware, sorted by name.

    Raises:
        ValueError: if a `core.toml` has an unknown field.
    """
    for folder in core_folders():
        file = folder / "core.toml"
        try:
            data = msgspec.toml.decode(file.read_bytes(), type=_Data)
        except msgspec.DecodeError as error:
            raise ValueError(f"{file}: {error}") from error
        sizes = {f"{folder.name}_{name}": size for name, size in data.sizes.items()}
        yield Core(folder, data.proofs, sizes)
