#!/usr/bin/python3
"""Runs a command beside this node's daemon, which all tasks of a job array on a node share.

    node_daemon.py COMMAND [ARGUMENT...]

The daemon listens on a Unix socket in a folder of this user and job in the node's local scratch, has
its store there, and is told to the command as REMESH_ADDRESS. Its options are REMESHD_... of the
environment. Of several tasks on a node, one runs the daemon, and the others wait for a lock that it
holds. So that scheduler and limits see it as part of a job, it ends with the task that runs it, or
with that task's kill -9; whoever gets the lock then starts the next one, of the same store, and
clients send again what was not answered. Who leaves last waits until the tier has all, ends the
daemon, and removes the folder.

    REMESHD         program; default: `remeshd` on PATH
    REMESH_SCRATCH  local folder of the node; default: SLURM_TMPDIR, TMPDIR, /tmp
    REMESH_SHARE    `job`: the array's tasks on a node share a daemon (default); `task`: none do
    REMESH_FLUSH    s that the last one waits for the tier at most (60)

The exit code is the command's; 69 where no daemon starts.
"""
import ctypes
import fcntl
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

NO_DAEMON = 69  # EX_UNAVAILABLE
START = 60.0  # s within which the daemon has to answer
STOP = 30.0  # s within which it has to end
EARLY, MOST_EARLY = 2.0, 3  # a daemon that ends within so many s, so many times, does not start
PAUSE = .05  # s
LONGEST_SOCKET = 107  # bytes, of Linux
PR_SET_PDEATHSIG = 1


class Failed(Exception):
    """There is no daemon; says why."""


def folder_of(environment):
    """Where tasks that share a daemon meet."""
    scratch = next(filter(None, map(environment.get, ("REMESH_SCRATCH", "SLURM_TMPDIR", "TMPDIR"))),
                   "/tmp")
    share = environment.get("REMESH_SHARE", "job")
    if share not in ("job", "task"):
        raise Failed(f"REMESH_SHARE={share} is neither `job` nor `task`")
    job = environment.get("SLURM_JOB_ID", "0")
    if share == "job":
        job = environment.get("SLURM_ARRAY_JOB_ID", job)
    # A scratch that nodes share by mistake has a folder for each.
    node = environment.get("SLURMD_NODENAME") or os.uname().nodename.partition(".")[0]
    folder = Path(os.path.abspath(scratch)) / f"remesh-{os.getuid()}-{job}-{node}"
    if len(os.fsencode(folder / "socket")) > LONGEST_SOCKET:
        raise Failed(f"{folder} is too long a path for a Unix socket: set REMESH_SCRATCH")
    return folder


class Membership:
    """Of the tasks in a folder, which is made for the first. Lets go of it however this process ends."""

    def __init__(self, folder):
        self._folder = folder
        while True:
            self._make_folder()
            try:
                self._users = os.open(folder / "users", os.O_RDWR | os.O_CREAT, 0o600)
            except FileNotFoundError:
                continue  # who left last has just removed it
            fcntl.flock(self._users, fcntl.LOCK_SH)
            try:
                if os.path.samestat(os.fstat(self._users), os.stat(folder / "users")):
                    return
            except FileNotFoundError:
                pass
            os.close(self._users)

    def _make_folder(self):
        """One that others made beforehand, in a scratch for all, is none of ours."""
        try:
            self._folder.mkdir(mode=0o700)
        except FileExistsError:
            found = self._folder.lstat()
            if found.st_uid != os.geteuid() or found.st_mode & 0o170077 != 0o040000:
                raise Failed(f"{self._folder} is not a folder of this user alone") from None
        except OSError as why:
            raise Failed(f"{self._folder} cannot be made: {why.strerror}; set REMESH_SCRATCH") from why

    def leave(self):
        """Whether this was the last one; nobody else comes in then until this process ends."""
        fcntl.flock(self._users, fcntl.LOCK_UN)
        return locked(self._users)


def locked(descriptor):
    """Whether it could be had at once."""
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True


def end_with(parent):
    """To be called in a child: has it end when its parent does, kill -9 or not."""
    def prepare():
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
        if os.getppid() != parent:
            os._exit(1)  # it has ended before
    return prepare


