"""`check` refuses parameters that a core cannot have, with name, value and range, before GHDL runs."""

from __future__ import annotations

import functools
import re
import subprocess
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from gateware.cores.stepgen.bench_stepgen import Settings
from support.searching import examples
from support.spec_examples import interface_of
from unity_link.boards.build import build
from unity_link.boards.loading import load_board
from unity_link.errors import ArgumentError
from unity_link.spec import SpecError, compile_text

GATEWARE = Path(__file__).parents[2] / "gateware"
CLOCKS = st.sampled_from([10_000_000, 12_000_000, 48_000_000, 50_000_000, 60_000_000, 100_000_000])


def around(*edges: int, low: int = -2) -> st.SearchStrategy[int]:
    """Draw integers near the edges of ranges, and others."""
    near = st.sampled_from(edges).flatmap(lambda edge: st.integers(edge - 2, edge + 2))
    return st.one_of(near, st.integers(low, 1 << 31), st.integers(low, 5000))


class Parameter(NamedTuple):
    """A core parameter and the VHDL generic that it sets, as `factor` times its value."""

    generic: str
    values: st.SearchStrategy[Any]
    factor: int = 1


MOST = (1 << 31) - 1
POWERS = st.integers(2, 16).map(lambda number: 1 << number)
TRUTHS = Parameter("", st.booleans())
TIME = Parameter("", around(0, MOST))
CORES: dict[str, dict[str, Parameter]] = {
    "LEASE": {"TIMEOUT": Parameter("most_us", around(1, 10_737_418, 21_474_836, 89_478_485), 1_000_000)},
    "SCHEDULE": {
        "DEPTH": Parameter("depth", st.one_of(around(8, 1024, 16384), st.integers(2, 16).map(lambda n: 1 << n)))
    },
    "GPIO": {"DEBOUNCE": Parameter("debounce_us", around(0, 10_737_418, 21_474_836, 89_478_485))},
    "ENCODER": {"FILTER": Parameter("filter", around(1, MOST)), "COUNTER": TRUTHS._replace(generic="counter")},
    "PWM": {
        "WIDTH": Parameter("width", around(2, 24, 64)),
        "FREQUENCY": Parameter("frequency_hz", st.one_of(around(1, 2_500_000, 12_500_000), st.just(20_000))),
        "CENTRE": TRUTHS._replace(generic="centre"),
        "MODE": Parameter("mode", st.sampled_from(["sign", "up_down", "offset", "Sign", ""])),
        "DEAD_TIME": Parameter("dead_time_ns", around(0, 24_980, 24_917)),
    },
    "STEPGEN": {
        "STEPLEN": TIME._replace(generic="steplen_ns"),
        "STEPSPACE": TIME._replace(generic="stepspace_ns"),
        "DIRSETUP": TIME._replace(generic="dirsetup_ns"),
        "DIRHOLD": TIME._replace(generic="dirhold_ns"),
        "REVERSE": TRUTHS._replace(generic="reverse"),
    },
}
"""The parameters that the entities limit."""


def written(value: object) -> str:
    """Return a value as it is written in a spec."""
    return f'"{value}"' if isinstance(value, str) else str(value).lower()


@functools.cache
def made(folder: Path, entity: str) -> Path:
    """Analyse the gateware into a folder."""
    if not any(folder.iterdir()):
        files = [
            *GATEWARE.glob("rtl/base/*.vhd"),
            *GATEWARE.glob("cores/*/ul_*.vhd"),
            *GATEWARE.glob("rtl/**/*_pkg.vhd"),
        ]
        ghdl(folder, "-i", *map(str, dict.fromkeys(files)), check=True)
    ghdl(folder, "-m", entity, check=True)
    return folder


def ghdl(folder: Path, command: str, *arguments: str, check: bool = False) -> bool:
    """Run GHDL; return true if it succeeded."""
    words = ["ghdl", command, "--std=08", "--work=unity_link", "--workdir=.", *arguments]
    return subprocess.run(words, cwd=folder, check=check, capture_output=True).returncode == 0


