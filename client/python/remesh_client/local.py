# SPDX-License-Identifier: Apache-2.0
"""A daemon that is started for one process and ends with it."""
from __future__ import annotations

import atexit
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Sequence

from remesh_client import _guard
from remesh_client.errors import Error, RemeshError, made_here

_START = 30.0  # s within which it must listen
_STOP = 10.0  # s for the guard to end it


def find_program(program: os.PathLike[str] | str | None = None) -> str:
    """The path of `remeshd`: as given, beside the installed package, or on PATH.

    Raises Unavailable.
    """
    if program is not None:
        found = shutil.which(os.fspath(program))
        if found is None:
            raise _not_started(f"{os.fspath(program)} is no program that can be started")
        return os.path.abspath(found)
    # PREFIX/lib/python3/dist-packages/remesh_client, PREFIX/bin/remeshd.
    beside = Path(__file__).resolve().parent / "../../../../bin/remeshd"
    found = os.path.normpath(beside) if os.access(beside, os.X_OK) else shutil.which("remeshd")
    if found is None:
        raise _not_started("there is no remeshd beside this package nor on PATH",
                           "install it, or name it: rc.local('/path/to/remeshd')")
    return found


class LocalDaemon:
    """The process; `address` once it is made. `stop` may be called several times.

    Between this process and the daemon stands a guard (`_guard.py`), which ends the daemon when
    a pipe from here is closed: the kernel does that however this process ends.
    """

    def __init__(self, program: os.PathLike[str] | str | None, options: Sequence[str]) -> None:
        found = find_program(program)
        self._folder = Path(tempfile.mkdtemp(prefix="remesh-"))
        path = self._folder / "socket"
        self.address = f"unix:{path}"
        line = [found, "--listen", self.address, "--store", str(self._folder / "store"),
                "--grace", "1", *options]
        with open(self._folder / "log", "wb") as log:
            # A session of its own: Ctrl-C at the terminal is for this process alone.
            self._guard = subprocess.Popen(
                [sys.executable, "-I", "-S", _guard.__file__, str(self._folder), *line],
                stdin=subprocess.PIPE, stdout=log, stderr=log, start_new_session=True)
        atexit.register(self.stop)
        try:
            self._wait_for(path)
        except BaseException:
            self.stop()
            raise

    def stop(self) -> None:
        """Ends the daemon and removes its folder; returns when that is done."""
        atexit.unregister(self.stop)
        if self._guard.stdin is not None and not self._guard.stdin.closed:
            self._guard.stdin.close()
        try:
            self._guard.wait(_STOP)
        except subprocess.TimeoutExpired:
            self._guard.kill()  # which ends the daemon too
            self._guard.wait()
        shutil.rmtree(self._folder, ignore_errors=True)

    def _wait_for(self, path: Path) -> None:
        last = time.monotonic() + _START
        while not _listens(path):
            if self._guard.poll() is not None:
                raise _not_started("remeshd did not start", self._said())
            if time.monotonic() > last:
                raise _not_started(f"remeshd did not listen within {_START:g} s", self._said())
            time.sleep(0.005)

    def _said(self) -> str:
        try:
            lines = (self._folder / "log").read_text("utf-8", "replace").strip().splitlines()
        except OSError:
            return ""
        return "; ".join(lines[-5:])


def _listens(path: Path) -> bool:
    """Whether somebody does: between bind and listen the socket is there, and refuses."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        return probe.connect_ex(str(path)) == 0


def _not_started(message: str, hint: str = "") -> RemeshError:
    return made_here(Error.CODE_UNAVAILABLE, message, hint=hint)
