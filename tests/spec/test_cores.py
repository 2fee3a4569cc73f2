"""Cores: the files that a word refers to, their view of the spec, and their part of the model."""

from __future__ import annotations

import importlib.metadata
import sys
from typing import TYPE_CHECKING

import pytest

from unity_link.spec import Pin, Spec, SpecError, Trigger, Way, compile_file, compile_text
from unity_link.spec.cores import ENTRY_POINTS, INSTALLED, core_folders

if TYPE_CHECKING:
    from pathlib import Path

MAP = """\
enum kind { calm, wild }
part(): @(at) { @deep = at: READ(); }
BLINK(WIDTH=8, GROUP=none, NAME="x"): @(BASE) {
  ENTITY("blink", TIME, TICK, width=WIDTH, fast=true, name=NAME, left_out=none);
  @period = BASE: unsigned WIDTH READWRITE(RESET=3);
  @mode = BASE + 1: kind 1 READWRITE();
  @count = BASE + 2: READ(PUBLISH(GROUP));
  @edge: TRIGGER(GROUP);
  @led: PIN(OUT);
  @sense: PIN(IN);
  @both: PIN(INOUT);
}
"""


def write_core(folder: Path, text: str = MAP) -> Path:
    """Write a core, whose Python must not run, beside a spec; return the path for the spec."""
    core = folder / "cores" / "blink"
    core.mkdir(parents=True)
    (core / "blink.ul").write_text(text)
    (core / "b.vhd").write_text("-- second")
    (core / "a.vhd").write_text("-- first")
    (core / "blink.py").write_text("raise SystemExit('run')")
    return folder / "robot.ul"


def compiled(path: Path, text: str) -> Spec:
    path.write_text(text)
    return compile_file(path)


def faults(path: Path, text: str) -> list[str]:
    with pytest.raises(SpecError) as caught:
        compiled(path, text)
    return [f"{one.span.file}: {one.code}: {one.message}" for one in caught.value.diagnostics]


def test_a_word_in_capitals_is_the_core_in_the_folder_beside_the_spec(tmp_path: Path) -> None:
    path = write_core(tmp_path)
    spec = compiled(path, 'group g(TRIGGER); public robot() { a: BLINK(GROUP=g) @(4, led="led0", both=none); }')
    (component,) = spec.interface().cores
    core = component.core
    assert core is not None
    assert (core.word, core.entity, core.library) == ("BLINK", "blink", "work")
    assert core.wants == ("now", "tick")
    assert core.generics == {"width": 8, "fast": True, "name": "x"}
    assert core.pins == (
        Pin(name="led", path="a.led", way=Way.OUT, at="led0"),
        Pin(name="sense", path="a.sense", way=Way.IN),
        Pin(name="both", path="a.both", way=Way.INOUT, is_used=False),
    )
    assert core.triggers == (Trigger(name="edge", group="g"),)
    assert list(spec.interface().signals) == ["a.period", "a.mode", "a.count"]
    assert spec.interface().signals["a.period"].reset == 3
    assert spec.vhdl == tuple(str(tmp_path / "cores" / "blink" / name) for name in ("a.vhd", "b.vhd"))
    assert [source.name for source in spec.sources] == [str(path), str(tmp_path / "cores/blink/blink.ul")]


def test_other_names_in_the_file_of_a_core_are_local_to_it(tmp_path: Path) -> None:
    path = write_core(tmp_path)
    used = compiled(path, "enum other { no } public robot() { a: BLINK() @(4); } part(): @(at) { @x = at: READ(); }")
    assert list(used.interface().signals) == ["a.period", "a.mode", "a.count"]
    (fault,) = faults(path, "public robot() { a: BLINK() @(4); @m = 1: kind 2 READ(); }")
    assert fault == f"{path}: unknown-kind: there is no kind 'kind'"
    (fault,) = faults(path, "public robot() { a: BLINK() @(4); b: part() @(9); }")
    assert "unknown-component" in fault


def test_a_core_uses_the_groups_of_the_spec(tmp_path: Path) -> None:
    path = write_core(tmp_path, MAP + "group own(RATE=10);")
    (fault,) = faults(path, "public robot() { a: BLINK() @(4); }")
    assert fault.endswith("the core BLINK declares a group, and groups are those of the spec that names a core")