@pytest.mark.slow
@pytest.mark.rtl
@pytest.mark.parametrize("word", CORES)
def test_check_accepts_the_parameters_that_the_entity_accepts(
    word: str, tmp_path_factory: pytest.TempPathFactory
) -> None:
    folder = tmp_path_factory.mktemp("ghdl")
    entity, known = f"ul_{word.lower()}", CORES[word]

    @settings(max_examples=examples(12), deadline=None, suppress_health_check=list(HealthCheck))
    @given(
        clock_hz=CLOCKS, chosen=st.fixed_dictionaries({}, optional={name: one.values for name, one in known.items()})
    )
    def holds(clock_hz: int, chosen: dict[str, Any]) -> None:
        given = {
            name: value / known[name].factor if known[name].factor > 1 else value for name, value in chosen.items()
        }
        if word == "STEPGEN":
            # The entity has no such generic.
            given["MAXVEL"] = 0
        arguments = ", ".join(f"{name}={written(value)}" for name, value in given.items())
        try:
            interface_of(f"GATEWAY(CLOCK={clock_hz}); x: {word}({arguments}) @(0);")
            is_accepted = True
        except SpecError as error:
            is_accepted = False
            first = next(one for one in error.diagnostics if one.severity == "error").message
            assert re.match(rf"x: ({'|'.join(chosen)}) is .+, expected ", first), first
        generics = [f"-g{known[name].generic}={written(value)}".replace('"', "") for name, value in chosen.items()]
        runs = ghdl(made(folder, entity), "-r", entity, f"-gclock_hz={clock_hz}", *generics, "--stop-time=0ns")
        assert runs == is_accepted, (generics, clock_hz)

    holds()


@pytest.mark.parametrize(
    ("placement", "message"),
    [
        (
            "x: LEASE(TIMEOUT=60) @(0);",
            "x: TIMEOUT is 60, expected 1e-06 to 21.47483648 at a clock of 50,000,000 Hz",
        ),
        ("GATEWAY(CLOCK=12000000); x: LEASE(TIMEOUT=60) @(0);", ""),
        ("x: LEASE(TIMEOUT=1.001) @(0);", ""),
        ("x: PWM(FREQUENCY=0) @(0);", "x: FREQUENCY is 0, expected 1 to 12500000 at a clock of 50,000,000 Hz"),
        ("x: PWM(CENTRE=1) @(0);", "x: CENTRE is 1, expected false or true"),
        ("x: PWM(DEAD_TIME=5) @(0);", 'x: DEAD_TIME is 5, expected 0 with MODE="sign"'),
        ('x: PWM(MODE="half") @(0);', 'x: MODE is "half", expected "sign", "up_down" or "offset"'),
        ("x[2]: STEPGEN(STEPLEN=3000000000 * i) @(8 * i);", "x[1]: STEPLEN is 3000000000, expected 0 to 2147483647"),
        ("x: ENCODER(FILTER=none) @(0);", ""),
        (
            "x: GPIO(DEBOUNCE=2.5) @(0);",
            "x: debounce_us is the number 2.5, and a generic is a whole number of 32 bits, a truth or a string",
        ),
    ],
)
def test_the_error_at_a_parameter_says_in_one_sentence_what_is_expected(placement: str, message: str) -> None:
    try:
        interface_of(placement)
        told = []
    except SpecError as error:
        told = [(one.span.file, one.message) for one in error.diagnostics if one.severity == "error"]
    assert told == ([("<text>", message)] if message else [])


