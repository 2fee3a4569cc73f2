"""The cores of the gateware as tools see them: a folder of `gateware/cores` each, and what its `core.toml` says.

That file says how the core is proved, and what it may take of an FPGA; all other is found by its name. In core `NAME`:

    [[proofs]]                          any number; the properties of the entity `ul_NAME` stand in `ul_NAME.sv`
    entity = "ul_NAME_part"             another entity, whose properties are in the file of that name
    generics = { axes = 1 }
    defines = ["COUNTER"]               of the preprocessor of the properties; they tell proofs apart
    cover_steps = 20                    within which every `cover` is reached from reset
    induction_steps = 2
    bits = true                         z3 is faster so where there is much arithmetic
    faults."the filter is open" = ["signal", "1'b1"]
                                        with which the proof must fail: a signal of the converted Verilog, as a regular
                                        expression, and what drives it instead

    [sizes.6]                           any number; the configuration is called `NAME_6`
    generics = { axes = 6 }
    ecp5 = { logic = 900, memory = 0, fmax_mhz = 100 }
                                        the most that it may take, and the least speed, on a device of
                                        `gateware/tools/synth.py`; a device that is not named is not tried;
                                        `seed = 2` is one of the placer, where the router does not end with 1
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
    """A configuration of a core that is placed."""

    generics: dict[str, bool | int | str] = {}
    ice40: Limits | None = None
    up5k: Limits | None = None
    ecp5: Limits | None = None

    @property
    def limits(self) -> dict[str, Limits]:
        """Limits by the device."""
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
        """Name of its entity."""
        return f"ul_{self.folder.name}"


def cores() -> Iterator[Core]:
    """Yield each core of the gateware, sorted by name.

    Raises:
        ValueError: for a `core.toml` with something else in it.
    """
    for folder in core_folders():
        file = folder / "core.toml"
        try:
            data = msgspec.toml.decode(file.read_bytes(), type=_Data)
        except msgspec.DecodeError as error:
            raise ValueError(f"{file}: {error}") from error
        sizes = {f"{folder.name}_{name}": size for name, size in data.sizes.items()}
        yield Core(folder, data.proofs, sizes)
