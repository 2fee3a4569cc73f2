"""Every message to the author: its rule, its sentence, the underlined text and the advice."""

# ruff: noqa: E501, Q003 -- each case is one line of a table, and its text has quotes of both kinds

import os
import re
from pathlib import Path

import pytest

from unity_link.spec import Diagnostic, SpecError, compile_file, compile_text
from unity_link.spec.diagnostics import did_you_mean
from unity_link.spec.parser import MOST_CHARACTERS
from unity_link.spec.tokens import tokenize


def faults(text: str, address_bits: int | None = None) -> tuple[Diagnostic, ...]:
    with pytest.raises(SpecError) as caught:
        compile_text(text, "robot.ul", address_bits=address_bits)
    return caught.value.diagnostics


def underlined(text: str, found: Diagnostic) -> str:
    """Return the text that a diagnostic underlines, up to the end of its first line."""
    line = text.splitlines()[found.span.line - 1]
    return line[found.span.column - 1 : found.span.end_column - 1 if found.span.end_line == found.span.line else None]


NAMED = """
enum mode { idle, run = 3 }
group state(RATE=100);
group slow(1, 10);

joint(name, size=2): @(pos, vel) {
  @pos: READ(ID=name + ":p");
  @vel: signed 16 READ(ID=name + ":v", PUBLISH(state));
  @row[size] = 0x40 + i: READ();
}

public robot() {
  GATEWAY(ADDRESS_BITS=12);
  j[2]: joint("a", size=1) @(0x10 * i, vel=1);
  pool: MEMORY(BASE=0x80, SIZE=2) { @c = 0: READ(); }
  @s = 1: READ();
  @m = 2[3:0]: mode READWRITE(PUBLISH(slow));
  @t = 3: READ();
}
"""


@pytest.mark.parametrize("word", ["enum", "group", "public", "import"])
def test_a_keyword_in_place_of_a_name_causes_one_fault(word: str) -> None:
    names = [token for token in tokenize(NAMED) if token.type == "NAME"]
    assert len(names) > 40
    for name in names:
        start, end = name.start_pos or 0, name.end_pos or 0
        (fault,) = faults(NAMED[:start] + word + NAMED[end:])
        assert fault.span.line == NAMED.count("\n", 0, start) + 1
        # Before the parameters of a component, a keyword begins a declaration.
        assert fault.help == f"'{word}' is a word of the language: choose another name" or NAMED[end] == "("


def test_a_declaration_after_an_unclosed_block_is_parsed() -> None:
    text = "public x() {\n  @a = 1 READ();\n  @b = : ;\nenum mode { off, on = }\ngroup g(RATE=);\n"
    assert [found.span.line for found in faults(text)] == [2, 3, 4, 5]


def test_faults_of_one_line_share_its_text() -> None:
    texts = [found.text for found in faults("public x() {\n" + "".join(f"@s{i}=q:READ();" for i in range(100)) + "\n}")]
    assert len(texts) == 100
    assert all(text is texts[0] for text in texts)