OUTSIDE = [
    ("STEPGEN(STEPS=-800, MAXVEL=1)", "STEPS is -800, expected 1e-06 to 1000000000"),
    ("STEPGEN(STEPS=0)", "STEPS is 0, expected 1e-06 to 1000000000"),
    ("STEPGEN(STEPS=800, MAXVEL=-1)", "MAXVEL is -1, expected 0 to 218.453330078 at a clock of 50,000,000 Hz"),
    ("STEPGEN(MAXVEL=2000000)", "MAXVEL is 2000000, expected 0 to 174762.664062 at a clock of 50,000,000 Hz"),
    ("STEPGEN(MAXVEL=true)", "MAXVEL is true, expected 0 to 174762.664062 at a clock of 50,000,000 Hz"),
    ("STEPGEN(STEPS=2, MAXACCEL=134217728)", "MAXACCEL is 134217728, expected 0 to 134217727.5"),
    ("STEPGEN(UNIT=5)", "UNIT is a string, not the number 5"),
    ("STEPGEN(LEASE=5)", "LEASE is the name of a LEASE of the interface, not the number 5"),
    ('STEPGEN(SCHEDULE="a")', 'SCHEDULE is the name of a SCHEDULE of the interface, not the string "a"'),
    ("STEPGEN(GROUP=300)", "GROUP is 300, and 0 to 255 is expected"),
    ("PWM(LIMIT=-12)", "LIMIT is -12, expected 1e-09 to 1e+12"),
    ('PWM(LIMIT=0, UNIT="V")', "LIMIT is 0, expected 1e-09 to 1e+12"),
    ("PWM(WIDTH=1)", "WIDTH is 1, expected 2 to 24"),
    ("ENCODER(COUNTS=0)", "COUNTS is 0, expected 1 to 4294967296"),
    ('ENCODER(COUNTS="a")', 'COUNTS is "a", expected 1 to 4294967296'),
    ("ENCODER(SCALE=0)", "SCALE is 0, so that every value would be the same"),
    ("ENCODER(SCALE=1e13)", "SCALE is 1e+13, expected -1e+12 to 1e+12"),
    ("GPIO(DEBOUNCE=-1)", "DEBOUNCE is -1, expected 0 to 21474836.48 at a clock of 50,000,000 Hz"),
    ("GPIO(ON_EDGE=300)", "ON_EDGE: GROUP is 300, and 0 to 255 is expected"),
    ("LEASE(TIMEOUT=-1)", "TIMEOUT is -1, expected 1e-06 to 21.47483648 at a clock of 50,000,000 Hz"),
    ("LEASE(FINISH=-1)", "FINISH is -1, expected 0 to 21.47483648 at a clock of 50,000,000 Hz"),
    ("SCHEDULE(DEPTH=9)", "DEPTH is 9, expected 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 8192 or 16384"),
]


@pytest.mark.parametrize(("core", "message"), OUTSIDE, ids=[core for core, _ in OUTSIDE])
def test_a_wrong_parameter_is_one_error_at_the_argument_by_its_name(core: str, message: str) -> None:
    line = f"x: {core} @(0);"
    with pytest.raises(SpecError) as caught:
        interface_of(line)
    (error,) = (one for one in caught.value.diagnostics if one.severity == "error")
    expected = f"{message} with 1 axis in one instance" if "MAXVEL is" in message else message
    assert (error.message, error.span.file, error.text) == (f"x: {expected}", "<text>", line)
    name = message.partition(" ")[0].rstrip(":")
    value = core.partition(f"{name}=")[2].partition(",")[0].rstrip(")")
    assert line[error.span.column - 1 : error.span.end_column - 1] == value


def test_a_default_that_does_not_fit_is_an_error_at_the_placement() -> None:
    with pytest.raises(SpecError) as caught:
        interface_of("x: STEPGEN(STEPS=800) @(0);")
    (error,) = (one for one in caught.value.diagnostics if one.severity == "error")
    assert error.message.startswith("x: MAXVEL is 1000, expected 0 to 218.453330078 at a clock of 50,000,000 Hz")
    assert error.text[error.span.column - 1 : error.span.end_column - 1] == "STEPGEN"


@pytest.mark.parametrize(("core", "name", "last"), [("ENCODER", "COUNTS", "2"), ("STEPGEN", "STEPS", "2")])
def test_each_of_several_wrong_parameters_is_reported(core: str, name: str, last: str) -> None:
    with pytest.raises(SpecError) as caught:
        interface_of(f"x: {core}({name}=0) @(0x10); y: {core}({name}={last}) @(0x20); z: PWM(LIMIT=0) @(0x30);")
    messages = [one.message for one in caught.value.diagnostics if one.severity == "error"]
    assert [message[:7] for message in messages] == [f"x: {name}"[:7], "z: LIMI"]


