"""A program's spec is compared with the board's; an incompatible one is refused before the first write."""

from __future__ import annotations

import pickle
import random
from typing import TYPE_CHECKING, Any

import pytest

import unity_link
from support.changed_specs import BALANCER, COMPATIBLE, INCOMPATIBLE, ROVER, WALKER, changed
from support.simulated_time import on_simulated_time
from unity_link import SpecMismatchError, UnsupportedError
from unity_link.data import load
from unity_link.data.blocking import put
from unity_link.data.describing import MOST_DIFFERENCES
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.description import page_address
from unity_link.spec import compile_file, compile_text
from unity_link.virtual import VirtualGateway
from unity_link.virtual.build import simulate, simulated
from unity_link.virtual.bus import ModelBus

if TYPE_CHECKING:
    from pathlib import Path

    from unity_link.data.robot import Robot
    from unity_link.spec import Spec

SPECS = (ROVER, BALANCER, WALKER)
SPEC = """public robot() {
  @speed = 0x10: signed 16 READWRITE(SCALE=0.5, UNIT="m/s");
  @lamp = 0x11[0]: bool READWRITE();
}
"""
CHANGES = {"SCALE=0.5": "SCALE=0.25", '"m/s"': '"km/h"', "0x11[0]": "0x12[1]"}