def test_a_users_core_overrides_an_installed_one_and_a_component_both(tmp_path: Path) -> None:
    (tmp_path / "cores" / "pwm").mkdir(parents=True)
    (tmp_path / "cores" / "pwm" / "pwm.ul").write_text('PWM(): @(BASE) { ENTITY("mine"); @duty = BASE: WRITE(); }')
    path = tmp_path / "robot.ul"
    text = "public robot() { a: PWM() @(4); }"
    assert list(compiled(path, text).interface().signals) == ["a.duty"]
    theirs = compiled(path, text + "PWM(): @(at) { @level = at: WRITE(); }")
    assert list(theirs.interface().signals) == ["a.level"]
    assert theirs.interface().cores == ()


def test_an_address_may_be_among_the_arguments_of_a_core() -> None:
    given = compile_text("public robot() { a: PWM(BASE=7, WIDTH=9); }")
    assert given.interface().signals == compile_text("public robot() { a: PWM(WIDTH=9) @(7); }").interface().signals


def test_a_fault_in_a_core_is_reported_in_its_own_file(tmp_path: Path) -> None:
    path = write_core(tmp_path, MAP.replace("READWRITE(RESET=3)", "READWRITE(RESET=300)"))
    (fault,) = faults(path, "public robot() { a: BLINK() @(4); }")
    assert fault.startswith(f"{tmp_path}/cores/blink/blink.ul: bad-reset: RESET: 300")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("OTHER(): @(BASE) { @a = BASE: READ(); }", "declares no component BLINK"),
        ("public BLINK() { @a = 1: READ(); }", "declares no component BLINK"),
        ("BLINK( {", "syntax"),
        (None, "cannot be read"),
    ],
)
def test_an_invalid_core_is_reported_once_with_its_file(tmp_path: Path, text: str | None, says: str) -> None:
    path = write_core(tmp_path, text or "")
    if text is None:
        (tmp_path / "cores/blink/blink.ul").unlink()
        (tmp_path / "cores/blink/blink.ul").mkdir()
    told = faults(path, "public robot() { a: BLINK() @(4); b: BLINK() @(8); }")
    if text is None:
        assert all("there is no component 'BLINK'" in fault for fault in told)
    else:
        assert len(told) == 1
        assert says in told[0]


def test_cores_of_a_package_are_found_without_importing_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    package = tmp_path / "more_cores"
    (package / "blink").mkdir(parents=True)
    (package / "__init__.py").write_text("raise SystemExit('imported')")
    (package / "blink" / "blink.ul").write_text(MAP)
    monkeypatch.syspath_prepend(tmp_path)
    points = [importlib.metadata.EntryPoint("blink", "more_cores", ENTRY_POINTS)]
    monkeypatch.setattr(importlib.metadata, "entry_points", lambda group: points)
    assert len(compile_text("public robot() { a: BLINK() @(4); }").interface().signals) == 3
    assert "more_cores" not in sys.modules
    points *= 2
    with pytest.raises(SpecError, match="there are several cores BLINK"):
        compile_text("public robot() { a: BLINK() @(4); }")


@pytest.mark.parametrize(
    ("placed", "warns"),
    [
        ('a: PWM() @(0, pwm="gp0");', True),
        ('a[2]: PWM() @(i, pwm="gp" + i);', True),
        ("a: PWM() @(0, pwm=none, dir=none);", False),
        ("a: PWM(LEASE=d) @(0);", False),
        ('a: GPIO() @(0, pin="gp0");', False),
        ("a: ENCODER() @(0);", False),
    ],
)
def test_an_output_without_a_lease_causes_one_warning(placed: str, warns: bool) -> None:
    spec = compile_text(f"public robot() {{ d: LEASE() @(0x80); {placed} }}")
    assert [one.code for one in spec.warnings] == ["no-lease"] * warns
    assert all("no lease guards a: it goes on" in one.message for one in spec.warnings)


