"""The description that a board carries has the same meaning as its spec."""

from __future__ import annotations

import subprocess
import sys
import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.protocol.wire.description import PAGE_WORDS, description_of, length_of, pages_of, words_of
from unity_link.spec import SpecError, compile_description, compile_file, compile_text
from unity_link.spec.description import MOST_BYTES

if TYPE_CHECKING:
    from unity_link.spec import Interface

ROOT = Path(__file__).parents[2]
SPECS = sorted(
    path
    for folder in ("examples", "tests/generate", "tests/fuzz", "gateware/formal")
    for path in (ROOT / folder).rglob("*.ul")
)


def said(interface: Interface) -> object:
    """Return the content of an interface without comments, positions and the files of its cores."""
    left_out = {"doc", "type_doc", "span", "vhdl", "library", "python"}

    def bare(value: object) -> object:
        if isinstance(value, dict):
            return {key: bare(one) for key, one in value.items() if key not in left_out}
        return [bare(one) for one in value] if isinstance(value, list | tuple) else value

    return bare(msgspec.to_builtins(interface))


def packed(text: str) -> bytes:
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    return packer.compress(text.encode()) + packer.flush()


@pytest.mark.parametrize("path", SPECS, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_description_has_the_meaning_of_its_spec(path: Path) -> None:
    for interface in compile_file(path).interfaces:
        again = compile_description(interface.description).interface()
        assert said(again) == said(interface)
        assert again.fingerprint == interface.fingerprint
        assert again.description == interface.description


def test_a_description_has_no_comments_and_no_unused_declarations(tmp_path: Path) -> None:
    (tmp_path / "parts.ul").write_text(
        "/// Long story.\nenum gait { off, trot }\nenum other { a }\n"
        "leg(): @(at) { @mode = at: gait READWRITE(); } // Behind it.\nspare(): @(at) { @x = at: READ(); }\n"
        "public else_() { @y = 1: READ(); }\n"
    )
    path = tmp_path / "robot.ul"
    path.write_text(
        'import "parts.ul";\n// Of the robot.\npublic robot() { front: leg() @(4); }\n'
        "public second() { @z = 9: READ(); }\n"
    )
    spec = compile_file(path)
    text = zlib.decompress(spec.interface("robot").description, -15).decode()
    assert text == (
        "enum gait {\n  off,\n  trot,\n}\n\nleg(): @(at) {\n  @mode = at: gait READWRITE();\n}\n\n"
        "public robot() {\n  front: leg() @(4);\n}\n"
    )
    assert "z" in zlib.decompress(spec.interface("second").description, -15).decode()


def test_a_description_includes_users_cores_and_keeps_their_names_apart(tmp_path: Path) -> None:
    folder = tmp_path / "cores" / "blink"
    folder.mkdir(parents=True)
    (folder / "blink.ul").write_text(
        'enum mode { slow, fast }\nBLINK(): @(BASE) { ENTITY("blink"); @mode = BASE: mode READWRITE(); }'
    )
    (folder / "blink.py").write_text("raise SystemExit")
    path = tmp_path / "robot.ul"
    path.write_text("enum mode { off, on }\npublic robot() { b: BLINK() @(4); @mode = 1: mode READWRITE(); }")
    interface = compile_file(path).interface()
    again = compile_description(interface.description).interface()
    names = {name: signal.kind.enumeration for name, signal in again.signals.items()}
    assert [value.name for value in names["b.mode"].values] == ["slow", "fast"]  # type: ignore[union-attr]
    assert [value.name for value in names["mode"].values] == ["off", "on"]  # type: ignore[union-attr]
    (part,) = again.cores
    # The core has no Python: that of a folder on this machine is not used.
    assert (part.core.word, part.core.python) == ("BLINK", "")  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("description", "says"),
    [
        (b"", "cut short"),
        (b"\xff\xff", "cannot be unpacked"),
        (packed("public a() { @b = 1: READ(); }")[:-4], "cut short"),
        (packed("x" * (MOST_BYTES + 1)), "1,048,576 characters"),
    ],
)
def test_invalid_data_of_a_description_is_refused(description: bytes, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        compile_description(description)


def test_a_description_reads_no_file_of_this_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.ul").write_text("public a() { @b = 1: READ(); }")
    with pytest.raises(SpecError, match=r"secret\.ul is not read: a description has no imports"):
        compile_description(packed('import "secret.ul";\npublic b() { @c = 1: READ(); }'))
    with pytest.raises(SpecError, match="there is no component 'PWM'"):
        compile_description(packed("public b() { a: PWM() @(1); }"))


def members(count: int, member: str) -> str:
    return "public r() { " + "".join(member.replace("#", str(number)) for number in range(count)) + " }"


LARGE = {
    "one row of all addresses": "public r() { @s[65536] = i: READ(); }",
    "rows in an array": "public r() { c[50]: b() @(i * 1000); } b(): @(x) { @a[1000] = x + i: READ(); }",
    "a row with arguments": 'public r() { @s[20000] = 2 * i: signed READWRITE(UNIT="V", MIN=-5, MAX=5, ID="a" + i); }',
    "many words": members(3000, '@joint_# = #: signed 16 READWRITE(SCALE=0.01, UNIT="deg", MIN=-50, MAX=60);\n'),
    "a long string": f'public r() {{ @s = 1: READ(UNIT="{"a" * 900_000}"); }}',
    "escapes": f'public r() {{ @s = 1: READ(UNIT="{chr(92) * 900_000}"); }}',
    "comments in a line": f"public r() {{ @s = 1: READ(); {'/**/' * 200_000} }}",
    "comments in lines": "public r() { @s = 1: READ(); " + "//\n" * 300_000 + "}",
    "line ends": "public r() { @s = 1: READ(); " + "\n" * 1_000_000 + "}",
}
"""Descriptions of the largest size that a board may carry."""
TOO_LARGE = {
    "too many arguments": 'public r() { @s[65536] = i: READWRITE(UNIT="V", MIN=0, MAX=5, ID="a" + i); }',
    "two rows": "public r() { @s[65536] = i: READ(); @t[65536] = 65536 + i: READ(); }",
    "a component that is not used": "public r() { } c() { @s[65536] = i: READ(); @t[65536] = 0: READ(); }",
    "signs": f"public r() {{ @s = {'-' * 1_000_000}1: READ(); }}",
    "terms": f"public r() {{ @s = {'0+' * 500_000}0: READ(); }}",
    "terms in a row": f"public r() {{ @s[1000] = {'0+' * 5000}i: READ(); }}",
    "joined strings": "public r() { @s[20000] = i: READ(UNIT=" + '"a"+' * 900 + '"b" + i); }',
    "a long name in a row": f"public r() {{ @{'n' * 50_000}[5000] = i: READ(); }}",
    "a long name of an array": f"public r() {{ {'n' * 50_000}[5000]: b() @(i); }} b(): @(x) {{ @a = x: READ(); }}",
    "arrays in arrays": "public r() { a[4]: c0(); }"
    + "".join(f" c{number}() {{ a[4]: c{number + 1}(); }}" for number in range(20))
    + " c20() { }",
    "parameters": f"public r() {{ c[500]: b({', '.join(f'p{number}=1' for number in range(1000))}) @(i); }} "
    f"b({', '.join(f'p{number}' for number in range(1000))}): @(x) {{ @a = x: READ(); }}",
    "defaults": "public r() { c[3000]: b() @(i); } "
    f"b({', '.join(f'p{number}=1' for number in range(10_000))}): @(x) {{ @a = x: READ(); }}",
    "names that a row copies": "".join(f"group g{number}(RATE=10);" for number in range(10_000))
    + "public r() { @s[10000] = i: READ(); }",
    "names of an enumeration": f"enum e {{ {', '.join(f'a{number}' for number in range(20_000))} }} "
    "public r() { @s[5000] = i: e 16 READ(); }",
    "open strings": "public r() { @s = 1: READ(); " + '"\n' * 400_000 + "}",
}
FAULTY = {
    "faults in a long line": "public r() {\n" + members(5000, "@s# = q#: READ();")[12:],
    "semicolons": f"public r() {{ @s = 1: READ(); {';' * 200_000} }}",
    "a long name": f"public r() {{ @{'a' * 100_000}b = 0: READ(); @x = {'a' * 100_000}c: READ(); }}",
    "one address": members(5000, "@s# = 0[0]: bool READ();"),
    "levels": "public r() { a: c0() @(0); }"
    + "".join(f" c{number}(): @(x) {{ a: c{number + 1}() @(x); }}" for number in range(5000)),
}
TOO_MUCH = "it has more signals, words or expressions than are read from a board"
_COST = """
import resource, sys, time
from unity_link.spec import SpecError, compile_description, compile_text
compile_text("public r() { @s = 0: READ(); }")
description = sys.stdin.buffer.read()
before, began = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
try:
    outcome = str(len(compile_description(description, 32, 32).interface().signals))
except SpecError as error:
    outcome = f"{len(error.diagnostics)} error"
except ValueError as error:
    outcome = str(error)
print(time.process_time() - began, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before, outcome)
"""


def cost_of(text: str) -> tuple[float, int, str]:
    """Compile a description in a process; return its processor time in s, its memory in KiB, and the outcome."""
    command = [sys.executable, "-c", _COST]
    done = subprocess.run(command, input=packed(text), stdout=subprocess.PIPE, check=True, timeout=300)
    seconds, memory, outcome = done.stdout.decode().split(" ", 2)
    return float(seconds), int(memory), outcome.strip()


@pytest.mark.slow
@pytest.mark.parametrize("name", [*LARGE, *TOO_LARGE, *FAULTY])
def test_a_description_costs_at_most_two_seconds_and_100_megabytes(name: str) -> None:
    seconds, memory, outcome = cost_of((LARGE | TOO_LARGE | FAULTY)[name])
    assert seconds < 2
    assert memory < 100 * 1024
    refusal = "1 error" if name in FAULTY else TOO_MUCH
    assert outcome.isdecimal() if name in LARGE else outcome == refusal


@pytest.mark.parametrize("name", ["signs", "terms", "parameters", "open strings"])
def test_a_description_that_needs_too_much_work_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match=TOO_MUCH):
        compile_description(packed(TOO_LARGE[name]), 32, 32)


