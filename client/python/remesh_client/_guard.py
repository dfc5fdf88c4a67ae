# SPDX-License-Identifier: Apache-2.0
"""Runs a program for as long as the other end of the standard input is open.

    python _guard.py FOLDER PROGRAM [ARGUMENT...]

When that is closed, the program is asked to end, after some seconds made to, and FOLDER removed.
Where this process is killed, the kernel ends the program (Linux).
"""
import ctypes
import os
import select
import shutil
import signal
import subprocess
import sys
from typing import List

GRACE = 5.0  # s between SIGTERM and SIGKILL
_PR_SET_PDEATHSIG = 1


def end_with_parent() -> None:
    """Has the kernel kill this process when its parent ends; called in the child, before the
    program begins. The kernel waits for the end of the thread that forked: the parent has only
    that one."""
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


def wait_for_end(program: "subprocess.Popen[bytes]") -> None:
    """Until the program has ended, or the standard input has."""
    ended, tell_ended = os.pipe()
    os.set_blocking(tell_ended, False)
    signal.set_wakeup_fd(tell_ended)
    signal.signal(signal.SIGCHLD, lambda *_: None)
    while program.poll() is None:
        ready, _, _ = select.select([sys.stdin.fileno(), ended], [], [])
        if ended in ready:
            os.read(ended, 512)
        elif not os.read(sys.stdin.fileno(), 512):
            return


def main(arguments: List[str]) -> int:
    folder, line = arguments[0], arguments[1:]
    for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(one, signal.SIG_IGN)
    program = subprocess.Popen(line, stdin=subprocess.DEVNULL, preexec_fn=prepare)
    wait_for_end(program)
    if program.poll() is not None:  # the folder stays: its log tells why
        return program.returncode or 1
    program.terminate()
    try:
        program.wait(GRACE)
    except subprocess.TimeoutExpired:
        program.kill()
        program.wait()
    shutil.rmtree(folder, ignore_errors=True)
    return 0


def prepare() -> None:
    """The program hears the signals that this process does not."""
    for one in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(one, signal.SIG_DFL)
    end_with_parent()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