JOINT = "\njoint(name): @(pos, vel) { @pos: READ(ID=name + \":p\"); @vel: READ(ID=name + \":v\"); }"  # fmt: skip
MODE = "\nenum mode { off, on = 5 }"
PLAN = '\nSCHEDULE(): @(at) { ENTITY("ul_schedule", TIME, STAGE); @entry = at: unsigned 32 WRITE(); }'
CASES = [
    # Syntax. Columns: the spec; the rule; the sentence; the underlined text; the advice, or a part of it.
    ("public x() { @a = 1: READ(); ", "syntax", "this block has no end", "{", "close it with '}'"),
    ("public x() { @a = 1 READ(); }", "syntax", "':' or '[' was expected, not a name (READ)", "READ", ""),
    ("public x() {\n  @a = 1: READ()\n  @b = 2: READ();\n}", "syntax", "a ';' is missing after this", ")", ""),
    ('public x() { @a = 1: READ(ID="b); }', "syntax", "this string has no end", '"b); }', "close it with '\"'"),
    ("public x() { /* @a = 1: READ(); }", "syntax", "this comment has no end", "/*", "close it with '*/'"),
    ("public x() { $ }", "syntax", "the character '$' has no meaning here", "$", ""),
    ("public x() { @a = '1': READ(); }", "syntax", "the character \"'\" has no", "'", "put strings in double quotes"),
    ("public x() { } # end", "syntax", "the character '#' has no meaning here", "#", "a comment begins with //"),
    ("/// A \x1b here.\npublic x() { }", "control-character", "the control character U+001B is not allowed", "\x1b", "leave it out"),
    ('public x() { @a = 1: READ(UNIT="m\0"); }', "control-character", "the control character U+0000 is not allowed", "\0", "leave it out"),
    ("enum", "syntax", "the file ends where a name was expected", "m", ""),
    ("public x() { @a = " + "(" * 50 + "1: READ(); }", "too-deep", "brackets are nested more than 40 deep", "(", ""),
    # Names.
    ("public x() { @a = b: READ(); }", "unknown-name", "nothing is called 'b' here", "b", ""),
    (
        "public x() { @a = 1: READ(PUBLISH(slow)); }",
        "unknown-name",
        "nothing is called 'slow' here",
        "slow",
        "declare it: group slow(RATE=100);",
    ),
    (
        "group g(RATE=10, TIMESTAMP); public x() { @a = 1: READ(PUBLISH(g)); }",
        "unknown-name",
        "nothing is called 'TIMESTAMP' here",
        "TIMESTAMP",
        "mean 'TIMESTAMPS'?",
    ),
    ("public x(base=1) { @a = bsae: READ(); }", "unknown-name", "nothing is called 'bsae'", "bsae", "mean 'base'?"),
    ("public x() { @a = 1: READ(PUBLISH(slow)); }", "unknown-name", "nothing is called 'slow'", "slow", "declare it: group slow(RATE=100);"),
    ("public x() { @a = 1: READ(GROUP(slwo)); }\ngroup slow(1, 10);", "unknown-name", "nothing is called 'slwo'", "slwo", "mean 'slow'?"),
    ("public x() {}\ngroup slow(1, TIMESTAMP);", "unknown-name", "nothing is called 'TIMESTAMP'", "TIMESTAMP", "mean 'TIMESTAMPS'?"),
    ("public x() { j: joit(1); }" + JOINT, "unknown-component", "there is no component 'joit'", "joit", "mean 'joint'?"),
    ("public x() { MEMROY(BASE=1); }", "unknown-component", "there is no module 'MEMROY'", "MEMROY", "mean 'MEMORY'?"),
    ("public x() { @a = 1: READ(); @a = 2: READ(); }", "name-twice", "'a' is declared twice in x", "a", ""),
    ("public x() { @a = 1: READ(); @A = 2: READ(); }", "name-twice", "'A' and 'a' differ only in case", "A", ""),
    ("MEMORY(): @(at) { @a = at: READ(); }\npublic x() { m: MEMORY(BASE=4); }", "module-word", "MEMORY is the word of a hardware module, and no component can have it", "MEMORY", "call it otherwise"),
    ("public x() {}\nx() {}", "name-twice", "the name 'x' is declared twice", "x", ""),
    ("public x(a, a) {}", "name-twice", "x has two parameters 'a'", "a", ""),
    ("public x() {}\nc(i) {}", "name-taken", "'i' is the index of an array", "i", ""),
    ("public x() {}\nc(pi) {}", "name-taken", "'pi' is a constant", "pi", ""),
    ("public x() {}\nenum bool { a }", "name-taken", "'bool' is a kind already", "bool", ""),
    ("public x() { joint(1) @(1, 2); }" + JOINT, "no-name", "this joint has no name", "joint", "first: joint(...);"),
    # Expressions.
    ("public x() { @a = 12bit: READ(); }", "bad-number", "'12bit' is no number", "12bit", "numbers look like"),
    ("public x() { @a = 0x1G: READ(); }", "bad-number", "'0x1G' is no number", "0x1G", "numbers look like"),
    ("public x() { @a = 1 / 0: READ(); }", "bad-operand", "a division by 0", "1 / 0", ""),
    ("public x() { @a = 1 << 200: READ(); }", "bad-operand", "a shift by 200 was asked for, 0 to 128", "1 << 200", ""),
    ('public x() { @a = "1" * 2: READ(); }', "bad-operand", "'*' takes numbers, not the string \"1\"", '"1" * 2', ""),
    ("public x() { @a = 1.5 & 1: READ(); }", "bad-operand", "'&' takes whole numbers, not 1.5 and 1", "1.5 & 1", ""),
    ('public x() { @a = -"b": READ(); }', "bad-operand", "'-' before the string \"b\" has no meaning", '-"b"', ""),
    ("public x() { @a = f(1): READ(); }", "no-value", "'f(...)' has no value", "f", ""),
    ("public x() { @a = flor(1): READ(); }", "no-value", "'flor(...)' has no value", "flor", "mean 'floor'?"),
    ("public x() { @a = log2(0): READ(); }", "bad-operand", "log2 takes a number above 0, not 0", "log2(0)", ""),
    ("public x() { @a = ceil(1, 2): READ(); }", "bad-operand", "ceil takes 1 number, and 2 are given", "ceil(1, 2)", ""),
    ("public x() { @a = max(): READ(); }", "bad-operand", "max takes 1 number at least, and none is given", "max()", ""),
    ('public x() { @a = min(1, "b"): READ(); }', "bad-operand", "min takes numbers, not the string \"b\"", 'min(1, "b")', ""),
    ("public x() { @a = floor(of=1.5): READ(); }", "bad-operand", "floor takes its numbers without names", "floor(of=1.5)", ""),
    # Addresses.
    ("public x() { @a: READ(); }", "no-address", "'a' has no address", "a", "write where it is: @a = 0x10"),
    ("public x() { c: c() @(1); }\nc(): @(pos) { @pso: READ(); }", "no-address", "'pso' has no", "pso", "mean 'pos'?"),
    ("public x() { @a = 1.5: READ(); }", "bad-address", "an address is a whole number, not the number 1.5", "1.5", ""),
    ("public x() { @a = 0x100: READ(); }", "address-range", "the address 0x100 of a is not the gateway's, which has 0x0 to 0xff (8 address bits)", "0x100", "ADDRESS_BITS"),
    ("public x() { @a = -1: READ(); }", "address-range", "the address -1 of a is not the gateway's", "-1", ""),
    ("public x() { @a = -1: unsigned 64 READ(); }", "address-range", "the address -1 of a is not the gateway's", "-1", ""),
    ("public x() { @a = 255: unsigned 64 READ(); }", "address-range", "the address 0x100 of a", "255", ""),
    ("public x() { MEMORY(SIZE=4) { @a = 4: READ(); } }", "address-range", "the address 0x4 of a is outside of MEMORY, which has 4 words", "4", ""),
    ("public x() { MEMORY(BASE=8, SIZE=4) { @a = -1: unsigned 64 READ(); } }", "address-range", "the address -1 of a is outside of MEMORY, which has 4 words", "-1", ""),
    ("public x() { m: MEMORY(BASE=250, SIZE=10); }", "address-range", "MEMORY takes the addresses 0xfa to 0x103", "MEMORY", ""),
    ("public x() { @a = 1: READ(); @b = 1: READ(); }", "overlap", "b takes bits 31:0 at address 0x1, which a has (bits 31:0)", "1", ""),
    ("public x() { @a = 1[7:0]: READ(); @b = 1[7]: bool READ(); }", "overlap", "b takes bit 7 at address 0x1, which a has (bits 7:0)", "1", ""),
    ("public x() { @a = 1: unsigned 64 READ(); @b = 2: READ(); }", "overlap", "b takes bits 31:0 at address 0x2", "2", ""),
    ("public x() { j[2]: joint(\"j\" + i) @(i, 1); }" + JOINT, "overlap", "j[1].pos takes bits 31:0 at address 0x1, which j[0].vel has", "i", ""),
    ("public x() { @a = 1: READ(); @b = 1[3:0]: WRITE(); @c = 1[7:4]: WRITE(); }", "overlap", "b is one of several fields written at address 0x1, where reading gives a instead", "1", "make the field READWRITE"),
    # Registers that wrap.
    ("public x() { @a = 1: bool READ(WRAPS); }", "bad-wraps", "no bool wraps", "WRAPS", "signed, unsigned and fixed"),
    ("public x() { @a = 1: unsigned 64 READ(WRAPS); }", "bad-wraps", "has at most 48 bits, and this one has 64", "WRAPS", ""),
    ("public x() { @a = 1: READWRITE(WRAPS, MAX=9); }", "bad-wraps", "no signal with WRAPS has MAX", "MAX=9", "leave it out"),
    ("public x() { @a = 1: READ(WRAPS, FIFO); }", "bad-wraps", "no signal with WRAPS has FIFO", "FIFO", ""),
    ("public x() { @a = 1: READ(WRAPS(b)); }", "bad-wraps", "a wraps as b does, which is no signal of its component that is read and wraps", "WRAPS(b)", "@b: signed READ(WRAPS)"),
    ("public x() { @a = 1: READ(WRAPS(b)); @b = 2: READ(); }", "bad-wraps", "a wraps as b does, which is no signal", "WRAPS(b)", ""),
    ("public x() { @a = 1: READ(WRAPS(b)); @b = 2: signed READ(WRAPS); }", "bad-wraps", "a wraps as b does, which has other numbers", "WRAPS(b)", "one kind"),
    ("public x() { @a = 1: READ(WRAPS(7)); }", "bad-argument", "OF is the name of a signal", "7", ""),
    # Effects.
    ("public x() { @a = 1: bool WRITE(EFFECT=PULS); }", "bad-effect", "there is no effect 'PULS'", "EFFECT=PULS", "mean 'PULSE'?"),
    ("public x() { @a = 1: bool WRITE(EFFECT=SET); }", "bad-effect", "there is no effect 'SET'", "EFFECT=SET", "it is CLEAR_ON_READ, WRITE_1_TO_CLEAR or PULSE"),
    ("public x() { @a = 1: bool WRITE(EFFECT=1); }", "bad-argument", "EFFECT is CLEAR_ON_READ, WRITE_1_TO_CLEAR or PULSE", "1", ""),
    ("public x() { @a = 1: READWRITE(EFFECT=CLEAR_ON_READ); }", "bad-effect", "a signal with CLEAR_ON_READ is READ, not READWRITE", "EFFECT=CLEAR_ON_READ", ""),
    ("public x() { @a = 1: WRITE(EFFECT=WRITE_1_TO_CLEAR); }", "bad-effect", "a signal with WRITE_1_TO_CLEAR is READWRITE, not WRITE", "EFFECT=WRITE_1_TO_CLEAR", ""),
    ("public x() { @a = 1: bool READ(EFFECT=PULSE); }", "bad-effect", "a signal with PULSE is WRITE or READWRITE, not READ", "EFFECT=PULSE", ""),
    ("public x() { @a = 1: unsigned 2 WRITE(EFFECT=PULSE); }", "bad-effect", "a signal with PULSE is a bool, not unsigned 2", "EFFECT=PULSE", "several in a row are @name[8] = address[i]: bool"),
    ("public x() { @a = 1: signed 8 READ(EFFECT=CLEAR_ON_READ); }", "bad-effect", "a signal with CLEAR_ON_READ is bool or unsigned without SCALE, not signed 8", "EFFECT=CLEAR_ON_READ", ""),
    ("public x() { @a = 1: READ(SCALE=2, EFFECT=CLEAR_ON_READ); }", "bad-effect", "a signal with CLEAR_ON_READ is bool or unsigned without SCALE", "EFFECT=CLEAR_ON_READ", ""),
    ("public x() { @a = 1: unsigned 33 READ(EFFECT=CLEAR_ON_READ); }", "bad-effect", "a signal with CLEAR_ON_READ is within one word of 32 bits", "EFFECT=CLEAR_ON_READ", ""),
    ("public x() { @a = 1: READ(EFFECT=CLEAR_ON_READ, PUBLISH(1, 10)); }", "bad-effect", "no signal with CLEAR_ON_READ has PUBLISH", "PUBLISH(1, 10)", "each read clears it, that of a sample too"),
    ("public x() { @a = 1: READ(EFFECT=CLEAR_ON_READ, POLL(5)); }", "bad-effect", "no signal with CLEAR_ON_READ has POLL", "POLL(5)", "each read clears it"),
    ("group g; public x() { @a = 1: READ(EFFECT=CLEAR_ON_READ, GROUP(g)); }", "bad-effect", "no signal with CLEAR_ON_READ has GROUP", "GROUP(g)", "each read clears it"),
    ("public x() { @a = 1: READ(EFFECT=CLEAR_ON_READ, FIFO); }", "bad-effect", "no signal with CLEAR_ON_READ has FIFO", "FIFO", ""),
    ("public x() { @a = 1: bool WRITE(EFFECT=PULSE, RESET=true); }", "bad-effect", "no signal with PULSE has RESET", "RESET=true", "leave it out"),
    ("public x() { @a = 1: READWRITE(EFFECT=WRITE_1_TO_CLEAR, MAX=3); }", "bad-effect", "no signal with WRITE_1_TO_CLEAR has MAX", "MAX=3", "leave it out"),
    ("public x() { l: LEASE() @(0xC0, enable=none, estop=none); @a = 1: bool WRITE(EFFECT=PULSE, SAFE(true, l)); }", "bad-effect", "a pulse is 0 while its lease is not armed, too", "SAFE(true, l)", ""),
    ("public x() { @a = 1[0]: bool READWRITE(EFFECT=WRITE_1_TO_CLEAR); @b = 1[1]: bool READWRITE(); }", "bad-effect", "a write of b would clear a, which is written in the same word, at address 0x1", "1", "give each its own address"),
    ("public x() { @a = 1[7:0]: READ(EFFECT=CLEAR_ON_READ); @b = 1[8]: bool READ(); }", "overlap", "b takes bit 8 at address 0x1, which a has (the whole word, which each read clears)", "1", ""),
    ("public x() { @a = 1[7:0]: READ(EFFECT=CLEAR_ON_READ); @b = 1[8]: bool WRITE(); @c = 1[9]: bool WRITE(); }", "overlap", "b is one of several fields written at address 0x1, where reading clears a", "1", "move it to another address"),
    ("public x() { TOSNET(BASE=0, NODES=1) { @a = 1: READ(EFFECT=CLEAR_ON_READ); } }", "bad-effect", "a is in the memory of a TOSNET, where no signal can have an EFFECT", "1", ""),
    ("public x() { m: GIMBAL(); }", "unknown-component", "there is no component 'GIMBAL'", "GIMBAL", "one of your own is cores/gimbal/gimbal.ul beside the spec"),
    ("public x() { m: QUADRATURE(BASE=0); }", "unknown-component", "there is no component 'QUADRATURE'", "QUADRATURE", "it is the core ENCODER now, one for each channel"),
    # Cores and pins.
    ("public x() { m: PWM(WIDHT=8) @(0); }", "unknown-argument", "PWM has no argument 'WIDHT'", "WIDHT", "mean 'WIDTH'?"),
    ("public x() { m: GPIO(INVERT=1) @(0); }", "unknown-argument", "GPIO has no argument 'INVERT'", "INVERT", "it takes DEBOUNCE, GROUP, ON_EDGE and LEASE"),
    ("public x() { m: PWM() @(0, sclk=\"gp0\"); }", "unknown-argument", "PWM has no address or pin 'sclk'", "sclk", "it takes BASE, pwm and dir"),
    ("public x() { m: PWM() @(0x20); n: PWM() @(0x20 + 0); }", "overlap", "n.value takes bits 11:0 at address 0x20, which m.value has (bits 11:0)", "0x20 + 0", ""),
    ("public x() { n: GPIO() @(0x30); o: GPIO() @(0x31); }", "overlap", "o.level takes bit 0 at address 0x31, which n.last has (bits 31:0)", "0x31", ""),
    ("public x() { d: LEASE() @(0xF0); }", "address-range", "the address 0x100 of d.armed is not the gateway's", "0xF0", "GATEWAY"),
    ("public x() { m: PWM() @(0, pmw=\"gp0\"); }", "unknown-argument", "PWM has no address or pin 'pmw'", "pmw", "mean 'pwm'?"),
    ("public x() { m: PWM() @(0, pwm=3); }", "bad-pin", "pwm is a pin of PWM, and takes the name of a pin of the board, not the number 3", "3", 'as in pwm="led0"'),
    ("public x() { m: PWM() @(0, \"gp0\"); }", "address-count", "PWM takes 1 address (BASE), and 2 are given", '0, "gp0"', ""),
    ("public x() { m: PWM(BASE=1) @(2); }", "address-count", "PWM takes 1 address (BASE), and 2 are given", "BASE=1) @(2", ""),
    ("public x() { m: PWM() @(0) { @a = 1: READ(); } }", "misplaced", "only a hardware module has members here, and PWM is none", "PWM", ""),
    ("public x() { m: c() @(0); }\nc(): @(at) { @a = at: READ(); @p: PIN(OUT); }", "bad-entity", "p is a port of no entity: c has no ENTITY", "p", 'as in ENTITY("ul_pwm", width=WIDTH);'),
    ("public x() { m: c() @(0); }\nc(): @(at) { ENTITY(blink); @a = at: READ(); }", "bad-entity", "ENTITY begins with the name of an entity in VHDL", "blink", 'as in ENTITY("ul_pwm", width=WIDTH);'),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("a b"); @a = at: READ(); }', "bad-entity", "ENTITY begins with the name of an entity in VHDL", '"a b"', ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b", TOCK); @a = at: READ(); }', "unknown-argument", "ENTITY takes the words TICK, TIME, ARMED, STAGE and EMPTY, and generics by their names", "TOCK", "mean 'TICK'?"),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b", n=0.5); @a = at: READ(); }', "bad-entity", "n is the number 0.5, and a generic is a whole number of 32 bits, a truth or a string", "0.5", ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b", n_=1); @a = at: READ(); }', "bad-entity", "'n_' cannot be the name of a generic in VHDL", "n_", ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b", axes=1); @a = at: READ(); }', "argument-twice", "axes is given by the design", "axes=1", ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); ENTITY("d"); @a = at: READ(); }', "name-twice", "this component has two ENTITY statements", "ENTITY", ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); @a = at: READ(FIFO); }', "bad-entity", "a component with an ENTITY has signals, pins and triggers, and no FIFO port, part or module", "ENTITY", ""),
    ('public x() { ENTITY("b"); @a = 1: READ(); }', "misplaced", "an interface is the whole design, and ENTITY belongs in a component of it", "ENTITY", ""),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); @a = at: READ(); @p = 3: PIN(OUT); }', "misplaced", "p is a pin, which has neither an address nor a kind", "p", "as in @p: PIN(...);"),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); @a = at: READ(); @p: PIN(OOT); }', "bad-pin", "a pin is IN, OUT or INOUT, not OOT", "PIN", "mean 'OUT'?"),
    ('public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); @a = at: READ(); @p_: PIN(OUT); }', "bad-pin", "'p_' cannot be the name of a port in VHDL", "p_", ""),
    ('group g(RATE=10); public x() { m: c() @(0); }\nc(): @(at) { ENTITY("b"); @a = at: READ(PUBLISH(g)); @t: TRIGGER(g); }', "group-trigger", "a core triggers the group g, which is not published on its trigger", "g", "declare it so: group g(TRIGGER);"),
    ("public x() { @a = 1: bool READWRITE(PIN=3); }", "bad-argument", "PIN is a string, not the number 3", "3", ""),
    ('public x() { @a = 1: unsigned 40 READWRITE(PIN="led"); }', "bad-pin", "a has several words, and a register at pins is one", 'PIN="led"', ""),
    ('public x() { @a = 1: READWRITE(PIN="led", FIFO); }', "bad-pin", "a FIFO port hands out words, and cannot be at pins", 'PIN="led"', ""),
    # Values after a reset.
    ("public x() { @a = 1: READ(RESET=3); }", "bad-reset", "RESET is the value of a register before its first write, and this signal is only read", "RESET=3", "leave it out"),
    ("public x() { @a = 1: WRITE(RESET=3, FIFO); }", "bad-reset", "RESET is the value of a register before its first write, and this signal is a FIFO port", "RESET=3", "leave it out"),
    ("public x() { @a = 1: unsigned 4 WRITE(RESET=16); }", "bad-reset", "RESET: 16 is outside of", "RESET=16", ""),
    ("public x() { @a = 1: WRITE(MIN=1, MAX=5, RESET=6); }", "bad-reset", "RESET is 6, outside of the signal's limits, 1 to 5", "RESET=6", ""),
    # Schedules.
    ("public x() { p: SCHEDULE() @(0x80); @a = 1: READ(TIMED(p)); }" + PLAN, "bad-timed", "TIMED is for a register that is written at an instant, and this signal is only read", "TIMED(p)", "leave it out"),
    ("public x() { p: SCHEDULE() @(0x80); @a = 1: WRITE(FIFO, TIMED(p)); }" + PLAN, "bad-timed", "TIMED is for a register that is written at an instant, and this signal is a FIFO port", "TIMED(p)", "leave it out"),
    ("public x() { p: SCHEDULE() @(0x80); @a = 1[7:0]: WRITE(TIMED(p)); @b = 1[15:8]: WRITE(); }" + PLAN, "bad-timed", "a is timed, and b is written in the same word, at address 0x1", "TIMED(p)", "give each its own address"),
    ("public x() { p: SCHEDULE() @(0x80); @b = 1[15:8]: WRITE(); @a = 1[7:0]: WRITE(TIMED(p)); @c = 1[31:16]: READ(); }" + PLAN, "bad-timed", "a is timed, and b is written in the same word, at address 0x1", "TIMED(p)", "give each its own address"),
    ("public x() { d: LEASE() @(0x80); e: LEASE() @(0xA0); p: SCHEDULE() @(0xC0); @a = 1: WRITE(SAFE(0, d), TIMED(p)); @b = 2: WRITE(TIMED(p)); @c = 3: WRITE(SAFE(0, e), TIMED(p)); }" + PLAN, "bad-timed", "a and c are timed by p, and guarded by d and e: a schedule has one lease", "TIMED(p)", "give each lease a SCHEDULE of its own"),
    ("public x() { GATEWAY(DATA_BITS=16); p: SCHEDULE() @(0x80); }" + PLAN, "bad-timed", "p takes words of 32 bits, and the gateway has 16", "SCHEDULE", "as in GATEWAY(DATA_BITS=32);"),
    ("public x() { p: SCHEDULE() @(0x80); pool: MEMORY(BASE=0x20, SIZE=8) { @a = 1: WRITE(TIMED(p)); } }" + PLAN, "bad-timed", "a is a register of the module around it, which no schedule can write", "TIMED(p)", "leave it out"),
    ("public x() { p: SCHEDULE() @(0x80); @a = 1: WRITE(TIMED(p)); }\nSCHEDULE(): @(b) { @entry = b: WRITE(); }", "bad-timed", "a is timed by p, whose ENTITY has no STAGE", "TIMED(p)", ""),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(TIMED(d)); }", "bad-argument", "SCHEDULE is the name of a SCHEDULE of the interface, not the lease 'd'", "d", ""),
    ("public x() { p: SCHEDULE() @(0x80); @a = 1: WRITE(SAFE(0, p)); }" + PLAN, "bad-argument", "LEASE is the name of a LEASE of the interface, not the schedule 'p'", "p", ""),
    ("public x() { @a = 1: WRITE(TIMED(plan)); }", "unknown-name", "nothing is called 'plan' here", "plan", ""),
    ("public x() { @a = 1: WRITE(TIMED()); }", "argument-missing", "TIMED needs SCHEDULE, the name of a SCHEDULE of the interface", "TIMED()", ""),
    # Leases.
    ("public x() { d: LEASE() @(0x80); @a = 1: READ(SAFE(0, d)); }", "bad-safe", "SAFE is the value of a register before its first write, and this signal is only read", "SAFE(0, d)", "leave it out"),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(MIN=1, SAFE(0, d)); }", "bad-safe", "SAFE is 0, outside of the signal's limits, 1 to ...", "SAFE(0, d)", ""),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(RESET=1, SAFE(0, d)); }", "bad-reset", "a signal with SAFE begins with its safe value, and has no RESET", "RESET=1", "leave out RESET"),
    ("public x() { d: LEASE() @(0x80); @a = 1: READ(SAFE(HOLD, d)); }", "bad-safe", "SAFE is the value of a register before its first write, and this signal is only read", "SAFE(HOLD, d)", "leave it out"),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(SAFE(HOLD, d)); }", "bad-safe", "a keeps its value when the lease ends, and no core stops then", "a", "HOLD needs a component whose ENTITY has the input ARMED; elsewhere name a safe value"),
    ('public x() { d: LEASE() @(0x80); m: c(d) @(0); }\nc(D): @(at) { @a = at: WRITE(SAFE(HOLD, D)); ENTITY("b", TICK); }', "bad-safe", "a keeps its value when the lease ends, and no core stops then", "a", "HOLD needs a component whose ENTITY has the input ARMED; elsewhere name a safe value"),
    ("public x() { d: LEASE() @(0x80); @a = 1[7:0]: WRITE(SAFE(0, d)); @b = 1[15:8]: WRITE(); }", "bad-safe", "a and b are written together at address 0x1, and one is guarded by d, the other by none", "1", "give each its own address, or both one lease"),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(SAFE(0, b)); }", "unknown-name", "nothing is called 'b' here", "b", ""),
    ("group g(RATE=10); public x() { @a = 1: WRITE(SAFE(0, g)); @b = 2: READ(PUBLISH(g)); }", "bad-argument", "LEASE is the name of a LEASE of the interface, not the group 'g'", "g", ""),
    ("public x() { d: LEASE() @(0x80); @a = 1: WRITE(SAFE(0)); }", "argument-missing", "SAFE needs LEASE, the name of a LEASE of the interface", "SAFE(0)", ""),
    ('public x() { d: LEASE() @(0x80); e: LEASE() @(0xA0); m: c(d, e) @(0); }\nc(D, E): @(at) { ENTITY("b"); @a = at: WRITE(SAFE(0, D)); @z = at + 1: WRITE(SAFE(0, E)); }', "bad-safe", "the signals of an entity are guarded by one lease, not by d and e", "ENTITY", ""),
    ("public x() { @a = 1: mode 8 WRITE(RESET=of); }" + MODE, "bad-reset", "RESET: 'of' is no value of mode", "RESET=of", ""),
    ("public x() { @q = 1: unsigned 8 READ(FIFO); @b = 1[15:8]: WRITE(); @c = 1[23:16]: WRITE(); }", "overlap", "b is one of several fields written at address 0x1, where reading takes a word from q", "1", "move it to another address"),
    ("public x() { @q = 1: unsigned 8 READ(FIFO); @b = 1[15:8]: READWRITE(); }", "overlap", "b takes bits 15:8 at address 0x1, which q has (the whole word, as a FIFO port)", "1", ""),
    ("public x() { @q = 1: unsigned 8 WRITE(FIFO); @b = 1[15:8]: WRITE(); }", "overlap", "b takes bits 15:8 at address 0x1, which q has (the whole word, as a FIFO port)", "1", ""),
    ("public x() { m: MEMORY(SIZE=4); n: MEMORY(BASE=2, SIZE=4); }", "overlap", "MEMORY at 0x2 lies in MEMORY at 0x0 to 0x3", "MEMORY", ""),
    # Bits and kinds.
    ("public x() { @a = 1[32]: bool READ(); }", "bad-bits", "bit 32 is not in a word of 32 bits", "32", "bits are 0 to 31"),
    ("public x() { @a = 1[0:3]: READ(); }", "bad-bits", "bits 0:3 run upwards", "0:3", "write [3:0], the highest first"),
    ('public x() { @a = 1["b"]: READ(); }', "bad-bits", "a bit is a whole number, not the string \"b\"", '"b"', ""),
    ("public x() { @a = 1: usigned READ(); }", "unknown-kind", "there is no kind 'usigned'", "usigned", "mean 'unsigned'"),
    ("public x() { @a = 1: complex READ(); }", "unknown-kind", "there is no kind 'complex'", "complex", "kinds are bool, unsigned"),
    ("public x() { @a = 1: signed 65 READ(); }", "bad-width", "a width is 1 to 64 bits, not 65", "65", ""),
    ("public x() { @a = 1: signed wide READ(); }", "unknown-name", "nothing is called 'wide' here", "wide", ""),
    ("public x(wide=65) { @a = 1: signed wide READ(); }", "bad-width", "a width is 1 to 64 bits, not the number 65", "wide", ""),
    ("public x(wide=true) { @a = 1: signed wide READ(); }", "bad-width", "a width is 1 to 64 bits, not true", "wide", ""),
    ("public x(wide=8) { @a = 1: fixed wide READ(); }", "bad-width", "fixed needs the bits before and after the point", "wide", "as in fixed 16.16"),
    ("public x() { @a = 1: signed 1.5 READ(); }", "bad-width", "a width is 1 to 64 bits, not 1.5", "1.5", ""),
    ("public x() { @a = 1: float 24 READ(); }", "bad-width", "a float has 16, 32 or 64 bits, not 24", "float", ""),
    ("public x() { @a = 1: bool 2 READ(); }", "bad-width", "a bool is 1 bit, not 2", "bool", "use unsigned"),
    ("public x() { @a = 1: fixed READ(); }", "bad-width", "fixed needs the bits before and after the point", "fixed", "as in fixed 16.16"),
    ("public x() { @a = 1: fixed 60.5 READ(); }", "bad-width", "a fixed has 1 to 64 bits, not 65", "60.5", ""),
    ("public x() { @a = 1[7:0]: unsigned 12 READ(); }", "bad-width", "unsigned 12 does not fit into the 8 bits that 'a' has", "unsigned", "12 bits from bit 0 on are [11:0]"),
    ("public x() { @a = 1[1:0]: bool READ(); }", "bad-width", "a bool is 1 bit, and 'a' has 2", "bool", ""),
    ("public x() { @a = 1[1:0]: mode READ(); }" + MODE, "enum-too-wide", "mode has values up to 5, which need 3 bits, not 2", "mode", ""),
    ("public x() { @a = 1: fixed 32.32 READ(); }", "inexact", "a float cannot represent all values of fixed 32.32", "a", "it has 53 bits"),
    ("public x() { @a = 1: READ(SCALE=1e-9, OFFSET=1e9); }", "inexact", "a float cannot represent", "SCALE=1e-9", ""),
    ("public x() {}\nenum e { a, b = 0 }", "bad-enum", "'b' and 'a' are both 0", "b = 0", ""),
    ("public x() {}\nenum e { a, a }", "bad-enum", "'a' is declared twice in e", "a", ""),
    ("public x() {}\nenum e { a = -1 }", "bad-enum", "the value of 'a' is a whole number from 0 on, not the number -1", "a = -1", ""),
    ("public x() {}\nenum e { mro }", "bad-enum", "'mro' cannot be the name of a value", "mro", ""),
    ("public x() {}\nenum e { }", "bad-enum", "e has no values", "e", ""),
    # Access and arguments.
    ("public x() { @a = 1: REED(); }", "unknown-access", "there is no access 'REED'", "REED", "mean 'READ'"),
    ("public x() { @a = 1: READ(id=\"b\"); }", "unknown-argument", "READ has no argument 'id'", "id", "mean 'ID'?"),
    ("public x() { @a = 1: READ(CRC); }", "unknown-argument", "READ has no argument 'CRC'", "CRC", "every message of a program is checked"),
    ("public x() { @a = 1: READ(PUBLSH(1, 2)); }", "unknown-argument", "READ has no argument 'PUBLSH'", "PUBLSH", "mean 'PUBLISH'?"),
    ("public x() { @a = 1: READ(5); }", "too-many-arguments", "READ has no place for this argument", "5", "name it, as in ID=..."),
    ("public x() { @a = 1: READ(PUBLISH(1, 2, 3)); }", "too-many-arguments", "PUBLISH has no place for this argument", "3", ""),
    ("public x() { @a = 1: READ(PUBLISH()); }", "argument-missing", "PUBLISH needs GROUP", "PUBLISH()", ""),
    ("public x() { @a = 1: READ(ID=\"b\", ID=\"c\"); }", "argument-twice", "ID is given twice", 'ID="c"', ""),
    ("public x() { @a = 1: READ(ID=5); }", "bad-argument", "ID is a string, not the number 5", "5", ""),
    ("public x() { @a = 1: READ(PUBLISH=5); }", "bad-argument", "PUBLISH takes parentheses: PUBLISH(group, divisor)", "PUBLISH=5", ""),
    ("public x() { @a = 1: READ(PUBLISH(\"b\", 1)); }", "bad-argument", "GROUP is a group's number or name, not the string \"b\"", '"b"', ""),
    ("public x() {}\ngroup g(1, 1, TRIGGER=1);", "bad-argument", "TRIGGER is true or false, not the number 1", "1", ""),
    ("public x() {}\ngroup g(1, 1, TRIGGER(1));", "bad-argument", "TRIGGER takes no parentheses: write it alone", "TRIGGER(1)", ""),
    ("public x() { n: TOSNET_NODE(NODE=none); }", "argument-missing", "TOSNET_NODE needs NODE", "TOSNET_NODE", ""),
    ("public x() { j: joint(none) @(1, 2); }" + JOINT, "argument-count", "joint takes 1 argument (name), and 1 is given", "none", "name is missing"),
    ("public x(a=none) {}", "bad-argument", "the parameter of a public interface cannot be none", "a=none", ""),
    ("public x() { @a = none: READ(); }", "bad-address", "an address is a whole number, not none", "none", ""),
    ("public x() { @a = 1 + none: READ(); }", "bad-operand", "'+' takes numbers, not none", "1 + none", ""),
    ("public x() { @a = 1[none]: READ(); }", "bad-bits", "a bit is a whole number, not none", "none", ""),
    ("public x() { a[none]: j(); }\nj() {}", "bad-size", "the size of an array is a whole number from 1 to 65536, not none", "none", ""),
    ("public x() { j: j(none); }\nj(none) {}", "name-taken", "'none' is a constant, and cannot be a parameter", "none", ""),
    ("public x(a) { @b = a: READ(); }", "bad-address", "an address is a whole number, not the parameter 'a', whose value is given only when", "a", ""),
    ("public x() { j: joint(\"a\", 1) @(1, 2); }" + JOINT, "argument-count", "joint takes 1 argument (name), and 2 are given", '"a", 1', ""),
    ("public x() { j: joint(\"a\") @(1); }" + JOINT, "address-count", "joint takes 2 addresses (pos, vel), and 1 is given", "1", "vel is missing"),
    ("public x() { j: joint(\"a\") @(1, 2, 3); }" + JOINT, "address-count", "joint takes 2 addresses (pos, vel), and 3 are given", "1, 2, 3", ""),
    ("public x() { j: joint(nam=\"a\") @(1, 2); }" + JOINT, "unknown-argument", "joint has no argument 'nam'", "nam", "mean 'name'?"),
    ("public x() { j[0]: joint(\"a\") @(1, 2); }" + JOINT, "bad-size", "the size of an array is a whole number from 1 to 65536, not the number 0", "0", ""),
    # Scale, limits, FIFO.
    ("public x() { @a = 1: READ(SCALE=0); }", "bad-scale", "SCALE is 0, so that every value would be the same", "SCALE=0", ""),
    ("public x() { @a = 1: bool READ(SCALE=2); }", "bad-scale", "no bool has SCALE", "SCALE=2", "signed, unsigned and fixed"),
    ("public x() { @a = 1: float READ(OFFSET=2); }", "bad-scale", "no float has OFFSET", "OFFSET=2", ""),
    ("public x() { @a = 1: WRITE(MIN=3, MAX=2); }", "bad-limit", "MIN=3 is more than MAX=2", "MIN=3", "exchange them"),
    ("public x() { @a = 1: unsigned 8 WRITE(MIN=0.2, MAX=0.8); }", "bad-limit", "there is no whole number from MIN=0.2 to MAX=0.8, and unsigned 8 has no others", "MIN=0.2", "a SCALE makes steps smaller than 1"),
    ("public x() { @a = 1: unsigned 8 WRITE(MAX=300); }", "bad-limit", "MAX=300 is outside of 0 to 255, the range of unsigned 8", "MAX=300", ""),
    ("public x() { @a = 1: READ(MAX=300); }", "bad-limit", "MAX limits what is written, and this signal is only read", "MAX=300", ""),
    ("public x() { @a = 1: bool WRITE(MAX=1); }", "bad-limit", "no bool has MAX", "MAX=1", ""),
    ("public x() { @a = 1[3:0]: READ(FIFO); }", "bad-fifo", "a FIFO hands out whole words", "FIFO", ""),
    ("public x() { @a = 1: unsigned 64 READ(FIFO); }", "bad-fifo", "a FIFO hands out words of 32 bits, and unsigned 64 has 64", "FIFO", ""),
    ("public x() { @a = 1: READ(FIFO, PUBLISH(1, 1)); }", "bad-fifo", "a is the port of a FIFO, and the group group_1 is not published on its trigger", "a", "group NAME(TRIGGER)"),
    ("group g(1, 1, TRIGGER); public x() { @a = 1: READ(FIFO, PUBLISH(g)); }", "bad-fifo", "is not published on its trigger", "a", ""),
    ("group g(TRIGGER, ON_CHANGE); public x() { @a = 1: READ(FIFO, PUBLISH(g)); }", "bad-fifo", "leaves out words that are the same", "a", "leave out ON_CHANGE"),
    # Publishing and groups.
    ("public x() { @a = 1: WRITE(PUBLISH(1, 1)); }", "not-readable", "PUBLISH needs a signal that can be read, not WRITE", "PUBLISH(1, 1)", ""),
    ("public x() { @a = 1: WRITE(POLL(1)); }", "not-readable", "POLL needs a signal that can be read, not WRITE", "POLL(1)", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); @b = 2: WRITE(GROUP(g)); }\ngroup g(1, 10);", "not-readable", "b can only be written, and the group g is published", "b", "group NAME; and GROUP(NAME)"),
    ("public x() { @a = 1: READ(PUBLISH(1, 1)); @b = 2: WRITE(GROUP(1)); }", "not-readable", "b can only be written, and the group group_1 is published", "b", ""),
    ("public x() { @a = 1: READ(POLL(1), PUBLISH(1, 1)); }", "publish-and-poll", "either published by the gateway or polled", "POLL(1)", ""),
    ("public x() { @a = 1: READ(POLL(0)); }", "out-of-range", "RATE is 0, and 1e-06 to 1000000000 is expected", "0", ""),
    ("public x() { @a = 1: READ(PUBLISH(256, 1)); }", "out-of-range", "GROUP is 256, and 0 to 255 is expected", "256", ""),
    ("public x() { @a = 1: READ(PUBLISH(1, 0)); }", "out-of-range", "DIVISOR is 0, and 1 to 65535 is expected", "0", ""),
    ("public x() { @a = 1: READ(PUBLISH(1, 65536)); }", "out-of-range", "DIVISOR is 65536", "65536", ""),
    ("public x() { @a = 1: READ(PUBLISH(1, 2)); @b = 2: READ(PUBLISH(1, 3)); }", "group-divisor", "the group group_1 is published with divisor 2, and here with 3", "3", "into another group"),
    ("public x() { @a = 1: READ(PUBLISH(g, 3)); }\ngroup g(RATE=10);", "group-divisor", "the group g has a rate, and cannot have a divisor too", "3", ""),
    ("public x() {}\ngroup g(DIVISOR=1, RATE=10);", "group-rate", "a group has a DIVISOR or a RATE, not both", "RATE=10", ""),
    ("public x() { @a = 1: READ(PUBLISH(1)); }", "group-rate", "nothing says when the group group_1 is published", "a", "give a divisor"),
    ("public x() { @a = 1: READ(PUBLISH(g)); @b = 2: READ(PUBLISH(h)); }\ngroup g(1, 1);\ngroup h(1, 2);", "group-number", "the groups g and h both have number 1", "h", ""),
    ("public x() { GATEWAY(ADDRESS_BITS=9); a[256]: c() @(i); }\nc(): @(v) { @v: READ(PUBLISH(1, 1)); }", "group-size", "the group group_1 has 256 words, and a gateway publishes at most 255", "v", "divide it"),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, JOINTS(POSITION=b));", "joints", "no signal of the group g is called 'b'", "g", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); @b = 2: READ(); }\ngroup g(1, 1, JOINTS(POSITION=a, SET_POSITION=b));", "joints", "no signal of its joints that can be written is called 'b'", "g", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, IMU(ORIENTATION=b));", "sensors", "no signal of the group g is called 'b'", "g", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, IMU(ORIENTATION=a));", "sensors", "a is a row of 1, and ORIENTATION of IMU needs 4", "g", "declare a row, as in @a[4] = base + i: ..."),
    ("public x() { @a[2] = 1 + i: READ(PUBLISH(g)); }\ngroup g(1, 1, BATTERY(VOLTAGE=a));", "sensors", "a is a row of 2, and VOLTAGE of BATTERY needs 1", "g", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, RANGEFINDER(INFRARED));", "sensors", "RANGEFINDER needs the name of a signal", "g", "as in RANGEFINDER(DISTANCE=name)"),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, RANGEFINDER(DISTANCE=a, FIELD_OF_VIEW=7));", "out-of-range", "FIELD_OF_VIEW is 7, and 0 to 6.28318530718 is expected", "7", ""),
    ("public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 1, JOINTS);", "joints", "JOINTS needs the name of a signal", "g", "JOINTS(POSITION=cpos"),
    # The interface as a whole.
    ('public x() { @a = 1: READ(ID="b"); @b = 2: READ(); }', "id-twice", "the ID 'b' is that of a and of b", "b", ""),
    ("public x() { a: c(); }\nc() { b: d(); }\nd() { c: c(); }", "recursion", "c contains itself: c -> d -> c", "c", ""),
    ("public x() {}\nc() { c: c(); }", "recursion", "c contains itself: c -> c", "c", ""),
    ("public x() { a: y(); }\npublic y() {}", "public-part", "y is a public interface, and cannot be part", "y", ""),
    ("public x(): @(a) {}", "public-addresses", "a public interface is not put anywhere", "x", ""),
    ("public x() { TOSNET(); MEMORY(); }", "two-modules", "TOSNET is the module of this interface already", "MEMORY", "give it a name, or a block"),
    ("public x() { c: c(); }\nc() { MEMORY(); }", "misplaced", "this MEMORY has neither a name nor members", "MEMORY", ""),
    ("public x() { c: c(); }\nc() { GATEWAY(); }", "misplaced", "GATEWAY belongs in a public interface", "GATEWAY", ""),
    ("public x() { c: c() { @a = 1: READ(); } }\nc() {}", "misplaced", "only a hardware module has members here, and c is none", "c", ""),
    ("public x() { GATEWAY(); GATEWAY(); }", "name-twice", "this interface has two GATEWAY statements", "GATEWAY", ""),
    ("public x() { m: MEMORY() @(1); }", "module-address", "the address of MEMORY is its BASE", "MEMORY", "as in BASE=0x40"),
    ("public x() { n: TOSNET_NODE(); }", "argument-missing", "TOSNET_NODE needs NODE", "TOSNET_NODE", ""),
    ("public x() { GATEWAY(DATA_BITS=65); }", "out-of-range", "DATA_BITS is 65, and 8 to 64 is expected", "65", ""),
    ("public x() { a[300]: c(); }\nc() { b[400]: d(); }\nd() {}", "too-many", "an interface of more than 100,000 signals and components is too large", "b[400]: d();", ""),
    ('import "nowhere.ul";\npublic x() {}', "import", "nowhere.ul cannot be read: No such file or directory", '"nowhere.ul"', "relative to the folder"),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "code", "message", "place", "advice"),
    CASES,
    ids=[f"{case[1]}-{number}" for number, case in enumerate(CASES)],
)
def test_a_fault_is_reported_with_its_position_and_advice(
    text: str, code: str, message: str, place: str, advice: str
) -> None:
    found = next((one for one in faults(text) if one.code == code), None)
    assert found is not None, SpecError(faults(text))
    assert message in found.message
    assert advice in found.help
    assert underlined(text, found) == place


