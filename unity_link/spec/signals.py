"""Reads a signal's declaration: bits, kind, access, limits and publishing, and checks the rules for each."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, NamedTuple

import msgspec

from unity_link.errors import ArgumentError
from unity_link.spec.arguments import ACCESS, Binder, Bound
from unity_link.spec.diagnostics import did_you_mean, listed
from unity_link.spec.expressions import LEFT_OUT, Evaluator, GroupReference, LeftOut, Result, describe, parse_number
from unity_link.spec.kinds import FLOAT_BITS, MOST_BITS, MOST_WRAPPED, WITHOUT_SCALE, Enumeration, Kind, KindName
from unity_link.spec.model import Access, Effect, Safe
from unity_link.spec.syntax import Name, Number

if TYPE_CHECKING:
    from collections.abc import Mapping

    from unity_link.spec.kinds import Value
    from unity_link.spec.syntax import SignalDeclaration

PLAIN_KINDS = [name.value for name in KindName if name is not KindName.ENUM]
HOLD = "HOLD"
"""Word in SAFE for a signal that keeps its value when the lease ends."""
_NOT_WITH = {
    Effect.CLEAR_ON_READ: ("FIFO", "PUBLISH", "POLL", "GROUP"),
    Effect.WRITE_1_TO_CLEAR: ("FIFO", "SAFE", "TIMED", "MIN", "MAX"),
    Effect.PULSE: ("FIFO", "RESET", "TIMED", "MIN", "MAX"),
}
"""Arguments that exclude each effect."""
_ACCESS_OF = {
    Effect.CLEAR_ON_READ: (Access.READ,),
    Effect.WRITE_1_TO_CLEAR: (Access.READWRITE,),
    Effect.PULSE: (Access.WRITE, Access.READWRITE),
}
_FIXED = re.compile(r"(\d+)\.(\d+)")


class BitRange(NamedTuple):
    """Position of a signal's bits in its word."""

    lowest: int
    width: int


class PublishClause(NamedTuple):
    """Arguments of PUBLISH."""

    group: int | str
    divisor: int | None


class SignalParts(NamedTuple):
    """The evaluated declaration of a signal, without address and name."""

    kind: Kind
    lowest_bit: int
    access: Access
    arguments: Bound
    publishing: PublishClause | None
    reset: int
    """Bits after a reset."""
    safe: Safe | None
    timed: str | None
    """Name of the schedule that can write the signal."""
    effect: Effect | None
    laps_of: str | None
    """Name of the signal whose overflows extend this one; empty for itself, None without WRAPS."""
    places: Mapping[str, tuple[int, int]]


