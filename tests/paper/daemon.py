"""A daemon of one's own and the CLI that talks to it."""
import json
import os
import re
import subprocess
import tempfile
import time
from pathlib import Path


class Daemon:
    """`remeshd` on a free loopback port with an empty store; ends with the `with` block. Its meshes
    are even, which is the paper, unless they are to be `sized` by the default rules."""

    def __init__(self, binaries, *options, sized=False):
        self.binaries, self.options, self.sized = Path(binaries), options, sized

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="remesh-paper-")
        log = Path(self.file("remeshd.log"))
        with log.open("w") as out:
            self.process = subprocess.Popen(
                [self.binaries / "remeshd", "--listen", "127.0.0.1:0", "--store", self.file("store"),
                 *self.options],
                stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT)
        for _ in range(300):
            if found := re.search(r" serving remesh\.v1 on ([^,]+),", log.read_text()):
                self.address = found[1]
                return self
            if self.process.poll() is not None:
                break
            time.sleep(0.1)
        said = log.read_text()
        self.__exit__()
        raise RuntimeError("remeshd does not start: " + said)

    def __exit__(self, *_):
        self.process.terminate()
        try:
            self.process.wait(20)
        finally:
            self.process.kill()
            self.folder.cleanup()

    def file(self, name):
        return os.path.join(self.folder.name, name)

    def run(self, command, *arguments, out):
        """Runs `remesh command`; returns the Report. The mesh lies in file(out + ".vtu")."""
        report = self.file(out + ".json")
        if command == "mesh" and not self.sized:
            arguments += ("--even",)
        done = self._cli(command, *arguments, "-o", self.file(out + ".vtu"), "--json", report)
        if done.returncode != 0:
            raise RuntimeError(f"remesh {command} {' '.join(map(str, arguments))}: exit "
                               f"{done.returncode}: {done.stderr}")
        return json.loads(Path(report).read_text())

    def _cli(self, *arguments):
        return subprocess.run([self.binaries / "remesh", "--address", self.address, *map(str, arguments)],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True)