def test_every_rule_has_a_case() -> None:
    sources = "".join(path.read_text() for path in (Path(__file__).parents[2] / "unity_link/spec").glob("*.py"))
    rules = set(re.findall(r'"([a-z]+(?:-[a-z]+)+|syntax|overlap|recursion|inexact|misplaced|import|joints)"', sources))
    rules -= {"utf-8", "utf-8-sig", "no-value-type"}
    tested = {code for _, code, *_ in CASES}
    elsewhere = {"core-twice", "no-lease", "import-cycle", "gateway-width", "no-interface", "too-long", "unreadable"}
    assert rules - tested - elsewhere == set()


def test_all_faults_are_reported_at_once_in_the_order_of_the_source() -> None:
    text = "public x() {\n  @a = 1: REED();\n  j: joit();\n  @b = 1: READ(SCALE=0);\n  @c = 0x100: READ();\n}\n"
    found = faults(text)
    assert [(one.span.line, one.code) for one in found] == [
        (2, "unknown-access"), (3, "unknown-component"), (4, "bad-scale"), (5, "address-range"),
    ]  # fmt: skip


def test_several_faults_of_syntax_are_reported_at_once() -> None:
    text = (
        'public x( {\n  @a: READ(ID=1)\n  @b: READ(ID="x);\n  @c READ();\n  j: joint(1 @(2);\n  @d = 1: READ();\n}\n'
        "y() {\n  @e = ;\n  k: c()\n}\nenum m { a b }\nz() { @f = 2: READ(; }\n"
    )
    assert [one.span.line for one in faults(text)] == [1, 2, 3, 4, 5, 9, 10, 12, 13]


