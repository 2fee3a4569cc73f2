"""Random VHDL expressions of signed and unsigned vectors and of integers, which simulate without bound errors.

Each integer expression comes with the range of its values, so that no sum overflows and no conversion is out of range.
Expressions that GHDL refuses with an error are not made: rotations of one bit or of `signed`, and `abs` of integers.
"""

from __future__ import annotations

import random
from typing import NamedTuple

HEAD = "library ieee;\nuse ieee.std_logic_1164.all;\nuse ieee.numeric_std.all;\n"
WIDTHS = (2, 3, 4, 5, 7, 8, 8, 8, 9, 12, 16, 17, 31, 32, 33, 40)
INTEGER_BITS = 32
OPERATORS = {"=", "/=", "<", "<=", ">", ">="}
DEPTH = 3
Range = tuple[int, int]


class Expression(NamedTuple):
    """An output, and the expression that drives it."""

    name: str
    width: int
    text: str


class Entity(NamedTuple):
    """An entity with one output for each expression."""

    name: str
    inputs: dict[str, tuple[str, int]]
    """Type and width of each input, by its name."""
    outputs: list[Expression]

    def text(self) -> str:
        """Return the VHDL of the entity."""
        ports = [f"i_{name} : in std_logic_vector({width - 1} downto 0)" for name, (_, width) in self.inputs.items()]
        ports += [f"{one.name} : out std_logic_vector({one.width - 1} downto 0)" for one in self.outputs]
        choices = "".join(
            f"  function choose(c : boolean; a, b : {kind}) return {kind} is\n"
            "  begin if c then return a; else return b; end if; end function;\n"
            for kind in ("signed", "unsigned", "integer")
        )
        signals = "".join(
            f"  signal {name} : {kind}({size - 1} downto 0);\n" for name, (kind, size) in self.inputs.items()
        )
        given = "".join(f"  {name} <= {kind}(i_{name});\n" for name, (kind, _) in self.inputs.items())
        lines = "".join(f"  {one.name} <= {one.text};\n" for one in self.outputs)
        return (
            f"{HEAD}entity {self.name} is port (\n  {'; '.join(ports)});\nend entity;\n"
            f"architecture rtl of {self.name} is\n{choices}{signals}begin\n{given}{lines}end architecture;\n"
        )

    def without(self, names: set[str]) -> Entity:
        """Return the entity without the named outputs."""
        return self._replace(outputs=[one for one in self.outputs if one.name not in names])


def entity(name: str, seed: int, count: int) -> Entity:
    """Return an entity with `count` random expressions."""
    maker = _Maker(random.Random(seed))
    return Entity(name, maker.inputs, [maker.expression(f"o{number}") for number in range(count)])


