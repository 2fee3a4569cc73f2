"""Every entity with a reset has defined outputs after it; new entities are found in the sources automatically."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING

import pytest

from gateware.bench.runner import run_bench
from unity_link.gateware.cache import vhdl_sources

if TYPE_CHECKING:
    from pathlib import Path

# Outputs of block RAMs before the first write. Their values are not used, because `valid` is '0'.
MEMORY_OUTPUTS = {
    "ul_fifo_async": ["out_data"],
    "ul_answer_ring": ["out_data"],
    "ul_byte_ring": ["out_data"],
    "ul_ethernet": ["rx_data"],
    "ul_ft245_sync": ["rx_data"],
    "ul_mac": ["rx_data", "rx_end"],
    "ul_record_ring": ["out_data"],
    "ul_schedule": ["stage_data"],
    "ul_subscription_manager": ["access_address"],
    "ul_word_ring": ["read_data"],
}
CONFIGURATIONS = [
    *(("unity_link", {"physical": medium}) for medium in ("fifo", "uart", "ft245", "ft245_sync")),
    *(("unity_link", {"physical": medium, "block_words": 160}) for medium in ("rmii", "mii", "rgmii", "w5500")),
    ("unity_link", {"groups": 0}),
    ("unity_link_core", {"checked_frames": False}),
]


def ports_of(source: Path) -> tuple[list[str], list[str]]:
    """Return the names of the inputs and outputs of the entity in a file."""
    head = re.search(r"^entity .*?^end entity", source.read_text(), re.DOTALL | re.MULTILINE)
    found = re.findall(r"^\s*(\w+)\s*:\s*(in|out)\s", head[0] if head else "", re.MULTILINE)
    return [name for name, way in found if way == "in"], [name for name, way in found if way == "out"]


PORTS = {source.stem: ports_of(source) for source in vhdl_sources()}
WITH_RESET = [name for name, (inputs, _) in PORTS.items() if {"rst", "in_rst"} & {*inputs}]


@pytest.mark.parametrize(("entity", "generics"), [*((name, {}) for name in WITH_RESET), *CONFIGURATIONS])
def test_no_output_is_undefined_after_a_reset(entity: str, generics: dict[str, object]) -> None:
    inputs, outputs = PORTS[entity]
    run_bench(
        entity,
        "gateware.bench.reset.bench_reset",
        generics=generics,
        extra_env={"PORTS": json.dumps([inputs, outputs, MEMORY_OUTPUTS.get(entity, [])])},
    )