def test_a_fault_of_a_component_with_many_uses_is_reported_once() -> None:
    text = "public x() { a[50]: c() @(i); }\nc(): @(v) { @v: REED(); }"
    assert [one.code for one in faults(text)] == ["unknown-access"]


def test_consequences_of_a_fault_are_not_reported() -> None:
    text = "public x() { j: joint(nothing) @(nowhere, 1); }" + JOINT
    assert [one.message for one in faults(text)] == [
        "nothing is called 'nothing' here",
        "nothing is called 'nowhere' here",
    ]


@pytest.mark.parametrize(
    "text",
    [
        "public x() { @a = 1: READ(PUBLISH(1, 0)); }",
        "public x() { @a = 1: READ(PUBLISH(1, 70000)); }",
        "public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(1, 0);",
        "public x() { @a = 1: READ(PUBLISH(g)); }\ngroup g(RATE=0);",
    ],
)
def test_a_refused_divisor_or_rate_is_the_only_fault_of_its_group(text: str) -> None:
    assert [one.code for one in faults(text)] == ["out-of-range"]


def test_an_unused_component_is_checked_too() -> None:
    assert [one.code for one in faults("public x() {}\nc(n): @(v) { @v: REED(ID=n, UNIT=m); }")] == ["unknown-access"]


