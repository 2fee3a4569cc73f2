"""The fingerprint of a map depends only on the map: equal for equal maps, different for different ones."""

import msgspec
import pytest

from support.spec_examples import interface_of
from unity_link.spec import Interface

MAP = '@x = 0x10[3:0]: unsigned READ(UNIT="mm"); @y = 0x12: unsigned 16 WRITE();'


def test_equal_maps_of_any_source_have_equal_fingerprints() -> None:
    interface = interface_of(MAP)
    again = msgspec.json.decode(msgspec.json.encode(interface), type=Interface)
    assert again.fingerprint == interface.fingerprint == interface_of(MAP.replace("; ", ";\n")).fingerprint
    assert 0 < interface.fingerprint < 1 << 32


@pytest.mark.parametrize(
    "members",
    [
        MAP.replace("; @y", "; /// Doc.\n @y"),
        MAP.replace("READ(", 'READ(ID="other", '),
        "; ".join(reversed(MAP.removesuffix(";").split("; "))) + ";",
        MAP.replace("WRITE()", "WRITE(MIN=0, MAX=65535, SCALE=1.0, OFFSET=0, RESET=0)"),
    ],
    ids=["comment", "ID", "order", "what holds anyway"],
)
def test_details_that_affect_no_access_are_not_in_the_fingerprint(members: str) -> None:
    assert members != MAP
    assert interface_of(members).fingerprint == interface_of(MAP).fingerprint


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("0x12", "0x13"),
        ("[3:0]", "[4:1]"),
        ("unsigned 16", "signed 16"),
        ("unsigned 16", "unsigned 17"),
        ("READ(", "READWRITE("),
        ("WRITE()", "WRITE(FIFO)"),
        ("@y", "@z"),
        ("mm", "m"),
        ("WRITE()", "WRITE(SCALE=2)"),
        ("WRITE()", "WRITE(OFFSET=2)"),
        ("WRITE()", "WRITE(MAX=2)"),
        ("WRITE()", "WRITE(RESET=2)"),
    ],
    ids=["address", "bits", "kind", "width", "access", "queue", "name", "unit", "scale", "offset", "limit", "reset"],
)
def test_different_maps_have_different_fingerprints(text: str, other: str) -> None:
    assert text in MAP
    assert interface_of(MAP.replace(text, other)).fingerprint != interface_of(MAP).fingerprint


def test_other_widths_of_the_gateway_change_the_fingerprint() -> None:
    assert interface_of(MAP, data_bits=64).fingerprint != interface_of(MAP).fingerprint
