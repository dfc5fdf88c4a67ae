"""deploy/remeshd.service under a systemd that runs in a container: it starts, meshes in spite of
what the unit forbids, keeps its revisions, comes back after a crash.

Run by deploy/test-image.sh, which builds the image: systemd_test.py IMAGE. Needs podman and root.
"""
import json
import re
import subprocess
import sys
import tempfile
import time
import unittest
import uuid
from pathlib import Path

from container import CASES, environment, ledge, podman

IMAGE = "remeshd"
BASE = "localhost/remeshd-base"  # deploy/image.sh --bootstrap-only
TOP = Path(__file__).resolve().parents[2]


class SystemdTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.name = f"remeshd-test-{uuid.uuid4().hex[:8]}"
        subprocess.run(["buildah", "bud", "--quiet", "--isolation", "chroot", "--build-arg",
                        f"BASE={BASE}", "--build-arg", f"IMAGE={IMAGE}", "-t", cls.name,
                        "-f", "tests/deploy/systemd.Dockerfile", "."],
                       cwd=TOP, check=True, env=environment(), stdout=subprocess.DEVNULL)
        podman("run", "--detach", "--name", cls.name, "--privileged", "--systemd=always",
               "--network", "none", "--volume", f"{CASES}:/cases:ro", f"localhost/{cls.name}")
        try:
            cls.until(lambda: cls.run_in("systemctl", "is-system-running").strip() == "running")
            # A container may not raise its limit of open files.
            cls.run_in("mkdir", "/etc/systemd/system/remeshd.service.d")
            cls.run_in("sh", "-c", "printf '[Service]\\nLimitNOFILE=20000\\n'"
                       " >/etc/systemd/system/remeshd.service.d/limit.conf")
            cls.run_in("systemctl", "daemon-reload")
            cls.run_in("systemctl", "start", "remeshd")
        except BaseException:
            cls.tearDownClass()
            raise

    @classmethod
    def tearDownClass(cls):
        podman("rm", "--force", cls.name, check=False)
        podman("rmi", cls.name, check=False)

    @classmethod
    def run_in(cls, *command, check=False):
        return podman("exec", cls.name, *command, check=check).stdout

    @classmethod
    def until(cls, fact):
        """Waits for at most a minute."""
        limit = time.monotonic() + 60
        while not fact():
            if time.monotonic() > limit:
                raise AssertionError(cls.journal())
            time.sleep(0.2)

    @classmethod
    def journal(cls):
        return cls.run_in("journalctl", "--no-pager", "--lines=50")

    def unit(self, fact):
        return self.run_in("systemctl", "show", "--property", fact, "--value", "remeshd").strip()

    def log(self):
        return self.run_in("remesh", "log", "tool1-a", check=True)

    def test_1_is_ready_once_started(self):
        self.assertEqual(self.unit("ActiveState"), "active", self.journal())

    def test_2_has_no_right(self):
        status = self.run_in("cat", f"/proc/{self.unit('MainPID')}/status", check=True)
        process = dict(line.split(":\t", 1) for line in status.splitlines())
        self.assertNotIn("0", process["Uid"].split())
        for capabilities in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb"):
            self.assertEqual(int(process[capabilities], 16), 0, capabilities)
        self.assertEqual(process["NoNewPrivs"], "1")
        self.assertEqual(process["Seccomp"], "2")

    def test_3_meshes_and_edits(self):
        self.run_in("remesh", "mesh", "/cases/tool1-a.json", "--nodes", "3000", "-o", "/tmp/a.vtu",
                    check=True)
        self.run_in("remesh", "edit", "tool1-a", "/cases/tool1-ac.edit.json", "-o", "/tmp/b.vtu",
                    check=True)

    def test_4_starts_the_tetgen_helper(self):
        self.run_in("sh", "-c", f"cat >/tmp/ledge.json <<'END'\n{ledge()}\nEND", check=True)
        self.run_in("remesh", "mesh", "/tmp/ledge.json", "--nodes", "3000", "--even",
                    "-o", "/tmp/t.vtu", "--json", "/tmp/t.json", check=True)
        self.assertEqual(json.loads(self.run_in("cat", "/tmp/t.json"))["way"], "WAY_TETGEN")

    def test_5_reload_ends_nothing(self):
        process = self.unit("MainPID")
        self.run_in("systemctl", "reload", "remeshd", check=True)
        self.assertEqual(self.log().count("tool1-a@"), 2)
        self.assertEqual(self.unit("MainPID"), process)

    def test_6_stops_cleanly_and_finds_its_revisions_again(self):
        before = self.log()
        self.run_in("systemctl", "stop", "remeshd", check=True)
        self.assertEqual((self.unit("Result"), self.unit("ExecMainStatus")), ("success", "0"))
        self.run_in("systemctl", "start", "remeshd", check=True)
        self.assertEqual(self.log(), before)

    def test_7_comes_back_after_a_crash(self):
        before, process = self.log(), self.unit("MainPID")
        self.run_in("systemctl", "kill", "--signal", "KILL", "remeshd", check=True)
        self.until(lambda: self.unit("MainPID") not in ("0", process)
                   and self.unit("ActiveState") == "active")
        self.assertEqual(self.log(), before)

    def test_8_serves_other_machines_by_certificates(self):
        tls = "/etc/remeshd-tls"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([TOP / "deploy/make-certificates.sh", f"{folder}/tls", "localhost"],
                           check=True)
            podman("cp", f"{folder}/tls", f"{self.name}:{tls}")
        unit = TOP / "deploy/remeshd.service.d/tls.conf"
        podman("cp", unit, f"{self.name}:/etc/systemd/system/remeshd.service.d/tls.conf")
        # The commands that its head tells.
        for command in re.findall("^#   (.*)$", unit.read_text(), flags=re.M):
            self.run_in("sh", "-c", command, check=True)
        self.run_in("systemctl", "daemon-reload", check=True)
        self.run_in("systemctl", "restart", "remeshd")
        self.assertEqual(self.unit("ActiveState"), "active", self.journal())
        self.run_in("remesh", "--address", "localhost:50051", "--tls-ca", f"{tls}/ca.crt",
                    "--tls-cert", f"{tls}/client.crt", "--tls-key", f"{tls}/client.key", "info",
                    check=True)
        self.assertEqual(podman("exec", self.name, "remesh", "info", check=False).returncode, 5)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        IMAGE = sys.argv.pop(1)
    unittest.main(verbosity=2)
