"""The examples of the language's tutorial and reference are valid, and the reference names every word and rule."""

import re
from pathlib import Path

import pytest

from unity_link.spec import compile_text
from unity_link.spec.arguments import ACCESS, GATEWAY, GROUP
from unity_link.spec.entity import CLOCK, ENTITY_WORD, LIMIT_WORDS, PORT_WORDS, WANTS
from unity_link.spec.model import Effect, Way
from unity_link.spec.modules import MODULES
from unity_link.spec.signals import PLAIN_KINDS

ROOT = Path(__file__).parents[2]
DOCUMENT = (ROOT / "docs/reference/ul-spec.md").read_text(encoding="utf-8")
TUTORIAL = (ROOT / "docs/tutorials/spec.md").read_text(encoding="utf-8")
SPECS = re.findall(r"^```ul\n(.*?)^```", DOCUMENT + TUTORIAL, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("block", SPECS, ids=range(len(SPECS)))
def test_an_example_is_valid(block: str) -> None:
    whole = block if "public" in block else f"public robot() {{\n{block}}}"
    spec = compile_text(whole)
    assert spec.warnings == ()
    assert spec.interface().signals


def test_there_are_examples() -> None:
    assert len(SPECS) == 21


OF_CORES = (ENTITY_WORD, CLOCK, *LIMIT_WORDS, *PORT_WORDS, *WANTS, *Way)
WORDS = dict.fromkeys(
    [*MODULES, *(slot.name for slot in (*ACCESS, *GATEWAY, *GROUP)), *PLAIN_KINDS, *OF_CORES, *Effect]
)


@pytest.mark.parametrize("name", WORDS)
def test_every_word_of_the_language_is_documented(name: str) -> None:
    assert re.search(rf"`[^`]*\b{name}\b", DOCUMENT)


def test_the_grammar_is_that_of_the_parser() -> None:
    grammar = (ROOT / "unity_link/spec/grammar.lark").read_text(encoding="utf-8")
    rules = set(re.findall(r"^\??([a-z]+)_?:", grammar, re.MULTILINE)) - {"start", "item", "label", "atom"}
    told = DOCUMENT[DOCUMENT.index("## Grammar") :]
    renamed = {"enum_value": "value"}
    assert {renamed.get(rule, rule) for rule in rules} <= set(re.findall(r"^([a-z]+) +=", told, re.MULTILINE))
