"""Write the inputs that a search begins with: ``python -m fuzz.make_corpus``, from the directory of the tests.

Inputs that a search has found are kept: only the files named here are written again.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from unity_link.protocol.wire.compact import END, ESCAPE, START, CompactForm, Packer
from unity_link.protocol.wire.configuration import Feature, GatewayInfo
from unity_link.protocol.wire.crc import Crc, seed_of
from unity_link.protocol.wire.frames import TOKEN_LINE
from unity_link.virtual import VirtualGateway

CORPUS = Path(__file__).with_name("corpus")
EXAMPLES = Path(__file__).parents[2] / "examples"
DEFAULT = VirtualGateway().receive(b"Q\r", 0.0).strip()[1:]


def checked(body: bytes, session: int = 0) -> bytes:
    """Return a body with its CRC, which depends on the session, and its line end."""
    return body + Crc().text(body, seed_of(session, from_gateway=False)) + b"\n"


def record(folder: Path) -> None:
    """Record a robot and a snoop of the link; the files contain relative paths."""
    snoop, recording = Path("snooped", "short"), Path("recording", "short")
    for path in (folder / snoop, folder / recording):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.unlink(missing_ok=True)
    program = Path(sys.executable).with_name("unity-link")
    (folder / "scara.ul").write_bytes((EXAMPLES / "scara.ul").read_bytes())
    url = f"sim:scara?snoop={snoop}"
    subprocess.run([program, "record", url, "scara.ul", "-o", recording, "--duration", "0.3"], cwd=folder, check=True)
    (folder / "scara.ul").unlink()


def main() -> int:
    """Write all inputs; return the exit status."""
    session = checked(b"K0000001")
    requests = [
        checked(body, 1) for body in (b"r00088", b"w0018A0000002A", b"rm0028804", b"gs00303000A020A0B", b"gn00403")
    ]
    form = CompactForm.of(GatewayInfo(features=Feature.COMPACT), from_gateway=False)
    compact = [Packer(form).pack_one(request) for request in requests]
    cut = compact[0][:-1] + b"\r" + compact[0][:-1] + ESCAPE + END + START + END + compact[1][1:]
    texts: dict[str, bytes] = {
        "frames/requests": session + b"".join(requests),
        "frames/plain": b"R0A\rW0A0000002A\r\nX03\r\n",
        "configuration/default": DEFAULT,
        "frames/compact": session + b"".join(compact) + cut,
        "gateway/compact": b"\x80" + checked(b"K0008001") + b"".join(compact) + cut,
        "gateway/session": b"\x80" + session + b"".join(requests),
        "gateway/plain": b"\x80Q\rR0A\rRM0AFF\rGS0000000103010203\rGN00\rGP00\r",
        "session/asks": bytes([1, 0, 1, 0, 1, 0, 1, 3, 7, 0, 3, 8, 1, 5, 3, 9, 3, 0, 1, 4, 9, 3, 2, 2, 9, 0, 1]),
        "session/resets": bytes([1, 0, 1, 0, 1, 0, 1, 3, 7, 0, 0, 7, 1, 3, 7, 0, 0, 1, 4, 30, 0, 1, 0, 1, 0, 1]),
        "page/hello": b'{"type":"hello","token":"secret"}',
        "page/write": b'{"type":"write","number":1,"signal":"j1.pos_sp","value":1.5}',
        "serve/asks": b"".join(
            [
                bytes([5, 1, 6, 0, 5, 1]),
                *(bytes([2, number, 0x10, 0, what]) for number, what in enumerate([0, 2, 3, 1, 5, 6, 7, 8])),
                bytes([5, 40, 9, 0, 2, 9, 0x10, 0, 1, 5, 80, 7, 0]),
            ]
        ),
        "serve/strangers": bytes([5, 9, 6, 1, 0, len(TOKEN_LINE) + 7]) + TOKEN_LINE + b"secret\n" + bytes([5, 255]),
        "serve/gateway": bytes([6, 0, 5, 1, 9, 1, 4, 12]) + b"r00000000001" + bytes([9, 2]),
        "spec/scara": (EXAMPLES / "scara.ul").read_bytes(),
        "spec/walker": (EXAMPLES / "walker.ul").read_bytes(),
    }
    for name, data in texts.items():
        path = CORPUS / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    record(CORPUS)
    return 0


if __name__ == "__main__":
    sys.exit(main())