def test_a_diagnostic_shows_file_line_column_the_line_and_the_other_place() -> None:
    text = "public x() {\n\t@a = 0x10: READ();\n\t@b = 0x10: READ();\n}\n"
    (found,) = faults(text)
    assert found.render() == (
        "robot.ul:3:7: error: b takes bits 31:0 at address 0x10, which a has (bits 31:0)\n"
        "    3 | \t@b = 0x10: READ();\n"
        "      | \t     ^^^^\n"
        "robot.ul:2:7: note: the address of a is given here\n"
        "    2 | \t@a = 0x10: READ();\n"
        "      | \t     ^^^^"
    )


def test_advice_is_below_the_line() -> None:
    error = SpecError(faults("public x() { @a = 1: REED(); }"))
    assert str(error) == (
        "robot.ul:1:22: error: there is no access 'REED'\n"
        "    1 | public x() { @a = 1: REED(); }\n"
        "      |                      ^^^^\n"
        "  help: did you mean 'READ'?\n"
        "1 error"
    )


def test_a_very_long_line_is_cut_around_the_place() -> None:
    (found,) = faults("public x() { " + "@a = 1: READ(); " * 0 + " " * 5000 + "@b = 1: REED();" + " " * 5000 + "}")
    assert all(len(line) < 200 for line in found.render().splitlines())
    assert "@b = 1: REED();" in found.render()
    shown = found.render().splitlines()[1]
    assert shown.startswith("    1 | ... ")
    assert shown.endswith(" ...")