class SignalReader:
    """Reads the declarations of signals of one source."""

    def __init__(self, evaluator: Evaluator, enumerations: Mapping[str, Enumeration], data_bits: int) -> None:
        self._evaluator = evaluator
        self._fault = evaluator.fault
        self._enumerations = enumerations
        self._data_bits = data_bits

    def read(self, node: SignalDeclaration, scope: Mapping[str, Result]) -> SignalParts | None:
        """Return the evaluated declaration; None if its kind or access is unknown, which is reported."""
        bits = self._bits(node, scope)
        kind = self._kind(node, bits, scope)
        access = self._access(node)
        binder = Binder(self._evaluator, scope)
        arguments = binder.bind(node.access, node.access.place, node.arguments, ACCESS) if access is not None else {}
        if kind is None or access is None:
            return None
        kind = self._scaled(kind, arguments, binder, node)
        publishing = self._publishing(access, arguments, binder)
        self._check_limits(kind, access, arguments, binder)
        self._check_fifo(kind, bits, arguments, binder)
        self._check_pin(node, kind, bits, arguments, binder)
        reset = self._initial("RESET", arguments.get("RESET"), kind, access, arguments, binder)
        safe = self._safe(kind, access, arguments, binder)
        lowest = bits.lowest if bits is not None else 0
        start = safe.bits if safe is not None and safe.bits is not None else reset
        if safe is None and "RESET" not in arguments:
            start = self._unguarded(kind, access, arguments, binder)
        timed = self._timed(access, arguments, binder)
        effect = self._effect(kind, lowest, access, arguments, binder)
        if effect is Effect.PULSE and start:
            self._fault(binder.places["SAFE"], "bad-effect", "a pulse is 0 while its lease is not armed, too")
        laps_of = self._laps_of(kind, arguments, binder)
        if laps_of is not None:
            kind = msgspec.structs.replace(kind, wraps=True)
        return SignalParts(
            kind, lowest, access, arguments, publishing, start, safe, timed, effect, laps_of, binder.places
        )

    def _bits(self, node: SignalDeclaration, scope: Mapping[str, Result]) -> BitRange | None:
        if node.bits is None:
            return None
        numbers: list[int] = []
        for expression in (node.bits.high, node.bits.low or node.bits.high):
            value = self._evaluator.evaluate(expression, scope)
            if value is None:
                return None
            if isinstance(value, bool) or not isinstance(value, int):
                self._fault(expression.place, "bad-bits", f"a bit is a whole number, not {describe(value)}")
                return None
            if not 0 <= value < self._data_bits:
                message = f"bit {value} is not in a word of {self._data_bits} bits"
                self._fault(expression.place, "bad-bits", message, f"bits are 0 to {self._data_bits - 1}")
                return None
            numbers.append(value)
        high, low = numbers
        if high < low:
            place = (node.bits.high.start, (node.bits.low or node.bits.high).end)
            self._fault(place, "bad-bits", f"bits {high}:{low} run upwards", f"write [{low}:{high}], the highest first")
            return None
        return BitRange(low, high - low + 1)

    def _kind(self, node: SignalDeclaration, bits: BitRange | None, scope: Mapping[str, Result]) -> Kind | None:
        if node.kind is None:
            return self._sized(node, KindName.UNSIGNED, None, bits)
        word, width = node.kind.name, node.kind.width
        if str(word) in {KindName.FIXED.value, KindName.UFIXED.value}:
            return self._fixed(node, bits)
        number = LEFT_OUT if width is None else self._width(width, scope)
        if number is None:
            return None
        number = None if number is LEFT_OUT else number
        if word in self._enumerations:
            kind = self._sized(node, KindName.ENUM, number, bits)
            return None if kind is None else self._enumerated(node, kind, self._enumerations[word])
        if word not in PLAIN_KINDS:
            known = [*PLAIN_KINDS, *self._enumerations]
            advice = did_you_mean(word, known) or f"kinds are {listed(PLAIN_KINDS, 'and')}, and enumerations"
            self._fault(word.place, "unknown-kind", f"there is no kind '{word}'", advice)
            return None
        return self._sized(node, KindName(word), number, bits)

    def _width(self, width: Number | Name, scope: Mapping[str, Result]) -> int | LeftOut | None:
        """Return the width of a kind, a number or a parameter; None if it is unknown or invalid, which is reported."""
        value = parse_number(width.text) if isinstance(width, Number) else self._evaluator.evaluate(width, scope)
        if value is LEFT_OUT or (value is None and isinstance(width, Name)):
            return value
        if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= MOST_BITS:
            written = width.text[:40] if isinstance(width, Number) else describe(value)
            self._fault(width.place, "bad-width", f"a width is 1 to {MOST_BITS} bits, not {written}")
            return None
        return value

    def _fixed(self, node: SignalDeclaration, bits: BitRange | None) -> Kind | None:
        assert node.kind is not None
        word, width = node.kind.name, node.kind.width
        match = _FIXED.fullmatch(width.text) if isinstance(width, Number) else None
        if match is None:
            place = word.place if width is None else width.place
            message = f"{word} needs the bits before and after the point"
            self._fault(place, "bad-width", message, f"as in {word} 16.16")
            return None
        before, behind = (min(int(digits[:9]), 999) for digits in match.groups())
        if not 1 <= before + behind <= MOST_BITS:
            assert width is not None
            self._fault(width.place, "bad-width", f"a {word} has 1 to {MOST_BITS} bits, not {before + behind}")
            return None
        kind = self._sized(node, KindName(word), before + behind, bits)
        return None if kind is None else Kind(kind.name, kind.width, behind)

    def _sized(self, node: SignalDeclaration, name: KindName, width: int | None, bits: BitRange | None) -> Kind | None:
        """Return a kind with its width: as written, otherwise that of the signal's bits, otherwise its default."""
        place = node.name.place if node.kind is None else node.kind.name.place
        if name is KindName.BOOL:
            width = 1 if width is None else width
            if width != 1:
                self._fault(place, "bad-width", f"a bool is 1 bit, not {width}", "use unsigned or an enumeration")
                return None
        if width is None:
            width = bits.width if bits is not None else 32 if name is KindName.FLOAT else self._data_bits
        if name is KindName.FLOAT and width not in FLOAT_BITS:
            message = f"a float has {listed([str(one) for one in FLOAT_BITS])} bits, not {width}"
            self._fault(place, "bad-width", message)
            return None
        if bits is not None and bits.width != width:
            message = f"{name} {width} does not fit into the {bits.width} bits that '{node.name}' has"
            if name is KindName.BOOL:
                message = f"a bool is 1 bit, and '{node.name}' has {bits.width}"
            high = bits.lowest + width - 1
            advice = f"{width} bits from bit {bits.lowest} on are [{high}:{bits.lowest}]"
            self._fault(place, "bad-width", message, advice if high < self._data_bits else "")
            return None
        return Kind(name, width)

    def _enumerated(self, node: SignalDeclaration, kind: Kind, enumeration: Enumeration) -> Kind | None:
        assert node.kind is not None
        # Each value of the enumeration is compared below.
        self._evaluator.reporter.spend(len(enumeration.values) // 32)
        if enumeration.largest >> kind.width:
            needed = enumeration.largest.bit_length()
            message = (
                f"{enumeration.name} has values up to {enumeration.largest}, which need {needed} bits, not {kind.width}"
            )
            self._fault(node.kind.name.place, "enum-too-wide", message)
            return None
        return Kind(KindName.ENUM, kind.width, enumeration=enumeration)

    def _access(self, node: SignalDeclaration) -> Access | None:
        if node.access in Access.__members__:
            return Access[node.access]
        advice = did_you_mean(node.access, Access.__members__) or f"it is {listed(Access.__members__)}"
        self._fault(node.access.place, "unknown-access", f"there is no access '{node.access}'", advice)
        return None

    def _scaled(self, kind: Kind, arguments: Bound, binder: Binder, node: SignalDeclaration) -> Kind:
        scale, offset = arguments.get("SCALE", 1), arguments.get("OFFSET", 0)
        given = next((name for name in ("SCALE", "OFFSET") if name in arguments), None)
        if given is not None and kind.name in WITHOUT_SCALE:
            message = f"no {kind.name} has {given}"
            self._fault(binder.places[given], "bad-scale", message, "signed, unsigned and fixed have one")
            return kind
        if scale == 0:
            self._fault(binder.places["SCALE"], "bad-scale", "SCALE is 0, so that every value would be the same")
            return kind
        scaled = Kind(kind.name, kind.width, kind.fraction, scale, offset)
        if kind.name not in WITHOUT_SCALE and not scaled.is_exact():
            place = binder.places[given] if given is not None else node.name.place
            message = f"a float cannot represent all values of {scaled}"
            advice = "it has 53 bits: take fewer bits, or read the whole number and scale it yourself"
            self._fault(place, "inexact", message, advice)
            return kind
        return kind if kind.name in WITHOUT_SCALE else scaled

    def _publishing(self, access: Access, arguments: Bound, binder: Binder) -> PublishClause | None:
        for name in ("PUBLISH", "POLL"):
            if name in arguments and not access.reads:
                self._fault(
                    binder.places[name], "not-readable", f"{name} needs a signal that can be read, not {access}"
                )
        if "PUBLISH" in arguments and "POLL" in arguments:
            message = "a signal is either published by the gateway or polled by the host"
            self._fault(binder.places["POLL"], "publish-and-poll", message, "leave out PUBLISH or POLL")
        clause = arguments.get("PUBLISH", {})
        group = clause.get("GROUP")
        if group is None:
            return None
        return PublishClause(group.name if isinstance(group, GroupReference) else group, clause.get("DIVISOR"))

    def _check_limits(self, kind: Kind, access: Access, arguments: Bound, binder: Binder) -> None:
        low, high = arguments.get("MIN"), arguments.get("MAX")
        for name in ("MIN", "MAX"):
            if name not in arguments:
                continue
            place, limit = binder.places[name], arguments[name]
            if kind.name in {KindName.BOOL, KindName.ENUM}:
                self._fault(place, "bad-limit", f"no {kind.name} has {name}")
                return
            if not access.writes:
                message = f"{name} limits what is written, and this signal is only read"
                self._fault(place, "bad-limit", message, "leave it out, or use WRITE or READWRITE")
                return
            first, last = kind.range
            if kind.name is KindName.FLOAT:
                most = {16: 65504.0, 32: math.ldexp(2 - 2**-23, 127)}.get(kind.width, math.inf)
                first, last = -most, most
            if not (first <= limit <= last or _reaches(kind, limit)):
                message = f"{name}={limit:.12g} is outside of {first:.12g} to {last:.12g}, the range of {kind}"
                self._fault(place, "bad-limit", message)
                return
        if low is not None and high is not None and low > high:
            message = f"MIN={low:.12g} is more than MAX={high:.12g}"
            self._fault(binder.places["MIN"], "bad-limit", message, "exchange them")
        elif low is not None and high is not None and not kind.is_float and math.ceil(low) > math.floor(high):
            message = f"there is no whole number from MIN={low:.12g} to MAX={high:.12g}, and {kind} has no others"
            self._fault(binder.places["MIN"], "bad-limit", message, "a SCALE makes steps smaller than 1")

    def _check_pin(
        self, node: SignalDeclaration, kind: Kind, bits: BitRange | None, arguments: Bound, binder: Binder
    ) -> None:
        if "PIN" not in arguments:
            return
        if "FIFO" in arguments:
            message = "a FIFO port hands out words, and cannot be at pins"
            self._fault(binder.places["PIN"], "bad-pin", message)
        elif kind.width + (bits.lowest if bits is not None else 0) > self._data_bits:
            message = f"{node.name} has several words, and a register at pins is one"
            self._fault(binder.places["PIN"], "bad-pin", message)

    def _safe(self, kind: Kind, access: Access, arguments: Bound, binder: Binder) -> Safe | None:
        clause: Bound | None = arguments.get("SAFE")
        if clause is None or "LEASE" not in clause:
            return None
        value, lease = clause.get("VALUE"), clause["LEASE"].name
        names = () if kind.enumeration is None else kind.enumeration.values
        if value == HOLD and all(one.name != HOLD for one in names):
            return Safe(None, lease) if self._check_begins("SAFE", access, arguments, binder) else None
        if "RESET" in arguments:
            message = "a signal with SAFE begins with its safe value, and has no RESET"
            self._fault(binder.places["RESET"], "bad-reset", message, "leave out RESET")
        return Safe(self._initial("SAFE", value, kind, access, arguments, binder), lease)

    def _unguarded(self, kind: Kind, access: Access, arguments: Bound, binder: Binder) -> int:
        """Return the initial bits of a signal whose SAFE has the lease `none`; 0 for any other signal."""
        clause: Bound = arguments.get("SAFE", {})
        if "LEASE" in clause or clause.get("VALUE") == HOLD:
            return 0
        return self._initial("SAFE", clause.get("VALUE"), kind, access, arguments, binder)

    def _timed(self, access: Access, arguments: Bound, binder: Binder) -> str | None:
        clause: Bound | None = arguments.get("TIMED")
        if clause is None or "SCHEDULE" not in clause:
            return None
        if not access.writes or "FIFO" in arguments:
            which = "a FIFO port" if "FIFO" in arguments else "only read"
            message = f"TIMED is for a register that is written at an instant, and this signal is {which}"
            self._fault(binder.places["TIMED"], "bad-timed", message, "leave it out")
            return None
        schedule: str = clause["SCHEDULE"].name
        return schedule

    def _effect(self, kind: Kind, lowest: int, access: Access, arguments: Bound, binder: Binder) -> Effect | None:
        """Return the effect of a signal; None if it has none, or one that it cannot have, which is reported."""
        word: str | None = arguments.get("EFFECT")
        if word is None:
            return None
        place = binder.places["EFFECT"]
        if word not in Effect.__members__:
            message = f"there is no effect '{word}'"
            advice = did_you_mean(word, Effect.__members__) or f"it is {listed(Effect)}"
            self._fault(place, "bad-effect", message, advice)
            return None
        effect = Effect[word]
        are_bits = kind.name is KindName.BOOL or (kind.name is KindName.UNSIGNED and not kind.is_scaled)
        refused = next((other for other in _NOT_WITH[effect] if other in arguments), None)
        if access not in _ACCESS_OF[effect]:
            self._fault(place, "bad-effect", f"a signal with {effect} is {listed(_ACCESS_OF[effect])}, not {access}")
        elif effect is Effect.PULSE and kind.name is not KindName.BOOL:
            message = f"a signal with {effect} is a bool, not {kind}"
            self._fault(place, "bad-effect", message, "several in a row are @name[8] = address[i]: bool")
        elif not are_bits:
            self._fault(place, "bad-effect", f"a signal with {effect} is bool or unsigned without SCALE, not {kind}")
        elif lowest + kind.width > self._data_bits:
            self._fault(place, "bad-effect", f"a signal with {effect} is within one word of {self._data_bits} bits")
        elif refused is not None:
            advice = "each read clears it, that of a sample too" if effect is Effect.CLEAR_ON_READ else "leave it out"
            self._fault(binder.places[refused], "bad-effect", f"no signal with {effect} has {refused}", advice)
        else:
            return effect
        return None

    def _laps_of(self, kind: Kind, arguments: Bound, binder: Binder) -> str | None:
        """Return the name of the signal whose overflows extend a signal; empty for itself, None without WRAPS."""
        clause: Bound | None = arguments.get("WRAPS")
        if clause is None:
            return None
        place = binder.places["WRAPS"]
        refused = next((word for word in ("FIFO", "EFFECT", "MIN", "MAX") if word in arguments), None)
        if kind.name in WITHOUT_SCALE:
            self._fault(place, "bad-wraps", f"no {kind.name} wraps", "signed, unsigned and fixed numbers do")
        elif kind.width > MOST_WRAPPED:
            message = f"a signal with WRAPS has at most {MOST_WRAPPED} bits, and this one has {kind.width}"
            self._fault(place, "bad-wraps", message, "leave it out: no counter gets so far")
        elif refused is not None:
            self._fault(binder.places[refused], "bad-wraps", f"no signal with WRAPS has {refused}", "leave it out")
        else:
            return str(clause.get("OF", ""))
        return None

    def _initial(
        self, word: str, value: Value | str | None, kind: Kind, access: Access, arguments: Bound, binder: Binder
    ) -> int:
        """Return the bits of the value in RESET or SAFE; 0 if it is missing or invalid, which is reported."""
        if value is None:
            return 0
        if not self._check_begins(word, access, arguments, binder):
            return 0
        place, code = binder.places[word], f"bad-{word.lower()}"
        low, high = arguments.get("MIN"), arguments.get("MAX")
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        if is_number and not ((low is None or low <= value) and (high is None or value <= high)):
            limits = " to ".join("..." if limit is None else f"{limit:.12g}" for limit in (low, high))
            self._fault(place, code, f"{word} is {value:.12g}, outside of the signal's limits, {limits}")
            return 0
        try:
            return kind.encode(value)
        except ArgumentError as error:
            self._fault(place, code, f"{word}: {error}")
            return 0

    def _check_begins(self, word: str, access: Access, arguments: Bound, binder: Binder) -> bool:
        """Return whether a signal is a register, so that it can have RESET and SAFE; report it otherwise."""
        if access.writes and "FIFO" not in arguments:
            return True
        which = "a FIFO port, which begins empty" if "FIFO" in arguments else "only read"
        message = f"{word} is the value of a register before its first write, and this signal is {which}"
        self._fault(binder.places[word], f"bad-{word.lower()}", message, "leave it out")
        return False

    def _check_fifo(self, kind: Kind, bits: BitRange | None, arguments: Bound, binder: Binder) -> None:
        if "FIFO" not in arguments:
            return
        place = binder.places["FIFO"]
        if bits is not None and bits.width != self._data_bits:
            self._fault(place, "bad-fifo", "a FIFO hands out whole words, so its signal cannot be some bits of one")
        elif kind.width > self._data_bits:
            message = f"a FIFO hands out words of {self._data_bits} bits, and {kind} has {kind.width}"
            self._fault(place, "bad-fifo", message)


def _reaches(kind: Kind, limit: float) -> bool:
    """Return whether a limit just beyond a scaled kind's range rounds to a number in it: 0.3 times 3 is below 0.9."""
    if not kind.is_scaled:
        return False
    try:
        kind.encode(limit)
    except ArgumentError:
        return False
    return True
