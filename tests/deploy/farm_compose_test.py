"""deploy/cluster/compose.yaml brought up by one command: all services become healthy, a study runs
through the farm to its end though a replica is killed on the way, names are in PostgreSQL, and the
page is served.

Run by deploy/test-image.sh --farm, which builds the images: farm_compose_test.py IMAGE. By docker-compose on
podman's socket, as root. Two lines of the file are left out: `name`, which Debian's docker-compose
does not know, and `ulimits`, which take a right that a container may lack. Where systemd is missing,
podman has no timers for health checks; a thread runs them.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.error
import urllib.request
from pathlib import Path

from container import CASES, environment, podman

CLUSTER = Path(__file__).resolve().parents[2] / "deploy/cluster"
IMAGE = "remeshd"
PROJECT = "remeshd-farm-test"
PAGE = "http://127.0.0.1:8080"
DESIGNS = 90


def get(path):
    """The text there; throws with the status where that is not 200."""
    with urllib.request.urlopen(f"{PAGE}/{path}", timeout=10) as answer:
        return answer.read().decode()


class FarmComposeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = Path(cls.folder.name)
        podman("tag", IMAGE, "docker.io/library/remeshd")
        podman("tag", f"{IMAGE}-study", "docker.io/library/remeshd-study")
        text = (CLUSTER / "compose.yaml").read_text()
        text = re.sub(r"^name: .*\n", "", text, flags=re.M)
        cls.file = folder / "compose.yaml"
        cls.file.write_text(re.sub(r"^  ulimits:\n    nofile: .*\n", "", text, flags=re.M))
        cls.socket = f"unix://{folder}/podman.sock"
        cls.service = subprocess.Popen(["podman", "system", "service", "--time=0", cls.socket],
                                       env=environment(), stderr=subprocess.DEVNULL)
        cls.ended = threading.Event()
        cls.checks = threading.Thread(target=cls.check_health, daemon=True)
        cls.checks.start()
        try:
            cls.compose("up", "--detach", "--no-build", timeout=300)
        except BaseException:
            cls.tearDownClass()
            raise

    @classmethod
    def tearDownClass(cls):
        cls.compose("down", "--volumes", "--timeout", "20", check=False, timeout=200)
        cls.ended.set()
        cls.checks.join()
        for each in ("remeshd", "remeshd-study"):
            podman("untag", f"docker.io/library/{each}", f"docker.io/library/{each}", check=False)
        cls.service.terminate()
        cls.service.wait()
        cls.folder.cleanup()

    @classmethod
    def compose(cls, *arguments, check=True, timeout=100):
        done = subprocess.run(
            ["docker-compose", "--file", cls.file, "--project-directory", CLUSTER, "--project-name",
             PROJECT, *arguments], capture_output=True, text=True, timeout=timeout,
            env={**os.environ, "DOCKER_HOST": cls.socket, "NGINX_IMAGE": f"{IMAGE}-nginx",
                 "POSTGRES_IMAGE": f"{IMAGE}-postgres", "STUDY_OPTIONS":
                 f"--nodes 2000 --loop 5 --vary pin_radius=4:5.5:{DESIGNS // 9}"
                 " --vary hole_circle=36:33:3 --vary bore.radius=9:7.5:3"})
        if check and done.returncode != 0:
            raise AssertionError(f"docker-compose {arguments}: {done.returncode}\n{done.stderr}")
        return done

    @classmethod
    def check_health(cls):
        while not cls.ended.wait(1):
            for name in podman("ps", "--format", "{{.Names}}", "--filter",
                               f"name={PROJECT}").stdout.split():
                podman("healthcheck", "run", name, check=False)

    def wait_for(self, seen, told, seconds=200):
        limit = time.monotonic() + seconds
        while not seen():
            self.assertLess(time.monotonic(), limit, told())
            time.sleep(.5)

    @staticmethod
    def study():
        try:
            return json.loads(get("study.json"))
        except urllib.error.HTTPError:  # it has not begun
            return {"done": 0, "state": "none"}

    def test_1_the_page_is_served_with_what_it_reads(self):
        self.assertIn("page.js", get(""))
        for name in json.loads(get("farm.json"))["replicas"]:
            self.assertIn("\nremeshd_ready 1\n", get(f"metrics/{name}"))

    def test_2_a_study_ends_though_a_replica_is_killed(self):
        self.wait_for(lambda: self.study()["done"] >= DESIGNS // 4, self.study)
        podman("kill", "--signal", "KILL", f"{PROJECT}_replica-1_1")
        podman("stop", f"{PROJECT}_replica-1_1", check=False)  # else it would be back at once
        with self.assertRaises(urllib.error.HTTPError) as refused:
            get("metrics/replica-1")
        self.assertIn(refused.exception.code, (502, 504))
        self.wait_for(lambda: self.study()["state"] == "finished", self.study)
        told = self.study()
        self.assertEqual((told["done"], told["failed"], told["designs"]), (DESIGNS, 0, DESIGNS))

    def test_3_a_replica_that_comes_back_serves(self):
        self.compose("start", "replica-1")
        self.wait_for(lambda: podman("exec", f"{PROJECT}_replica-1_1", "/usr/bin/remeshd", "--health",
                                     check=False).returncode == 0, lambda: "not ready")
        self.wait_for(self.replica_is_seen, lambda: "its metrics are not served", 60)

    @staticmethod
    def replica_is_seen():
        """By the gateway, which may hold on for a while to where the one before it was."""
        try:
            return "\nremeshd_ready 1\n" in get("metrics/replica-1")
        except urllib.error.HTTPError:
            return False

    def test_4_every_replica_knows_a_design_that_one_made(self):
        def remesh(replica, *arguments):
            return podman("run", "--rm", "--no-healthcheck", "--network", f"{PROJECT}_inside",
                          "--entrypoint", "/usr/bin/remesh", "--volume", f"{CASES}:/cases:ro",
                          "--tmpfs", "/out:mode=1777", IMAGE, "--address", f"{replica}:50051",
                          *arguments, check=False)
        made = remesh("replica-0", "mesh", "/cases/tool1-a.json", "--nodes", "2000", "-o", "/out/a.vtu")
        self.assertEqual(made.returncode, 0, made.stderr)
        for replica in ("replica-1", "replica-2"):
            self.assertIn("tool1-a@1", remesh(replica, "log", "tool1-a").stdout)

    def test_5_replicas_reach_nobody_outside(self):
        """The network `inside` has no way out: there is no default route."""
        routes = podman("exec", f"{PROJECT}_tier_1", "cat", "/proc/net/route").stdout.splitlines()[1:]
        self.assertTrue(routes)
        self.assertNotIn("00000000", [route.split()[1] for route in routes])


if __name__ == "__main__":
    if len(sys.argv) > 1:
        IMAGE = sys.argv.pop(1)
    unittest.main(verbosity=2)
