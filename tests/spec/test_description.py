"""Descriptions: what a board carries of its spec says the same as the spec."""

from __future__ import annotations

import zlib
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from unity_link.protocol.description import PAGE_WORDS, description_of, length_of, pages_of, words_of
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
    """Return what an interface says, without comments, places, and the files of its cores."""
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
def test_a_description_says_the_same_as_its_spec(path: Path) -> None:
    for interface in compile_file(path).interfaces:
        again = compile_description(interface.description).interface()
        assert said(again) == said(interface)
        assert again.fingerprint == interface.fingerprint
        assert again.description == interface.description


def test_it_has_neither_comments_nor_what_the_interface_does_not_use(tmp_path: Path) -> None:
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


def test_names_of_a_core_and_of_the_spec_stay_apart_and_a_core_of_ones_own_is_in_it(tmp_path: Path) -> None:
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
    # Its Python is not that of a folder that happens to be here.
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
def test_what_is_no_description_is_refused(description: bytes, says: str) -> None:
    with pytest.raises(ValueError, match=says):
        compile_description(description)


def test_a_description_reads_no_file_of_this_machine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "secret.ul").write_text("public a() { @b = 1: READ(); }")
    with pytest.raises(SpecError, match=r"secret\.ul is not read: a description has no imports"):
        compile_description(packed('import "secret.ul";\npublic b() { @c = 1: READ(); }'))
    with pytest.raises(SpecError, match="there is no component 'PWM'"):
        compile_description(packed("public b() { a: PWM() @(1); }"))


@given(st.binary(min_size=1, max_size=3000), st.sampled_from([8, 12, 16, 24, 32, 64]))
def test_words_of_pages_hold_the_description(description: bytes, bits: int) -> None:
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
def test_a_gateway_is_described_where_its_spec_leaves_the_highest_addresses_free(
    members: str, *, is_described: bool
) -> None:
    assert compile_text(f"public a() {{ {members} }}").interface().is_described is is_described
