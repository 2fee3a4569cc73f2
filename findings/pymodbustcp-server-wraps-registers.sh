#!/usr/bin/env bash
# The server of pyModbusTCP 0.3.1 stores a register value that does not fit by its lowest 16 bits: 70000 is read as 4464,
# -1 as 65535, and 2.9 as 2, without an error. The client of the same package refuses each of the three.
#
# Expected: one rule in both, and an error for a position that has outgrown its register.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" --quiet --disable-pip-version-check install pyModbusTCP==0.3.1
"$folder/venv/bin/python" - <<'PYTHON'
import socket

from pyModbusTCP.client import ModbusClient
from pyModbusTCP.server import ModbusServer

with socket.create_server(("127.0.0.1", 0)) as free:
    port = free.getsockname()[1]
values = [70000, -1, 2.9]
server = ModbusServer("127.0.0.1", port, no_block=True)
server.start()
stored = server.data_bank.set_holding_registers(0, values)
client = ModbusClient("127.0.0.1", port)
read = client.read_holding_registers(0, 3)
refused = []
for value in values:
    try:
        client.write_single_register(0, value)
    except Exception as error:
        refused.append(type(error).__name__)
print(f"server: set {values}: {stored}, read {read}; client: {refused}")
client.close()
server.stop()
raise SystemExit((stored, read, len(refused)) != (True, [4464, 65535, 2], 3))
PYTHON
