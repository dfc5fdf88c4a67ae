"""Containers of the image under test, through podman."""
import json
import subprocess
import time
from pathlib import Path

CASES = Path(__file__).resolve().parents[1] / "cases"
USER = 65532

# Debian's defaults ask for limits that only a process with CAP_SYS_RESOURCE may set, and for a
# runtime and a service that a machine without systemd lacks.
PODMAN = ["podman", "--runtime", "runc", "--cgroup-manager=cgroupfs"]
LIMITS = ["--ulimit", "nofile=20000:20000", "--ulimit", "nproc=4096:4096"]
# What deploy/README.md tells to give: nothing but the volume can be written to.
LOCKED = ["--read-only", "--cap-drop", "all", "--security-opt", "no-new-privileges",
          "--network", "none"]


def podman(*arguments, check=True):
    """Runs podman; its result, with what it printed as text."""
    done = subprocess.run([*PODMAN, *arguments], capture_output=True, text=True)
    if check and done.returncode != 0:
        raise AssertionError(f"podman {' '.join(arguments)}: {done.returncode}\n{done.stderr}")
    return done


class Container:
    """A running container with a volume for the store, the test cases at /cases and a folder of
    this machine at /out."""

    def __init__(self, name, image, volume, out, extra=()):
        self.name = name
        podman("run", "--detach", "--name", name, *LOCKED, *LIMITS,
               "--volume", f"{volume}:/var/lib/remeshd",
               "--volume", f"{CASES}:/cases:ro", "--volume", f"{out}:/out", image, *extra)

    def remove(self):
        podman("rm", "--force", self.name, check=False)

    def run(self, *command, check=True):
        return podman("exec", self.name, *command, check=check)

    def remesh(self, *arguments, check=True):
        return self.run("/usr/bin/remesh", *arguments, check=check)

    def health(self):
        return self.run("/usr/bin/remeshd", "--health", check=False).returncode

    def wait_until_ready(self):
        """Throws with the container's log if it is not ready within a minute."""
        limit = time.monotonic() + 60
        while self.health() != 0:
            if time.monotonic() > limit or not self.state()["Running"]:
                raise AssertionError(f"{self.name} does not become ready:\n{self.log()}")
            time.sleep(0.2)

    def state(self):
        return json.loads(podman("inspect", self.name).stdout)[0]["State"]

    def log(self):
        done = podman("logs", self.name, check=False)
        return done.stdout + done.stderr

    def stop(self):
        """Asks it to end by SIGTERM, SIGKILL follows after 30 s; its exit code."""
        podman("stop", "--time", "30", self.name)
        return self.state()["ExitCode"]

    def process(self):
        """/proc/PID/status of its first process, as seen by this machine."""
        status = Path(f"/proc/{self.state()['Pid']}/status").read_text()
        return dict(line.split(":\t", 1) for line in status.splitlines())
