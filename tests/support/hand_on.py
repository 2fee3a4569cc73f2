"""Forwards bytes between its standard streams and a Unix socket: ``hand_on.py PATH``."""

import os
import socket
import sys
import threading


def hand_on_input(connection: socket.socket) -> None:
    """Forward the bytes of stdin until its end."""
    while data := os.read(0, 65536):
        connection.sendall(data)
    connection.shutdown(socket.SHUT_WR)


with socket.socket(socket.AF_UNIX) as connected:
    connected.connect(sys.argv[1])
    threading.Thread(target=hand_on_input, args=[connected], daemon=True).start()
    while received := connected.recv(65536):
        while received:
            received = received[os.write(1, received) :]
