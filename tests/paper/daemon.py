"""A daemon of one's own and the CLI that talks to it."""
import json
import os
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path


class Daemon:
    """`remeshd` on a free loopback port with an empty store; ends with the `with` block."""

    def __init__(self, binaries):
        self.binaries = Path(binaries)

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="remesh-paper-")
        with socket.socket() as s:
            s.bind(("127.0.0.1", 0))
            self.address = "127.0.0.1:%d" % s.getsockname()[1]
        self.log = open(self.file("remeshd.log"), "w")
        self.process = subprocess.Popen(
            [self.binaries / "remeshd", "--listen", self.address, "--store", self.file("store")],
            stdin=subprocess.DEVNULL, stdout=self.log, stderr=subprocess.STDOUT)
        for _ in range(100):
            if self.process.poll() is not None:
                raise RuntimeError("remeshd ended at once: " + Path(self.log.name).read_text())
            if self._cli("revisions").returncode == 0:
                return self
            time.sleep(0.1)
        self.__exit__()
        raise RuntimeError("remeshd does not answer")

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        try:
            self.process.wait(20)
        finally:
            self.process.kill()
            self.log.close()
            self.folder.cleanup()

    def file(self, name):
        return os.path.join(self.folder.name, name)

    def run(self, command, *arguments, out):
        """Runs `remesh command`; returns the Report. The mesh lies in file(out + ".vtu")."""
        report = self.file(out + ".json")
        done = self._cli(command, *arguments, "-o", self.file(out + ".vtu"), "--json", report)
        if done.returncode != 0:
            raise RuntimeError(f"remesh {command} {' '.join(map(str, arguments))}: exit "
                               f"{done.returncode}: {done.stderr}")
        return json.loads(Path(report).read_text())

    def _cli(self, *arguments):
        return subprocess.run([self.binaries / "remesh", "--address", self.address, *map(str, arguments)],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
