"""Specs for tests: figure 1 of the paper, and valid specs that hypothesis makes as syntax trees."""

from __future__ import annotations

from typing import Any

import hypothesis.strategies as st

from unity_link.spec import Interface, compile_text
from unity_link.spec.syntax import (
    Argument,
    Bits,
    Call,
    Chain,
    ComponentDeclaration,
    EnumDeclaration,
    EnumValueDeclaration,
    Expression,
    File,
    GroupDeclaration,
    Item,
    KindSpecifier,
    Member,
    Name,
    Number,
    ParameterDeclaration,
    Parenthesis,
    Placement,
    Prefixed,
    SignalDeclaration,
    Text,
    Word,
)

FIGURE_1 = """\
public scara(ctrl,comm) {
  TOSNET(CTRL=ctrl, COMM=comm, BASE=0);
  j1: joint("joint 1") @(0x80,0x88,0x8C,0x94);
  j2: joint("joint 2") @(0x81,0x89,0x8D,0x95);
  j3: joint("joint 3") @(0x82,0x8A,0x8E,0x96);
  j4: joint("joint 4") @(0x83,0x8B,0x8F,0x97);
}
joint(name): @(spd,cpos,pos_sp,spd_sp) {
  @cpos: signed READ(ID=name+":cpos", PUBLISH(1,10));
  @spd: READ(ID=name+":spd", PUBLISH(1,10));
  @pos_sp: signed WRITE(ID=name+":pos_sp");
  @spd_sp: WRITE(ID=name+":spd_sp");
}
"""
"""Figure 1 of the paper, word for word."""


def interface_of(*members: str, outside: str = "", **options: Any) -> Interface:
    """Compile a public interface with these members; return it."""
    inside = "\n".join(members)
    return compile_text(f"public robot() {{\n{inside}\n}}\n{outside}", **options).interface()


# Valid specs

words = st.from_regex(r"[a-z][a-z0-9_]{0,5}", fullmatch=True).filter(
    lambda word: word not in {"i", "pi", "true", "false", "import", "enum", "group", "public", "mro"}
)
texts = st.text(st.characters(codec="utf-8", exclude_categories=["Cs", "Cc"]), max_size=8)
comment_texts = st.text(st.characters(codec="latin-1", exclude_categories=["Cc"], exclude_characters="/*"), max_size=12)
numbers = st.one_of(
    st.integers(0, 255).map(str),
    st.integers(0, 255).map(hex),
    st.integers(0, 15).map(bin),
    st.sampled_from(["1_000", "1.5", "2e3", "0.25e-2"]),
).map(Number)


def whole(value: int) -> Expression:
    """Return a number as hexadecimal or decimal text of the same value."""
    return Number(hex(value) if value % 2 else str(value))