@pytest.fixture
def written(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Return the list of addresses that any gateway writes on its bus from now on."""
    addresses: list[int] = []
    write = ModelBus.write

    def note(bus: ModelBus, address: int, value: int, now: float) -> None:
        addresses.append(address)
        write(bus, address, value, now)

    monkeypatch.setattr(ModelBus, "write", note)
    return addresses


def board(folder: Path, text: str) -> str:
    path = folder / "board.ul"
    path.write_text(text)
    return f"sim:{path}"


async def first_write(robot: Robot) -> None:
    """Write a signal without a lease, or arm a lease."""
    proxies: list[Any] = [one for one in robot.signals if one.signal.access.writes and one.signal.safe is None]
    await proxies[0].set(1)


@pytest.mark.parametrize("number", range(20))
def test_each_incompatible_spec_is_refused_before_the_first_write(
    number: int, tmp_path: Path, written: list[int]
) -> None:
    path, chance = SPECS[number % len(SPECS)], random.Random(number)
    mine = load(path)
    _, change = changed(path, chance, INCOMPATIBLE)
    page = page_address(change.interface.address_bits)

    @on_simulated_time
    async def program() -> None:
        async with unity_link.connect(board(tmp_path, change.text)) as link:
            with pytest.raises(SpecMismatchError) if change.what != "data bits" else pytest.raises(UnsupportedError):
                await first_write(mine(link))
            assert not written
            with pytest.raises(SpecMismatchError) as refused:
                await first_write(await unity_link.robot(link, mine))
            assert {*written} <= {page}
            shown = refused.value.differences[:MOST_DIFFERENCES]
            assert any(change.thing in one and change.what in one for one in shown)
            assert all(one in str(refused.value) for one in shown)

    program()


@pytest.mark.parametrize("number", range(12))
def test_each_compatible_spec_is_accepted_and_written(number: int, tmp_path: Path, written: list[int]) -> None:
    path, chance = SPECS[number % len(SPECS)], random.Random(number)
    mine = load(path)
    _, change = changed(path, chance, COMPATIBLE)

    @on_simulated_time
    async def program() -> None:
        async with unity_link.connect(board(tmp_path, change.text)) as link:
            robot = await unity_link.robot(link, mine)
            assert type(robot) is mine
            await first_write(robot)
            assert {*written} - {page_address(change.interface.address_bits)}
            # The link was compared once; the class alone is enough from now on.
            await first_write(mine(link))

    program()


@on_simulated_time
async def open_robot(url: str, spec: str | Path | Spec | type[Robot]) -> Robot:
    async with unity_link.connect(url) as link:
        return await unity_link.robot(link, spec)


def test_the_error_lists_at_most_five_differences_with_both_values(tmp_path: Path) -> None:
    (tmp_path / "robot.ul").write_text(SPEC)
    other = SPEC
    for old, new in CHANGES.items():
        other = other.replace(old, new)
    with pytest.raises(SpecMismatchError) as refused:
        open_robot(board(tmp_path, other), tmp_path / "robot.ul")
    differences = (
        "speed: SCALE is 0.5 in robot.ul and 0.25 on the board",
        "speed: UNIT is 'm/s' in robot.ul and 'km/h' on the board",
        "lamp: address is 0x11 in robot.ul and 0x12 on the board",
        "lamp: lowest bit is 0 in robot.ul and 1 on the board",
    )
    assert refused.value.differences == differences
    assert str(refused.value).startswith(
        f"the gateway was built from another spec than robot.ul ({'; '.join(differences)})"
    )
    again = pickle.loads(pickle.dumps(refused.value))
    assert (str(again), again.differences) == (str(refused.value), differences)
    many = "".join(f"@s{number} = {number}: READ(); " for number in range(12))
    with pytest.raises(SpecMismatchError, match=r"s0 is not on the board; .*s4 is not on the board; and 7 more\)"):
        open_robot(board(tmp_path, SPEC), compile_text(f"public robot() {{ {many} }}"))


def test_a_spec_may_be_a_path_a_compiled_spec_or_a_class(tmp_path: Path) -> None:
    path = tmp_path / "robot.ul"
    path.write_text(SPEC)
    url = board(tmp_path, SPEC.replace("}\n", "  @more = 0x20: READ();\n}\n"))
    for spec in (path, str(path), compile_file(path), load(path)):
        robot = open_robot(url, spec)
        assert [*robot.interface.signals] == ["speed", "lamp"]


def test_map_any_skips_the_comparison(tmp_path: Path) -> None:
    url = board(tmp_path, SPEC.replace("0.5", "0.25"))
    assert open_robot(f"{url}?map=any", compile_text(SPEC)).interface.signals["speed"].kind.scale == 0.5


@on_simulated_time
async def test_a_described_gateway_with_its_own_build_identifier_is_compared() -> None:
    features = simulate(ROVER).info.features & ~Feature.FINGERPRINT
    async with unity_link.connect(f"sim:{ROVER}?features={int(features)}&build_id=20260101") as link:
        assert (await unity_link.robot(link, ROVER)).interface.name == "rover"
        with pytest.raises(SpecMismatchError, match=r"left\.duty: SCALE is 0\.0005 in the spec and 0\.000488"):
            await unity_link.robot(link, compile_text(ROVER.read_text().replace("1 / 2047", "1 / 2000")))


@on_simulated_time
async def test_a_gateway_without_a_description_is_compared_by_its_fingerprint() -> None:
    ours = compile_text(SPEC)
    info = GatewayInfo(features=GatewayInfo().features | Feature.FINGERPRINT, build_id=ours.interface().fingerprint)
    async with unity_link.connect(VirtualGateway(info)) as link:
        assert (await unity_link.robot(link, ours)).link is link
        with pytest.raises(SpecMismatchError, match=r"the map .* describes the map .*: load the spec") as refused:
            await unity_link.robot(link, compile_text(SPEC.replace("0.5", "0.25")))
        assert refused.value.differences == ()
    async with unity_link.connect(VirtualGateway()) as link:
        assert (await unity_link.robot(link, ours)).link is link


@on_simulated_time
async def test_the_error_of_a_mismatched_class_names_the_comparing_call() -> None:
    other = load(compile_text(ROVER.read_text().replace("1 / 2047", "1 / 2000")))
    async with unity_link.connect(f"sim:{ROVER}") as link:
        with pytest.raises(SpecMismatchError, match=r"`await unity_link\.robot\(link, spec\)` reports the differences"):
            other(link)
    not_open: Any = unity_link.connect("sim:")
    with pytest.raises(unity_link.ArgumentError, match="needs an open link"):
        await unity_link.robot(not_open, other)


def test_a_blocking_link_compares_specs_too(tmp_path: Path, written: list[int]) -> None:
    url = board(tmp_path, SPEC.replace("}\n", "  @more = 0x20: READ();\n}\n"))
    with unity_link.blocking.connect(url) as link:
        with pytest.raises(SpecMismatchError, match=r"speed: SCALE is 0\.25 in the spec and 0\.5 on the board"):
            put(load(compile_text(SPEC.replace("0.5", "0.25"))), link)
        assert {*written} <= {page_address(8)}
        robot = put(load(compile_text(SPEC)), link)
        robot.speed.set(2)
        assert robot.speed.get() == 2


def test_a_spec_with_other_places_on_the_stage_of_a_schedule_is_refused(tmp_path: Path) -> None:
    lines = "public robot() { plan: SCHEDULE() @(0x40); @a = 0x10: READWRITE(TIMED(plan)); NEW }"
    mine = compile_text(lines.replace("NEW", ""))
    before, behind = (lines.replace("NEW", f"@b = {at}: READWRITE(TIMED(plan));") for at in (0x0F, 0x11))
    assert open_robot(board(tmp_path, behind), mine).interface.name == "robot"
    with pytest.raises(SpecMismatchError, match="a: TIMED is plan, place 0 in the spec and plan, place 1 on the board"):
        open_robot(board(tmp_path, before), mine)


NUMBERED = """
group state(RATE=100);
group hits({number}TRIGGER);
public r() {{ GATEWAY(ADDRESS_BITS=12); {first} @b = 0x11: READ(PUBLISH(hits)); }}
"""


@pytest.mark.asyncio
async def test_a_spec_that_numbers_a_group_unlike_the_board_is_refused() -> None:
    first = "@a = 0x10: READ(PUBLISH(state));"
    for number in ("", "NUMBER=1, "):
        behind = compile_text(NUMBERED.format(number=number, first=first))
        less = compile_text(NUMBERED.format(number=number, first=""))
        async with unity_link.connect(simulated(behind.interface())) as link:
            if number:
                await unity_link.robot(link, less)
                continue
            with pytest.raises(
                SpecMismatchError, match=r"hits: TRIGGER is that of number 0 in .* and that of number 1 on"
            ):
                await unity_link.robot(link, less)
