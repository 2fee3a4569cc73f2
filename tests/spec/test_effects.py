"""Effects of accesses: the signals that may have one, the fields allowed beside them, and the effect on their words."""

import itertools

import hypothesis.strategies as st
import pytest
from hypothesis import given

from support.spec_examples import interface_of
from unity_link.spec import Effect, Interface, SpecError, compile_text
from unity_link.spec.comparing import compare

CLEARED = "@seen = 1[7:0]: READ(EFFECT=CLEAR_ON_READ);"
WORDS = {
    "plain": "READWRITE()",
    "cleared": "READWRITE(EFFECT=WRITE_1_TO_CLEAR)",
    "pulse": "WRITE(EFFECT=PULSE)",
}


def effects(interface: Interface) -> dict[str, Effect | None]:
    return {path: signal.effect for path, signal in interface.signals.items()}


def test_a_signal_has_one_of_three_effects_or_none() -> None:
    interface = interface_of(
        "@a = 0: READ(EFFECT=CLEAR_ON_READ);", "@b = 1: unsigned 4 READWRITE(EFFECT=WRITE_1_TO_CLEAR, RESET=3);",
        "@c = 2: bool WRITE(EFFECT=PULSE);", "@d = 3: bool READWRITE(EFFECT=PULSE);", "@e = 4: READWRITE();",
    )  # fmt: skip
    assert list(effects(interface).values()) == [*Effect, Effect.PULSE, None]
    assert interface.signals["b"].reset == 3


def test_an_effect_may_be_left_out_by_a_parameter() -> None:
    interface = interface_of("c: c() @(1);", outside="c(effect=none): @(at) { @x = at: READ(EFFECT=effect); }")
    assert effects(interface) == {"c.x": None}


def test_signals_of_a_row_have_the_effect_of_the_row() -> None:
    interface = interface_of("@flags[3] = 1[i]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR);")
    assert set(effects(interface).values()) == {Effect.WRITE_1_TO_CLEAR}


@given(kinds=st.lists(st.sampled_from(sorted(WORDS)), min_size=1, max_size=6))
def test_a_field_needs_a_masked_write_if_a_0_would_change_another_field(kinds: list[str]) -> None:
    members = [f"@s{bit} = 5[{bit}]: bool {WORDS[kind]};" for bit, kind in enumerate(kinds)]
    if "plain" in kinds and "cleared" in kinds:
        with pytest.raises(SpecError, match="would clear"):
            interface_of(*members)
        return
    signals = interface_of(*members).signals.values()
    assert {signal.is_field for signal in signals} == {len(kinds) > 1 and "plain" in kinds}


def test_a_word_cleared_by_reads_may_be_written_as_another_signal() -> None:
    interface = interface_of(CLEARED, "@go[2] = 1[i]: bool WRITE(EFFECT=PULSE);")
    assert not any(signal.is_field for signal in interface.signals.values())
    assert not interface_of(CLEARED, "@command = 1: WRITE();").signals["command"].is_field


@pytest.mark.parametrize("beside", ["@b = 1[8]: bool READ();", "@b = 1[9:8]: READ(EFFECT=CLEAR_ON_READ);"])
def test_a_word_cleared_by_reads_is_read_as_only_one_signal(beside: str) -> None:
    with pytest.raises(SpecError, match="which each read clears"):
        interface_of(CLEARED, beside)


def test_the_effect_belongs_to_the_map() -> None:
    texts = [
        f"public robot() {{ @x = 1: bool READWRITE({one}); }}"
        for one in ("", *(f"EFFECT={e}" for e in list(Effect)[1:]))
    ]
    interfaces = [compile_text(text).interface() for text in texts]
    assert len({interface.fingerprint for interface in interfaces}) == len(interfaces)
    for mine, board in itertools.permutations(interfaces, 2):
        (difference,) = compare(mine, board)
        assert difference.startswith("x: EFFECT is ")


def test_a_map_without_effects_keeps_its_earlier_fingerprint() -> None:
    interface = interface_of("@x = 1: READWRITE(RESET=3);")
    assert "EFFECT" not in interface.facts["x"]