@st.composite
def expressions(draw: st.DrawFn, names: list[str]) -> Expression:
    """Draw an expression whose value is a number, if those of the names are."""
    leaves = st.one_of(numbers, st.sampled_from(names).map(lambda name: Name(Word(name)))) if names else numbers

    def larger(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
        operands = st.one_of(leaves, inner.map(Parenthesis))
        chains = st.lists(operands, min_size=2, max_size=3).flatmap(
            lambda some: st.lists(st.sampled_from("+-*"), min_size=len(some) - 1, max_size=len(some) - 1).map(
                lambda operators: Chain(list[Expression](some), operators)
            )
        )
        return st.one_of(chains, operands.map(lambda one: Prefixed("-", one)))

    return draw(st.recursive(leaves, larger, max_leaves=4))


ROW = 2
"""Most signals in a row."""
SIZE = 12
"""Width in bits of signals of components whose width is a parameter."""


@st.composite
def kinds(draw: st.DrawFn, enumerations: list[EnumDeclaration]) -> tuple[KindSpecifier | None, int]:
    """Draw a kind of at most 32 bits; return it with its width in bits."""
    width = draw(st.integers(1, 32))
    fraction = draw(st.integers(0, width))
    choices: list[tuple[KindSpecifier | None, int]] = [
        (None, 32),
        (KindSpecifier(Word("bool")), 1),
        (KindSpecifier(Word("unsigned"), Number(str(width))), width),
        (KindSpecifier(Word("signed"), Number(str(width))), width),
        (KindSpecifier(Word("float"), Number("32")), 32),
        (KindSpecifier(Word("float"), Number("16")), 16),
        (KindSpecifier(Word("fixed"), Number(f"{width - fraction}.{fraction}")), width),
        (KindSpecifier(Word("ufixed"), Number(f"{width - fraction}.{fraction}")), width),
        *((KindSpecifier(Word(one.name), Number("8")), 8) for one in enumerations),
    ]
    return draw(st.sampled_from(choices))


def _resets(kind: KindSpecifier | None, enumerations: list[EnumDeclaration]) -> list[Argument]:
    """Return a RESET clause of a kind with a value that fits every width, or none if the kind has no such value."""
    word = "unsigned" if kind is None else str(kind.name)
    values: dict[str, Expression] = {
        "bool": Name(Word("true")),
        "unsigned": Number("1"),
        "signed": Prefixed("-", Number("1")),
        "float": Number("0.5"),
        **{str(one.name): Name(Word(one.members[-1].name)) for one in enumerations},
    }
    return [Argument(Word("RESET"), values[word])] if word in values else []


_EFFECTS = {
    ("bool", "READ"): ["CLEAR_ON_READ"],
    ("unsigned", "READ"): ["CLEAR_ON_READ"],
    ("bool", "WRITE"): ["PULSE"],
    ("bool", "READWRITE"): ["PULSE", "WRITE_1_TO_CLEAR"],
    ("unsigned", "READWRITE"): ["WRITE_1_TO_CLEAR"],
}
"""Effects that are possible for signals of a kind and an access."""


@st.composite
def signals(
    draw: st.DrawFn, name: str, address: int, enumerations: list[EnumDeclaration], groups: list[str]
) -> SignalDeclaration:
    """Draw a signal at its own address; a negative address is an offset from `base`."""
    kind, width = draw(kinds(enumerations))
    if address < 0 and draw(st.booleans()):
        kind, width = KindSpecifier(Word("unsigned"), Name(Word("size"))), SIZE
    low = draw(st.integers(0, 32 - width))
    is_number = kind is None or kind.name in {"unsigned", "signed", "fixed", "ufixed"}
    access = draw(st.sampled_from(["READ", "WRITE", "READWRITE"]))
    arguments: list[Argument] = []
    effects = _EFFECTS.get(("unsigned" if kind is None else str(kind.name), access), [])
    effect = draw(st.sampled_from([None, *effects]))
    if effect is not None:
        arguments.append(Argument(Word("EFFECT"), Name(Word(effect))))
    elif draw(st.booleans()) and is_number:
        arguments.append(Argument(Word("SCALE"), draw(st.sampled_from([Number("0.1"), Number("2"), Number("1e-3")]))))
    if draw(st.booleans()):
        arguments.append(Argument(Word("UNIT"), Text(draw(texts))))
    if effect is not None:
        arguments += _resets(kind, enumerations) if effect == "WRITE_1_TO_CLEAR" and draw(st.booleans()) else []
    elif access != "WRITE" and groups and draw(st.booleans()):
        group = Name(Word(draw(st.sampled_from(groups))))
        arguments.append(Argument(None, Call(Word("PUBLISH"), [Argument(None, group)])))
    elif access != "WRITE" and draw(st.booleans()):
        arguments.append(Argument(None, Call(Word("POLL"), [Argument(None, Number("20"))])))
    elif draw(st.booleans()) and width == 32 and (kind is None or kind.name != "float"):
        arguments.append(Argument(None, Name(Word("FIFO"))))
    elif access != "READ" and draw(st.booleans()) and not any(argument.name == "SCALE" for argument in arguments):
        arguments += _resets(kind, enumerations)
    where: Expression = Chain([Name(Word("base")), whole(-address - 1)], ["+"]) if address < 0 else whole(address)
    bits = Bits(whole(low + width - 1), whole(low)) if width < 32 or draw(st.booleans()) else None
    doc = draw(st.lists(comment_texts.map(str.strip).filter(bool), max_size=2))
    return SignalDeclaration(Word(name), where, bits, kind, Word(access), draw(st.permutations(arguments)), doc=doc)


@st.composite
def rows(draw: st.DrawFn, signal: SignalDeclaration) -> SignalDeclaration:
    """Draw a single signal, or a row of at most `ROW` signals at consecutive addresses."""
    if draw(st.booleans()):
        assert signal.address is not None
        signal.count = whole(draw(st.integers(1, ROW)))
        signal.address = Chain([Parenthesis(signal.address), Name(Word("i"))], ["+"])
    return signal


def _unique_names(draw: st.DrawFn, taken: set[str], size: int) -> list[str]:
    names = draw(st.lists(words.filter(lambda name: name not in taken), min_size=size, max_size=size, unique=True))
    taken.update(names)
    return names


@st.composite
def specs(draw: st.DrawFn) -> File:
    """Draw a complete valid spec: enumerations, groups, components in arrays, modules."""
    taken = {
        "base",
        "name",
        "size",
        "none",
        *(kind for kind in ("bool", "unsigned", "signed", "float", "fixed", "ufixed")),
    }
    enumerations = [
        EnumDeclaration(
            Word(name),
            [
                EnumValueDeclaration(
                    Word(value), None if draw(st.booleans()) and index == 0 else Number(str(10 * index))
                )
                for index, value in enumerate(_unique_names(draw, set(), draw(st.integers(1, 3))))
            ],
        )
        for name in _unique_names(draw, taken, draw(st.integers(0, 2)))
    ]
    groups = _unique_names(draw, taken, draw(st.integers(0, 2)))
    group_items = [
        GroupDeclaration(Word(name), [Argument(Word("DIVISOR"), Number(str(10 + index)))])
        for index, name in enumerate(groups)
    ]
    components: list[ComponentDeclaration] = []
    for name in _unique_names(draw, taken, draw(st.integers(0, 2))):
        names = _unique_names(draw, set(), draw(st.integers(1, 3)))
        inside: list[Member] = [
            draw(rows(draw(signals(one, -ROW * index - 1, enumerations, groups)))) for index, one in enumerate(names)
        ]
        components.append(
            ComponentDeclaration(
                public=False,
                name=Word(name),
                parameters=[ParameterDeclaration(Word("name")), ParameterDeclaration(Word("size"), whole(SIZE))],
                addresses=[ParameterDeclaration(Word("base"))],
                members=inside,
            )
        )
    members: list[Member] = []
    address = 0
    (interface,) = _unique_names(draw, taken, 1)
    for index, name in enumerate(_unique_names(draw, set(taken), draw(st.integers(1, 4)))):
        in_component: bool = draw(st.booleans())
        if components and in_component:
            component = draw(st.sampled_from(components))
            count = draw(st.one_of(st.none(), st.integers(1, 3)))
            place = whole(address)
            if count is not None:
                place = Chain([place, whole(4 * ROW), Name(Word("i"))], ["+", "*"])
            members.append(
                Placement(
                    Word(name),
                    None if count is None else whole(count),
                    Word(component.name),
                    [Argument(None, Text(draw(texts)))],
                    [Argument(None, place)],
                )
            )
            address += 4 * ROW * (count or 1)
        else:
            signal = draw(signals(name, 0, enumerations, groups))
            signal.address = whole(address)
            if draw(st.booleans()) and index == 0:
                block = [Argument(Word("BASE"), whole(0)), Argument(Word("SIZE"), whole(1))]
                members.append(Placement(None, None, Word("MEMORY"), block, None, [signal]))
            else:
                members.append(draw(rows(signal)))
            address += ROW
    public = ComponentDeclaration(public=True, name=Word(interface), parameters=[], addresses=None, members=members)
    items: list[Item] = [*enumerations, *group_items, *components, public]
    return File(draw(st.permutations(items)))
