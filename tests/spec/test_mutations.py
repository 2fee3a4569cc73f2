"""The compiler ends with a model or a `SpecError` for any text."""

import random
from collections.abc import Callable

import hypothesis.strategies as st
import pytest
from hypothesis import given, settings

from support.searching import examples
from support.spec_examples import FIGURE_1, specs
from unity_link.spec import SpecError, compile_text, format_text
from unity_link.spec.printer import print_file
from unity_link.spec.syntax import File
from unity_link.spec.tokens import tokenize

FULL = """\
import "missing.ul";
enum mode { off, on = 2, /* c */ auto }
group state(1, 10, TIMESTAMPS, JOINTS(POSITION=pos));
public robot(ctrl, base=0x10) {
  GATEWAY(ADDRESS_BITS=12, DATA_BITS=32);
  TOSNET(CTRL=ctrl, BASE=0);
  legs[3]: leg("leg " + i) @(base + 8 * i, vel=0x80 + i); // trailing
  TOSNET_NODE(NODE=2) { @m[1:0] = 3: mode READWRITE(); }
  pins: MEMORY(BASE=0x100, SIZE=8);
  @led = 0x40[3]: bool READWRITE(ID="led");
}
/// A leg
leg(name): @(pos, vel) {
  @pos: signed 16 READ(ID=name + ":pos", SCALE=360 / 4096, UNIT="deg", PUBLISH(state));
  @vel: fixed 8.8 WRITE(MIN=-1, MAX=1.5e0);
}
"""
SNIPPETS = [token + " " for token in dict.fromkeys(map(str, tokenize(FULL)))] + [
    "(" * 50, "{" * 50, "-" * 5000, "1+" * 5000, "1<<99999999999", "9" * 5000, '"' + "x" * 5000, "/*", "*/", "\0", "é",
    "\N{GRINNING FACE}", "\r", "\t", "#", "'", "1e999", "0x", "0b2", "[99999999]", "public",
    'import "/";', 'import "\0";',
]  # fmt: skip


def survives(text: str) -> None:
    """Compile and format a text; check the rendered errors."""
    for work in (compile_text, format_text):
        shown = refusal(work, text)
        assert shown is None or shown
        for internal in ("lark", "Traceback", "LSQB", "RPAR", "SEMICOLON", "$END", "OPERATOR"):
            assert shown is None or internal in text or internal not in shown
        assert shown is None or len(shown) < 200_000


def refusal(work: Callable[[str], object], text: str) -> str | None:
    try:
        work(text)
    except SpecError as error:
        return str(error)
    return None


def mutated(text: str, chance: random.Random) -> str:
    for _ in range(chance.randint(1, 4)):
        start = chance.randrange(len(text) + 1)
        end = min(len(text), start + chance.choice([0, 0, 1, 1, 2, 5, 20, 200]))
        piece = chance.choice(["", *SNIPPETS, text[start:end] * 2, chance.choice("(){}[];:,@=-+/*\"'\\ \n0aZ")])
        text = text[:start] + piece + text[end:]
    return text


@pytest.mark.slow
@settings(max_examples=examples(120))
@given(st.sampled_from([FULL, FIGURE_1]), st.randoms(use_true_random=False))
def test_a_mutated_spec_compiles_or_is_refused(text: str, chance: random.Random) -> None:
    survives(mutated(text, chance))


@pytest.mark.slow
@settings(max_examples=examples(40))
@given(specs(), st.randoms(use_true_random=False))
def test_a_mutated_generated_spec_compiles_or_is_refused(file: File, chance: random.Random) -> None:
    survives(mutated(print_file(file), chance))


@settings(max_examples=examples(100))
@given(st.lists(st.sampled_from(SNIPPETS), max_size=40))
def test_any_sequence_of_tokens_compiles_or_is_refused(tokens: list[str]) -> None:
    survives(" ".join(tokens))


@given(st.text(max_size=100))
def test_garbage_is_refused(text: str) -> None:
    survives(text)


@pytest.mark.parametrize("text", [FULL, FIGURE_1])
def test_a_spec_cut_anywhere_compiles_or_is_refused(text: str) -> None:
    for end in range(0, len(text), 3):
        survives(text[:end])


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        "public x() { @a = " + "(" * 100_000 + "1" + ")" * 100_000 + ": READ(); }",
        "public x() { @a = " + "-" * 100_000 + "1: READ(); }",
        "public x() { @a = " + "1 + " * 100_000 + "1: READ(); }",
        "public x() { " + "MEMORY() {" * 10_000 + "}" * 10_000 + "}",
        "".join(f"c{i}() {{ a: c{i + 1}(); }}\n" for i in range(2000)) + "c2000() {} public x() { a: c0(); }",
        "".join(f"c{i}(n) {{ a: c{i + 1}(n + n); b: c{i + 1}(n + n); }}\n" for i in range(40))
        + 'c40(n) {} public x() { a: c0("12345678"); }',
        "c() { @a = 1: READ(); } b() { c[60000]: c(); } a() { b[60000]: b(); } public x() { a[60000]: a(); }",
        "public x() { @a = 1 << 100 << 100 << 100: READ(); }",
        "public x() { @a = " + "9" * 100_000 + ": READ(); }",
        "public x() { @a = " + "9" * 1_000 + ": unsigned " + "9" * 1_000 + " READ(); }",
        'public x() { @a = 1: READ(ID="' + "x" * 100_000 + '"); }',
        "enum e { " + ", ".join(f"v{i}" for i in range(20_000)) + " }",
        "@" * 20_000,
        ";" * 20_000,
        "public x() {\n" + "  @a = 1: READ()\n" * 5_000 + "}",
        "\n" * 100_000 + "x",
    ],
    ids=lambda text: repr(text[:12] + text[-30:]),
)  # fmt: skip
def test_very_deep_or_long_specs_compile_or_are_refused(text: str) -> None:
    survives(text)