@settings(max_examples=examples(20))
@given(
    clock_hz=CLOCKS,
    axes=st.integers(1, 16),
    steps=st.sampled_from([1, 7, 40, 800]),
    times=st.tuples(st.integers(0, 40_000), st.integers(0, 40_000)),
)
def test_the_largest_maxvel_is_the_speed_that_the_axes_can_reach(
    clock_hz: int, axes: int, steps: int, times: tuple[int, int]
) -> None:
    length, space = times
    entity = Settings(axes=axes, clock_hz=clock_hz, steplen_ns=length, stepspace_ns=space)
    fastest = entity.fastest / 256 / steps

    def check(maxvel: float) -> None:
        given = f"STEPS={steps}, STEPLEN={length}, STEPSPACE={space}"
        # Axes with another direction are in another instance and do not count.
        others = f"y[3]: STEPGEN({given}, MAXVEL=0, REVERSE=true) @(0x800 + 8 * i);"
        interface_of(
            f"GATEWAY(ADDRESS_BITS=16, CLOCK={clock_hz});",
            f"x[{axes}]: STEPGEN({given}, MAXVEL={maxvel!r}) @(8 * i); {others}",
        )

    check(fastest)
    with pytest.raises(SpecError) as caught:
        check(fastest * (1 + 1e-9))
    (error,) = (one for one in caught.value.diagnostics if one.severity == "error" and "x[0]" in one.message)
    assert error.message.endswith(f"Hz with {axes} {'axis' if axes == 1 else 'axes'} in one instance")


def test_build_reports_a_board_with_another_clock_before_any_tool_runs(tmp_path: Path) -> None:
    spec = compile_text("public robot() { GATEWAY(CLOCK=10000000); x: LEASE(TIMEOUT=60) @(0); }")
    board = load_board("ulx3s")[1]
    most = (1 << 30) / board.core_hz
    expected = f"x: TIMEOUT is 60, expected 1e-06 to {most:.12g} at a clock of {board.core_hz:,} Hz"
    with pytest.raises(ArgumentError, match=f"^{re.escape(expected)}$"):
        build(spec, "ulx3s", board, tmp_path)


def test_a_spec_with_given_parameters_is_checked_for_a_clock() -> None:
    members = "GATEWAY(CLOCK=10000000); TOSNET(CTRL=ctrl, COMM=9, BASE=0); x: LEASE(TIMEOUT=60) @(0xE0);"
    spec = compile_text(f"public robot(ctrl) {{ {members} }}")
    chosen = spec.given({"ctrl": 8}).interface()
    chosen.check_clock(10_000_000)
    with pytest.raises(ArgumentError, match=r"^x: TIMEOUT is 60, expected .* at a clock of 50,000,000 Hz$"):
        chosen.check_clock(50_000_000)


@pytest.mark.parametrize(
    ("limit", "message"),
    [
        ("RANGE(WIDTH, 1);", "RANGE takes a parameter of own, and then its allowed values"),
        ("RANGE(OTHER, 1, 2);", "RANGE takes a parameter of own, and then its allowed values"),
        ("RANGE();", "RANGE takes a parameter of own, and then its allowed values"),
        ("ONE_OF(WIDTH);", "ONE_OF takes a parameter of own, and then its allowed values"),
        ("ONE_OF(WIDTH, 1, OTHER=2);", "ONE_OF takes a parameter of own, and then its allowed values"),
        ('RANGE(WIDTH, "a", 2);', "RANGE takes two numbers after the parameter"),
    ],
)
def test_an_invalid_limit_is_reported(limit: str, message: str) -> None:
    outside = f'own(WIDTH=8): @(BASE) {{ {limit} ENTITY("own", width=WIDTH); @a = BASE: READ(); }}'
    with pytest.raises(SpecError) as caught:
        interface_of("x: own() @(1);", outside=outside)
    assert [one.message for one in caught.value.diagnostics] == [message]


def test_a_limit_of_axes_in_an_unused_component_is_accepted() -> None:
    interface_of(
        "@b = 1: READ();", outside='own(W=8): @(B) { RANGE(W, 1, AXES); ENTITY("own", width=W); @a = B: READ(); }'
    )


def test_a_limit_of_one_component_does_not_apply_to_another() -> None:
    outside = 'own(WIDTH=8): @(BASE) { RANGE(WIDTH, 1, none); ENTITY("own", width=WIDTH); @a = BASE: READ(); }'
    interface_of("x: own(1000) @(1);", outside=outside)
    with pytest.raises(SpecError, match="x: WIDTH is 0, expected at least 1"):
        interface_of("x: own(0) @(1); y: own(4) @(2);", outside=outside)
