"""Debian's PostgreSQL on this machine, in a folder of its own."""
import os
import pwd
import shutil
import signal
import subprocess
from pathlib import Path

from ports import free_port, wait_for_port

UNPACKED = Path(__file__).parent.parent.parent / "build/tools/usr"


def find_programs(folder):
    """The folder of `initdb` and `postgres`: Debian's package's, or what deploy/install-deps.sh
    unpacked, of which there is a copy in `folder` for a user who may not read this project."""
    installed = shutil.which("postgres") or next(
        iter(Path("/usr/lib/postgresql").glob("*/bin/postgres")), None)
    if installed is not None:
        return Path(installed).resolve().parent
    if not (UNPACKED / "lib/postgresql").exists():
        raise FileNotFoundError("postgres: deploy/install-deps.sh packages-test.txt")
    for part in ("lib/postgresql", "share/postgresql"):
        shutil.copytree(UNPACKED / part, folder / "usr" / part, symlinks=True)
    return next((folder / "usr/lib/postgresql").glob("*/bin"))


class Postgres:
    """A server that can be killed, stopped for a while and started again; its database `remeshd`."""

    def __init__(self, folder):
        self._folder = Path(folder)
        self._folder.mkdir(parents=True)
        self._port = free_port()
        self.address = f"postgresql://remeshd@127.0.0.1:{self._port}/postgres"
        self._user = {}
        if os.geteuid() == 0:  # for whom it does not start
            nobody = pwd.getpwnam("nobody")
            self._user = {"user": nobody.pw_uid, "group": nobody.pw_gid, "extra_groups": []}
            for folder in (self._folder, self._folder.parent):
                os.chown(folder, nobody.pw_uid, nobody.pw_gid)
        self._programs = find_programs(self._folder)
        self._data = self._folder / "data"
        self._run(self._programs / "initdb", "-D", self._data, "-U", "remeshd", "--auth=trust", "-E", "UTF8",
                  "--locale=C")
        self._process = None
        self.start()

    def _run(self, *command):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, cwd=self._folder,
                       **self._user)

    def start(self):
        with open(self._folder / "log", "ab") as log:
            self._process = subprocess.Popen(
                [self._programs / "postgres", "-D", self._data, "-p", str(self._port), "-h", "127.0.0.1",
                 "-k", ""], stdout=log, stderr=log, cwd=self._folder, **self._user)
        wait_for_port(self._port)

    def _signal(self, number):
        """To all that belongs to it: its processes have sessions of their own."""
        pid = self._process.pid
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        self._process.send_signal(number)
        for child in children:
            try:
                os.kill(int(child), number)
            except ProcessLookupError:
                pass

    def kill(self):
        """As when its machine fails."""
        self._signal(signal.SIGSTOP)  # so that it starts no other
        self._signal(signal.SIGKILL)
        self._process.wait()

    def freeze(self):
        self._signal(signal.SIGSTOP)

    def thaw(self):
        self._signal(signal.SIGCONT)

    def stop(self):
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)  # it ends without waiting for its clients
            self._process.wait()