PLAN = """
SCHEDULE(): @(at) { ENTITY("ul_schedule", TIME, STAGE); @entry = at: unsigned 32 WRITE(); }
timer(SCHEDULE=none): @(at) { @wide = at: unsigned 40 WRITE(TIMED(SCHEDULE)); }
"""


def test_timed_signals_are_staged_in_the_order_of_their_addresses() -> None:
    placed = (
        "plan: SCHEDULE() @(0x80); other: SCHEDULE() @(0x84); last: timer(plan) @(0x20); first: timer(plan) @(0x10);"
    )
    more = "@there = 0x12: unsigned 5 READWRITE(TIMED(other)); @byte = 0x30[15:8]: WRITE(TIMED(plan));"
    interface = compile_text(f"public robot() {{ {placed} {more} never: timer() @(0x40); }}{PLAN}").interface()
    assert interface.stages == {
        "first.wide": range(2), "there": range(1), "last.wide": range(2, 4), "byte": range(4, 5)
    }  # fmt: skip
    assert interface.signals["never.wide"].timed is None
    core = interface.cores[0].core
    assert core is not None
    assert set(core.wants) == {"now", "stage", "armed", "finishing"}


def test_every_installed_core_is_a_component_with_an_entity() -> None:
    *_, installed = core_folders(None)
    assert installed
    for word in installed:
        spec = compile_text(f"public robot() {{ GATEWAY(ADDRESS_BITS=16); one: {word}() @(0x10); }}")
        (component,) = spec.interface().cores
        assert component.core is not None
        assert component.core.library == "unity_link"
        assert spec.vhdl == ()
        assert [source.name for source in spec.sources] == ["<text>", f"cores/{word.lower()}/{word.lower()}.ul"]
        assert (INSTALLED / word.lower() / f"{component.core.entity}.vhd").is_file()


def test_a_register_without_a_lease_begins_with_its_safe_value() -> None:
    text = """
    axis(LEASE=none): @(at) {
      @limit = at: unsigned 8 READWRITE(SCALE=0.5, SAFE(20, LEASE));
      @place = at + 1: unsigned 8 READWRITE(SAFE(HOLD, LEASE));
    }
    public robot() { a: axis() @(4); }
    """
    signals = compile_text(text).interface().signals
    assert (signals["a.limit"].reset, signals["a.limit"].safe) == (40, None)
    assert (signals["a.place"].reset, signals["a.place"].safe) == (0, None)


PLACES = "{0}(): @(BASE) {{ @a = BASE: READWRITE(); p: {1}() @(BASE + 1); }}"
"""Map of a core {0} that places a core {1}."""


def test_cores_that_place_each_other_cause_one_fault(tmp_path: Path) -> None:
    path = write_core(tmp_path, PLACES.format("BLINK", "PONG"))
    pong = tmp_path / "cores" / "pong"
    pong.mkdir()
    (pong / "pong.ul").write_text(PLACES.format("PONG", "BLINK"))
    assert faults(path, "public robot() { p: BLINK() @(1); }") == [
        f"{pong / 'pong.ul'}: recursion: BLINK contains itself: BLINK -> PONG -> BLINK"
    ]


def test_a_core_may_have_the_word_of_a_component_around_it(tmp_path: Path) -> None:
    path = write_core(tmp_path, PLACES.format("BLINK", "GPIO").replace("+ 1)", "+ 1, pin=none)"))
    spec = compiled(path, "GPIO(): @(BASE) { b: BLINK() @(BASE); } public robot() { p: GPIO() @(1); }")
    assert [signal for signal in spec.interface().signals if signal.startswith("p.b.p.")]


def test_cores_nested_too_deeply_cause_one_fault(tmp_path: Path) -> None:
    path = write_core(tmp_path, PLACES.format("BLINK", "LEVEL0"))
    for level in range(30):
        folder = tmp_path / "cores" / f"level{level}"
        folder.mkdir()
        (folder / f"level{level}.ul").write_text(PLACES.format(f"LEVEL{level}", f"LEVEL{level + 1}"))
    (found,) = faults(path, "public robot() { p: BLINK() @(1); }")
    assert "too-deep: components are nested more than 24 levels deep" in found