def test_the_number_of_diagnostics_shown_is_limited() -> None:
    text = "public x() {\n" + "".join(f"@a{number} = 1: REED();\n" for number in range(300)) + "}"
    error = SpecError(faults(text))
    assert len(error.diagnostics) == 300
    assert str(error).count("unknown") == 0
    assert str(error).count("error: there is no access") == 100
    assert str(error).endswith("300 errors, the first 100 of which are shown")


def test_files_that_import_each_other_are_reported(tmp_path: Path) -> None:
    (tmp_path / "a.ul").write_text('import "b.ul";\npublic x() {}')
    (tmp_path / "b.ul").write_text('import "a.ul";\nc() {}')
    with pytest.raises(SpecError) as caught:
        compile_file(tmp_path / "a.ul")
    (found,) = caught.value.diagnostics
    assert found.message == "files import each other in a circle: a.ul -> b.ul -> a.ul"
    assert found.span.file == str(tmp_path / "b.ul")


@pytest.mark.parametrize("name", ["/dev/zero", "pipe"])
def test_an_import_of_a_device_or_a_pipe_is_refused(name: str, tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "a.ul").write_text(f'import "{name}";\npublic x() {{}}')
    with pytest.raises(SpecError) as caught:
        compile_file(tmp_path / "a.ul")
    (found,) = caught.value.diagnostics
    assert (found.code, found.message) == ("import", f"{tmp_path / name} is no regular file")


