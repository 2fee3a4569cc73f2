"""Rates of groups: the base frequency follows the spec, actual rates are printed, and impossible ones are refused."""

from pathlib import Path

import hypothesis.strategies as st
import pytest
from hypothesis import given

import unity_link
from support.simulated_time import on_simulated_time
from unity_link.cli.spec import show
from unity_link.generate import generate
from unity_link.spec import Interface, SpecError, compile_text
from unity_link.spec.rates import base_millihertz

RATES = st.one_of(
    st.integers(1, 200_000), st.sampled_from([0.1, 0.5, 2.5, 0.001, 1 / 3]), st.floats(1e-4, 1e6, allow_nan=False)
)


def text(*rates: float, outside: str = "") -> str:
    signals = "".join(f"@s{place} = {place}: READ(PUBLISH(g{place}));" for place in range(len(rates)))
    groups = "".join(f"group g{place}(RATE={rate!r});" for place, rate in enumerate(rates))
    return f"public r() {{ {signals} {outside} }}\n{groups}"


def interface(*rates: float) -> Interface:
    return compile_text(text(*rates)).interface()


@pytest.mark.parametrize(("rates", "base"), [
    ((100,), 100_000), ((333,), 99_900), ((5, 200), 100_000), ((2.5,), 100_000), ((1,), 50_000), ((0.1,), 6_250),
    ((1, 0.1), 6_250), ((200_000,), 200_000), ((150_000, 100_000), 300_000), ((0.001,), 62.5), ((30, 1), 65_520),
])  # fmt: skip
def test_the_base_frequency_follows_the_rates_of_the_spec(rates: tuple[float, ...], base: float) -> None:
    made = interface(*rates)
    assert base_millihertz(made.groups) == base * 1000
    assert [group.published_hz for group in made.groups] == pytest.approx(list(rates), rel=1e-15)


@given(st.lists(RATES, min_size=1, max_size=4))
def test_each_rate_is_the_nearest_possible_one_or_refused(rates: list[float]) -> None:
    try:
        groups = interface(*rates).groups
    except SpecError as error:
        groups = ()
        refused = {one.code for one in error.diagnostics}
        assert (refused, max(rates) > 65535 * min(rates)) == ({"group-rate"}, True)
        return
    base = base_millihertz(groups) / 1000
    assert 0.001 <= base <= 2_147_483.647
    for rate, group in zip(rates, groups, strict=True):
        divisor = round(base / group.published_hz) if group.published_hz is not None else 0
        assert 1 <= divisor <= 65535
        assert group.published_hz == base / divisor
        assert abs(base / rate - divisor) <= 0.500001


@pytest.mark.parametrize(("spec", "expected"), [
    (text(0.1, 200_000), "the group g0 has a rate of 0.1 Hz, and 3.052 to 2147483.647 Hz is expected"),
    (text(0.1, 200_000), "the group g1 has a rate of 200000 Hz, and 1.526e-06 to 6553.5 Hz is expected"),
    (text(3_000_000), "the group g0 has a rate of 3000000 Hz, and 0 to 2147483.647 Hz is expected"),
    (text(1, outside="@b = 9: READ(PUBLISH(9, 10));"), "the group g0 has a rate of 1 Hz, and 1.526 to 100000 Hz"),
])  # fmt: skip
def test_the_error_for_an_impossible_rate_has_the_group_and_the_range(spec: str, expected: str) -> None:
    with pytest.raises(SpecError) as caught:
        compile_text(spec)
    assert expected in str(caught.value)


@on_simulated_time
async def test_the_printed_rates_are_those_of_the_samples(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "slow.ul"
    path.write_text(text(0.7, 1000, 333))
    robot_type = unity_link.load(path)
    show(str(path))
    printed = capsys.readouterr().out
    spec = compile_text(path.read_text())
    made = {one.name: one.text for target in ("docs", "c") for one in generate(target, spec)}
    header, page = made["r.h"], made["r.md"]
    async with unity_link.connect(f"sim:{path}") as link:
        for group in robot_type(link).groups.values():
            async with group.subscribe() as samples:
                assert group.model is not None
                assert samples.rate_hz == pytest.approx(group.model.published_hz, rel=1e-12)
                for place in (printed, header, page):
                    assert f"{samples.rate_hz:.6g} Hz" in place