class _Maker:
    def __init__(self, chance: random.Random) -> None:
        self.inputs: dict[str, tuple[str, int]] = {}
        self._random = chance

    def expression(self, name: str) -> Expression:
        depth = self._random.randint(1, DEPTH)
        kind = self._random.choice(("signed", "signed", "signed", "unsigned", "boolean", "integer"))
        if kind == "boolean":
            return Expression(name, 1, f'"1" when {self._boolean(depth)} else "0"')
        if kind == "integer":
            limits = self._random.choice(((-128, 127), (0, 255), (-30000, 30000), (-(2**30), 2**30)))
            return Expression(name, 33, f"std_logic_vector(to_signed({self._integer(depth, *limits)[0]}, 33))")
        width = self._random.choice(WIDTHS)
        return Expression(name, width, f"std_logic_vector({self._vector(kind, depth, width)})")

    def _port(self, kind: str, width: int) -> str:
        name = f"{kind[0]}{width}{self._random.choice(('', 'b'))}"
        self.inputs[name] = (kind, width)
        return name

    def _limits(self, kind: str, width: int) -> Range:
        """Return the range of vectors of a width, within the integers of VHDL."""
        bits = min(width, INTEGER_BITS - 1)
        return (-(1 << (bits - 1)), (1 << (bits - 1)) - 1) if kind == "signed" else (0, (1 << bits) - 1)

    def _vector(self, kind: str, depth: int, width: int) -> str:
        if depth <= 0 or self._random.random() < 0.12:
            if self._random.random() < 0.75:
                return self._port(kind, width)
            low, high = self._limits(kind, width)
            value = self._random.choice((0, 1, -1, low, high, self._random.randint(low, high)))
            return f"to_{kind}({min(max(value, low), high)}, {width})"
        makers = [self._sum, self._logic, self._logic, self._chosen, self._converted, self._resized, self._greater]
        if width > 1:
            makers += [self._with_integer, self._product, self._quotient, self._rest, self._shifted, self._rotated]
            makers.append(self._joined)
        return self._random.choice(makers)(kind, depth - 1, width)

    def _sum(self, kind: str, depth: int, width: int) -> str:
        operands = [self._vector(kind, depth, width), self._vector(kind, depth, self._random.randint(1, width))]
        self._random.shuffle(operands)
        return f"({operands[0]} {self._random.choice('+-')} {operands[1]})"

    def _with_integer(self, kind: str, depth: int, width: int) -> str:
        operands = [self._vector(kind, depth, width), self._integer(depth, *self._limits(kind, width))[0]]
        self._random.shuffle(operands)
        return f"({operands[0]} {self._random.choice('+-')} {operands[1]})"

    def _product(self, kind: str, depth: int, width: int) -> str:
        part = self._random.randint(1, width - 1)
        return f"({self._vector(kind, depth, part)} * {self._vector(kind, depth, width - part)})"

    def _quotient(self, kind: str, depth: int, width: int) -> str:
        return f"({self._vector(kind, depth, width)} / {self._nonzero(kind, depth, self._random.randint(1, width))})"

    def _rest(self, kind: str, depth: int, width: int) -> str:
        operator = self._random.choice(("mod", "rem"))
        dividend = self._vector(kind, depth, self._random.randint(1, 33))
        return f"({dividend} {operator} {self._nonzero(kind, depth, width)})"

    def _nonzero(self, kind: str, depth: int, width: int) -> str:
        return f'({self._vector(kind, depth, width)} or "{1:0{width}b}")'

    def _resized(self, kind: str, depth: int, width: int) -> str:
        return f"resize({self._vector(kind, depth, self._random.choice(WIDTHS))}, {width})"

    def _shifted(self, kind: str, depth: int, width: int) -> str:
        number = self._integer(depth, 0, self._random.choice((3, width, 2 * width, 40)))[0]
        if self._random.random() < 0.3:
            number = self._integer(depth, *self._random.choice(((0, 3), (-3, 3), (-width, width))))[0]
            return f"({self._vector(kind, depth, width)} {self._random.choice(('sll', 'srl'))} {number})"
        return f"{self._random.choice(('shift_left', 'shift_right'))}({self._vector(kind, depth, width)}, {number})"

    def _rotated(self, kind: str, depth: int, width: int) -> str:
        if width.bit_count() == 1 and self._random.random() < 0.3:
            number = self._integer(depth, *self._random.choice(((0, 3), (-3, 3), (-2 * width, 2 * width))))[0]
            return f"({self._vector(kind, depth, width)} {self._random.choice(('rol', 'ror'))} {number})"
        number = self._integer(depth, 0, self._random.choice((3, width, 2 * width, 40)))[0]
        name = self._random.choice(("rotate_left", "rotate_right"))
        return f"{kind}({name}(unsigned({self._vector(kind, depth, width)}), {number}))"

    def _logic(self, kind: str, depth: int, width: int) -> str:
        first = self._vector(kind, depth, width)
        unary = ("not ", "-", "abs ") if kind == "signed" else ("not ",)
        if self._random.random() < 0.4:
            return f"({self._random.choice(unary)}{first})"
        operator = self._random.choice(("and", "or", "xor", "nand", "nor", "xnor"))
        return f"({first} {operator} {self._vector(kind, depth, width)})"

    def _chosen(self, kind: str, depth: int, width: int) -> str:
        return f"choose({self._boolean(depth)}, {self._vector(kind, depth, width)}, {self._vector(kind, depth, width)})"

    def _converted(self, kind: str, depth: int, width: int) -> str:
        if self._random.random() < 0.5:
            return f"to_{kind}({self._integer(depth, *self._limits(kind, width))[0]}, {width})"
        other = "unsigned" if kind == "signed" else "signed"
        return f"{kind}({self._vector(other, depth, width)})"

    def _joined(self, kind: str, depth: int, width: int) -> str:
        part = self._random.randint(1, width - 1)
        return f"{kind}'({self._vector(kind, depth, part)} & {self._vector(kind, depth, width - part)})"

    def _greater(self, kind: str, depth: int, width: int) -> str:
        name = self._random.choice(("maximum", "minimum"))
        return f"{name}({self._vector(kind, depth, width)}, {self._vector(kind, depth, width)})"

    def _boolean(self, depth: int) -> str:
        operator = self._random.choice(sorted(OPERATORS))
        kind = self._random.choice(("signed", "unsigned"))
        first = self._vector(kind, depth - 1, self._random.choice(WIDTHS))
        what = self._random.random()
        if what < 0.3:
            limits = (-1000, 1000)
            return f"{self._integer(depth - 1, *limits)[0]} {operator} {self._integer(depth - 1, *limits)[0]}"
        if what < 0.6:
            low = -100 if kind == "signed" else 0
            return f"{first} {operator} {self._integer(depth - 1, low, 100)[0]}"
        return f"{first} {operator} {self._vector(kind, depth - 1, self._random.choice(WIDTHS))}"

    def _integer(self, depth: int, low: int, high: int) -> tuple[str, Range]:
        """Return an integer expression with values from `low` to `high`, and the range of its values."""
        fitting = [
            (kind, width)
            for kind in ("signed", "unsigned")
            for width in (1, *sorted(set(WIDTHS)))
            if width < INTEGER_BITS and low <= self._limits(kind, width)[0] and self._limits(kind, width)[1] <= high
        ]
        if depth <= 0 or not fitting or self._random.random() < 0.15:
            if fitting and self._random.random() < 0.8:
                kind, width = self._random.choice(fitting)
                return f"to_integer({self._port(kind, width)})", self._limits(kind, width)
            value = self._random.choice((low, high, self._random.randint(low, high)))
            return f"({value})", (value, value)
        makers = [
            self._integer_sum,
            self._integer_product,
            self._integer_rest,
            self._integer_rest,
            self._integer_chosen,
        ]
        found = self._random.choice(makers)(depth - 1, low, high)
        if found is not None and low <= found[1][0] and found[1][1] <= high:
            return found
        kind, width = self._random.choice([one for one in fitting if one[1] > 1] or [("unsigned", 0)])
        if not width:
            return self._integer(0, low, high)
        return f"to_integer({self._vector(kind, depth - 1, width)})", self._limits(kind, width)

    def _integer_sum(self, depth: int, low: int, high: int) -> tuple[str, Range] | None:
        if not low <= 0 <= high:
            return None
        first, (least, most) = self._integer(depth, -(-low // 2), high // 2)
        second, (other_least, other_most) = self._integer(depth, -(-low // 2), high // 2)
        if self._random.random() < 0.5:
            return f"({first} + {second})", (least + other_least, most + other_most)
        return f"({first} - {second})", (least - other_most, most - other_least)

    def _integer_product(self, depth: int, low: int, high: int) -> tuple[str, Range] | None:
        root = int(min(high, -low if low < 0 else high) ** 0.5)
        if root < 1:
            return None
        first, limits = self._integer(depth, -root if low < 0 else 0, root)
        second, others = self._integer(depth, -root if low < 0 else 0, root)
        products = [one * other for one in limits for other in others]
        return f"({first} * {second})", (min(products), max(products))

    def _integer_rest(self, depth: int, low: int, high: int) -> tuple[str, Range] | None:
        divisor = self._random.choice((2, 3, 4, 5, 7, 8, 10, 16, 100, -3, -4, -7))
        operator = self._random.choice(("/", "mod", "rem"))
        most = self._random.choice((100, 1000, 40000))
        first, limits = self._integer(depth, self._random.choice((0, -most)), most)
        size = abs(divisor) - 1
        found = {
            "/": (min(quotients := [int(one / divisor) for one in limits]), max(quotients)),
            "mod": (0, size) if divisor > 0 else (-size, 0),
            "rem": (-size if limits[0] < 0 else 0, size if limits[1] > 0 else 0),
        }
        return f"({first} {operator} ({divisor}))", found[operator]

    def _integer_chosen(self, depth: int, low: int, high: int) -> tuple[str, Range] | None:
        first, limits = self._integer(depth, low, high)
        second, others = self._integer(depth, low, high)
        found = (min(limits[0], others[0]), max(limits[1], others[1]))
        if self._random.random() < 0.3:
            return f"{self._random.choice(('maximum', 'minimum'))}({first}, {second})", found
        return f"choose({self._boolean(depth)}, {first}, {second})", found