def test_a_file_longer_than_any_spec_is_not_read_to_its_end(tmp_path: Path) -> None:
    (tmp_path / "long.ul").write_bytes(b" " * (MOST_CHARACTERS + 1))
    (tmp_path / "a.ul").write_text('import "long.ul";\npublic x() {}')
    for name in ("/dev/zero", str(tmp_path / "a.ul")):
        with pytest.raises(SpecError, match="is too long for a spec: 16,777,216 bytes are the most"):
            compile_file(name)


def test_a_fault_in_an_imported_file_is_reported_there(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    (tmp_path / "a.ul").write_text('import "lib/c.ul";\npublic x() { c: c() @(1); }')
    (tmp_path / "lib" / "c.ul").write_text("\nc(): @(v) { @v: REED(); }")
    with pytest.raises(SpecError) as caught:
        compile_file(tmp_path / "a.ul")
    (found,) = caught.value.diagnostics
    assert (found.span.file, found.span.line) == (str(tmp_path / "lib" / "c.ul"), 2)


def test_a_file_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.ul").write_bytes(b"public \xff")
    with pytest.raises(SpecError, match=r"a\.ul is no UTF-8 text: byte 7 is 0xFF"):
        compile_file(tmp_path / "a.ul")
    with pytest.raises(SpecError, match="cannot be read: Is a directory"):
        compile_file(tmp_path)


def test_widths_that_the_gateway_does_not_have_are_reported() -> None:
    (found,) = faults("public x() { GATEWAY(ADDRESS_BITS=12); }", address_bits=8)
    assert found.code == "gateway-width"
    assert found.message == "ADDRESS_BITS is 12 here, and the gateway's is 8"


def test_a_file_without_a_public_interface_causes_a_warning() -> None:
    (found,) = compile_text("c() {}", "c.ul").warnings
    assert found.render() == (
        "c.ul: warning: nothing in this file is public\n  help: mark the outermost component with 'public'"
    )


def test_suggestions_are_names_that_look_alike() -> None:
    assert did_you_mean("publish", ["PUBLISH", "POLL"]) == "did you mean 'PUBLISH'?"
    assert did_you_mean("xyz", ["PUBLISH"]) == ""
