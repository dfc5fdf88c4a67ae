"""deploy/kubernetes as a pod of podman: ready by its probes, reached by clients with a certificate
alone, its revisions there again in a pod that follows.

Run by deploy/test-image.sh, which builds the image: pod_test.py IMAGE. Needs podman, openssl, root.
"""
import shutil
import subprocess
import sys
import tempfile
import unittest
import uuid
from pathlib import Path

import manifests
import pod
from container import CASES, LOCKED, USER, Container, podman

IMAGE = "remeshd"
TOP = Path(__file__).resolve().parents[2]
TLS = ["--tls-ca", "/tls/ca.crt"]
CLIENT = ["--tls-cert", "/tls/client.crt", "--tls-key", "/tls/client.key"]


class PodTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.name = f"remeshd-test-{uuid.uuid4().hex[:8]}"
        cls.folder = Path(tempfile.mkdtemp())
        certificates = cls.folder / "tls"
        subprocess.run([TOP / "deploy/make-certificates.sh", certificates, "remeshd", "localhost"],
                       check=True)
        subprocess.run(["chown", "-R", f"{USER}:{USER}", cls.folder], check=True)
        cls.yaml = cls.folder / "pod.yaml"
        cls.yaml.write_text(pod.pod(IMAGE, cls.name, {"remeshd-tls": certificates}))
        cls.container = Container(f"{cls.name}-remeshd")
        try:
            cls.play()
        except BaseException:
            cls.tearDownClass()
            raise

    @classmethod
    def play(cls):
        podman("play", "kube", "--network", "none", cls.yaml)
        cls.container.wait_until_ready()

    @classmethod
    def end(cls):
        """Ends the pod. The volume that podman made of the ConfigMap goes too; the store stays."""
        podman("play", "kube", "--down", cls.yaml, check=False)
        podman("volume", "rm", "--force", manifests.rendered()["ConfigMap remeshd-config"]["metadata"]["name"],
               check=False)

    @classmethod
    def tearDownClass(cls):
        cls.end()
        podman("volume", "rm", "--force", f"{cls.name}-store", f"{cls.name}-run", check=False)
        shutil.rmtree(cls.folder)

    def remesh(self, *arguments, tls=(*TLS, *CLIENT)):
        """The command line in a container of its own beside the daemon's, as a job of the farm."""
        locked = [each for each in LOCKED if each not in ("--network", "none")]
        return podman("run", "--rm", "--no-healthcheck", *locked, "--entrypoint", "/usr/bin/remesh",
                      "--pod", self.name,
                      "--volume", f"{self.folder}/tls:/tls:ro", "--volume", f"{CASES}:/cases:ro",
                      "--tmpfs", "/out:mode=1777", IMAGE,
                      "--address", "localhost:50051", *tls, *arguments, check=False)

    def test_1_the_probes_of_the_statefulset_succeed(self):
        container = manifests.container(manifests.rendered())
        for probe in ("startupProbe", "readinessProbe", "livenessProbe"):
            done = self.container.run(*container[probe]["exec"]["command"], check=False)
            self.assertEqual(done.returncode, 0, f"{probe}: {done.stdout}{done.stderr}")

    def test_2_runs_without_any_right(self):
        process = self.container.process()
        self.assertEqual(process["Uid"].split(), [str(USER)] * 4)
        for capabilities in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb"):
            self.assertEqual(int(process[capabilities], 16), 0, capabilities)
        self.assertEqual(process["NoNewPrivs"], "1")

    def test_3_serves_who_has_a_certificate(self):
        done = self.remesh("mesh", "/cases/tool1-a.json", "--nodes", "3000", "-o", "/out/a.vtu")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_4_serves_nobody_else(self):
        for tls in ((), TLS):  # in plain text, without a certificate
            done = self.remesh("info", tls=tls)
            self.assertEqual(done.returncode, 5, f"{tls}: {done.stdout}{done.stderr}")

    def test_5_tells_its_metrics(self):
        look = ("from urllib.request import urlopen\n"
                "print(urlopen('http://127.0.0.1:50052/metrics').read().decode())")
        told = subprocess.run(["nsenter", f"--net=/proc/{self.container.state()['Pid']}/ns/net",
                               "/usr/bin/python3", "-c", look], capture_output=True, text=True)
        self.assertIn("\nremeshd_ready 1\n", told.stdout, told.stderr)

    def test_6_a_pod_that_follows_finds_the_revisions(self):
        before = self.remesh("log", "tool1-a")
        self.assertIn("tool1-a@1", before.stdout, before.stderr)
        self.end()
        self.play()
        self.assertEqual(self.remesh("log", "tool1-a").stdout, before.stdout)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        IMAGE = sys.argv.pop(1)
    unittest.main(verbosity=2)
