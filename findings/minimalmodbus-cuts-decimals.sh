#!/usr/bin/env bash
# minimalmodbus 2.1.1 cuts a scaled value instead of rounding it: write_register(0, 2.3, number_of_decimals=2) sends 229.
#
# Expected: 230, because 2.3 with two decimals is 230. The product 2.3 * 100 is 229.99999999999997 in floating point, and
# `int` takes the whole part. A drive that takes its set point in hundredths gets one hundredth too little for about
# one in twenty values with two decimals.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/venv"
"$folder/venv/bin/pip" --quiet --disable-pip-version-check install minimalmodbus==2.1.1 pyserial==3.5
"$folder/venv/bin/python" - <<'PYTHON'
import os
import pty
import struct
import threading
import tty

import minimalmodbus

master, slave = pty.openpty()
tty.setraw(master)
tty.setraw(slave)
sent = []


def crc(frame):
    value = 0xFFFF
    for byte in frame:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ (0xA001 if value & 1 else 0)
    return struct.pack("<H", value)


def device():
    """Answer each "write multiple registers" of one register as a drive does."""
    while True:
        request = b""
        while len(request) < 11:
            request += os.read(master, 64)
        sent.append(struct.unpack(">H", request[7:9])[0])
        os.write(master, request[:6] + crc(request[:6]))


threading.Thread(target=device, daemon=True).start()
drive = minimalmodbus.Instrument(os.ttyname(slave), 1)
drive.serial.timeout = 2
values = [0.29, 1.13, 2.3, 2.5]
for value in values:
    drive.write_register(0, value, number_of_decimals=2)
print(dict(zip(values, sent)))
raise SystemExit(sent != [28, 112, 229, 250])
PYTHON