def test_a_description_is_refused_with_only_its_first_error() -> None:
    with pytest.raises(SpecError) as refusal:
        compile_description(packed(FAULTY["one address"]), 32, 32)
    (error,) = refusal.value.diagnostics
    assert error.message.startswith("s1 takes bit 0 at address 0x0, which s0 has")


@given(st.binary(min_size=1, max_size=3000), st.sampled_from([8, 12, 16, 24, 32, 64]))
def test_the_words_of_the_pages_contain_the_description(description: bytes, bits: int) -> None:
    words = words_of(description, bits)
    assert len(words) == pages_of(len(description), bits) * PAGE_WORDS
    assert all(0 <= word < 1 << bits for word in words)
    assert length_of(words[:PAGE_WORDS], bits) == len(description)
    assert description_of(words, bits) == description


@given(st.binary(min_size=1, max_size=300), st.data())
def test_a_damaged_word_is_found(description: bytes, data: st.DataObject) -> None:
    words = words_of(description, 32)
    at = data.draw(st.integers(0, (len(description) + 7) // 4))
    last = 8 * ((len(description) + 8) - 4 * at)
    words[at] ^= 1 << data.draw(st.integers(0, min(last, 32) - 1))
    with pytest.raises(ValueError, match=r"CRC is wrong|its length is"):
        description_of(words, 32)


@pytest.mark.parametrize(
    ("members", "is_described"),
    [
        ("@a = 0xEE: READ();", True),
        ("@a = 0xEF: READ();", False),
        ("@a = 0xED: unsigned 64 READ();", True),
        ("@a = 0xEE: unsigned 64 READ();", False),
        ("m: MEMORY(BASE=0x10, SIZE=0xDF) {}", True),
        ("m: MEMORY(BASE=0x10, SIZE=0xE0) {}", False),
        ("m: MEMORY(BASE=0x10) {}", False),
        ("MEMORY(BASE=0x10) { @a = 1: READ(); }", True),
        ("@a = 0xEF: READ(); GATEWAY(ADDRESS_BITS=9);", True),
    ],
)
def test_a_gateway_has_a_description_if_its_highest_addresses_are_free(members: str, *, is_described: bool) -> None:
    assert compile_text(f"public a() {{ {members} }}").interface().is_described is is_described


def test_maps_that_place_each_other_are_refused() -> None:
    maps = "".join(
        f"\f{one}\n{one}(): @(BASE) {{ @a = BASE: READ(); p: {other}() @(BASE + 1); }}"
        for one, other in (("PING", "PONG"), ("PONG", "PING"))
    )
    with pytest.raises(SpecError, match="PING contains itself: PING -> PONG -> PING"):
        compile_description(packed(f"public r() {{ p: PING() @(1); }}\n{maps}"))
