"""The programs that the tests of deploy/ call."""
import os
import shutil
import subprocess
from pathlib import Path

# Where deploy/install-deps.sh unpacks what it does not install.
UNPACKED = Path(__file__).resolve().parents[2] / "build/tools/usr/bin"


def program(name):
    """Its path; throws where it is missing, for a check that is left out must not look passed."""
    path = shutil.which(name, path=f"{os.environ['PATH']}{os.pathsep}{UNPACKED}")
    if path is None:
        raise AssertionError(f"{name} is missing: deploy/install-deps.sh packages-test.txt")
    return path


def run(name, *arguments, with_messages=False):
    """What it printed on stdout, and on stderr where asked for; throws with all of it where it
    fails."""
    done = subprocess.run([program(name), *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{name} {' '.join(map(str, arguments))}: {done.returncode}\n"
                             f"{done.stdout}{done.stderr}")
    return done.stdout + (done.stderr if with_messages else "")