class NodeDaemon:
    """The daemon in a folder, run by this process or by another one."""

    def __init__(self, program, folder):
        self._program, self._folder = program, folder
        self.address = f"unix:{folder / 'socket'}"
        self._process, self._since, self._early = None, 0.0, 0

    def tend(self):
        """Runs it where no other task does. Raises Failed where it does not start."""
        if self._process is not None:
            if self._process.poll() is None:
                return
            self._process = None
            self._early = self._early + 1 if time.monotonic() - self._since < EARLY else 0
            if self._early >= MOST_EARLY:
                raise Failed("the daemon does not start:\n" + self._last_lines())
        # The process that holds the lock is the daemon, which inherits it.
        lock = os.open(self._folder / "daemon.lock", os.O_RDWR | os.O_CREAT, 0o600)
        try:
            if locked(lock):
                self._start(lock)
        finally:
            os.close(lock)

    def _start(self, lock):
        self._since = time.monotonic()
        with open(self._folder / "log", "ab") as log:
            try:
                self._process = subprocess.Popen(
                    [self._program, "--listen", self.address, "--store", self._folder / "store"],
                    stdin=subprocess.DEVNULL, stdout=log, stderr=log, pass_fds=[lock],
                    preexec_fn=end_with(os.getpid()))
            except OSError as why:
                raise Failed(f"{self._program} cannot be started: {why.strerror}") from why

    def wait_for(self):
        """Until it answers. Raises Failed."""
        until = time.monotonic() + START
        while True:
            self.tend()
            asked = subprocess.run([self._program, "--health", self.address],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            if asked.returncode == 0:
                return
            if time.monotonic() > until:
                raise Failed(f"the daemon does not answer within {START:g} s:\n"
                             + self._last_lines())
            time.sleep(PAUSE)

    def flush(self, seconds):
        """Until the tier has all, or that long; what it has not got, counted."""
        until = time.monotonic() + seconds
        while (left := self._waiting()) and time.monotonic() < until:
            self.tend()
            time.sleep(PAUSE)
        return left

    def _waiting(self):
        return sum(path.is_file() for path in (self._folder / "store/outbox").rglob("*"))

    def stop(self):
        """Ends it where this process runs it."""
        if self._process is None:
            return
        self._process.terminate()
        try:
            self._process.wait(STOP)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._process = None

    def wait_for_others(self):
        """Until one that another task runs has ended."""
        until = time.monotonic() + STOP
        with open(self._folder / "daemon.lock", "ab") as lock:
            while not locked(lock) and time.monotonic() < until:
                time.sleep(PAUSE)

    def _last_lines(self):
        try:
            lines = (self._folder / "log").read_text("utf-8", "replace").splitlines()
        except OSError:
            return ""
        return "\n".join(dict.fromkeys(lines[-10:]))


class Command:
    """The command, which hears the signals that this process does."""

    def __init__(self):
        self._process, self.ending = None, False
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGUSR1, signal.SIGUSR2):
            signal.signal(number, self._pass_on)

    def _pass_on(self, number, _):
        self.ending = self.ending or number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP)
        if self._process is not None:
            self._process.send_signal(number)
        elif self.ending:
            sys.exit(128 + number)

    def start(self, line, address):
        try:
            self._process = subprocess.Popen(line, env={**os.environ, "REMESH_ADDRESS": address},
                                             preexec_fn=end_with(os.getpid()))
        except OSError as why:
            raise Failed(f"{line[0]} cannot be started: {why.strerror}") from why

    def runs(self):
        return self._process.poll() is None

    def code(self):
        code = self._process.wait()
        return code if code >= 0 else 128 - code

    def stop(self):
        if self._process is not None and self.runs():
            self._process.terminate()
            self._process.wait()


def run_beside(daemon, line):
    """The exit code of the command."""
    command = Command()
    try:
        daemon.wait_for()
        command.start(line, daemon.address)
        while command.runs():
            if not command.ending:  # the scheduler ends the daemon too then
                daemon.tend()
            time.sleep(PAUSE)
        return command.code()
    finally:
        command.stop()


def leave(daemon, membership, folder, seconds):
    last = membership.leave()
    try:
        if last and (left := daemon.flush(seconds)):
            print(f"node_daemon.py: the tier has not got {left} objects; meshes among them are made "
                  "again where they are asked for", file=sys.stderr)
    finally:
        daemon.stop()
    if last:
        daemon.wait_for_others()
        shutil.rmtree(folder, ignore_errors=True)


def main(line):
    if not line or line[0].startswith("-"):
        print(__doc__, file=sys.stdout if line[:1] in (["-h"], ["--help"]) else sys.stderr)
        return 0 if line else 2
    try:
        folder = folder_of(os.environ)
        membership = Membership(folder)
        daemon = NodeDaemon(os.environ.get("REMESHD", "remeshd"), folder)
        try:
            return run_beside(daemon, line)
        finally:
            leave(daemon, membership, folder, float(os.environ.get("REMESH_FLUSH", "60")))
    except Failed as why:
        print(f"node_daemon.py: {why}", file=sys.stderr)
        return NO_DAEMON


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
