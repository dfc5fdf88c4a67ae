"""Containers of the image under test, through podman."""
import json
import os
import subprocess
import time
from pathlib import Path

SETTINGS = Path(__file__).with_name("containers.conf")
CASES = Path(__file__).resolve().parents[1] / "cases"
USER = 65532

# What deploy/CI-FARM.md tells to give: nothing but the volume can be written to.
LOCKED = ["--read-only", "--cap-drop", "all", "--security-opt", "no-new-privileges",
          "--network", "none"]


def ledge():
    """A model that only TetGen's mesh of the whole can follow, at 3,000 nodes and even sizes: tool2-c
    with a ledge far narrower than an edge."""
    model = json.loads((CASES / "tool2-c.json").read_text())
    [base] = [each for each in model["features"] if each["id"] == "base"]
    base["parameters"]["dx"] = 119.98
    return json.dumps(model)


def environment():
    """What podman is to run with."""
    return {**os.environ, "CONTAINERS_CONF": str(SETTINGS)}


def podman(*arguments, check=True):
    """Runs podman; its result, with what it printed as text."""
    done = subprocess.run(["podman", *map(str, arguments)], capture_output=True, text=True,
                          env=environment())
    if check and done.returncode != 0:
        raise AssertionError(f"podman {' '.join(map(str, arguments))}: {done.returncode}\n{done.stderr}")
    return done


class Container:
    """A running container of remeshd."""

    def __init__(self, name):
        self.name = name

    def remove(self):
        podman("rm", "--force", "--volumes", self.name, check=False)

    def run(self, *command, check=True):
        return podman("exec", self.name, *command, check=check)

    def remesh(self, *arguments, check=True):
        return self.run("/usr/bin/remesh", *arguments, check=check)

    def health(self, *arguments):
        """The exit code of the probe."""
        return self.run("/usr/bin/remeshd", "--health", *arguments, check=False).returncode

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
        """/proc/PID/status of its first process, as this machine sees it."""
        status = Path(f"/proc/{self.state()['Pid']}/status").read_text()
        return dict(line.split(":\t", 1) for line in status.splitlines())


def start(name, image, volume, out):
    """A container without rights, as deploy/CI-FARM.md tells to start it, with a volume for the
    store, the test cases at /cases and a folder of this machine at /out."""
    podman("run", "--detach", "--name", name, *LOCKED, "--volume", f"{volume}:/var/lib/remeshd",
           "--volume", f"{CASES}:/cases:ro", "--volume", f"{out}:/out", image)
    return Container(name)
