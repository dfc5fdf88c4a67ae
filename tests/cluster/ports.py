"""Ports of loopback for servers that tests start."""
import http.client
import random
import socket
import time


def free_port():
    """One that no client is given while its server is away: those are taken from 32768 on."""
    chance = random.SystemRandom()
    while True:
        port = chance.randrange(10000, 32768)
        with socket.socket() as free:
            try:
                free.bind(("127.0.0.1", port))
            except OSError:
                continue
            return port


def wait_for_port(port, seconds=60):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        try:
            connection = http.client.HTTPConnection("127.0.0.1", port, timeout=1)
            connection.connect()
            connection.close()
            return
        except OSError:
            time.sleep(.02)
    raise TimeoutError(f"nobody listens on port {port}")
