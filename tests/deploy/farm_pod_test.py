"""Two pods of deploy/kubernetes/overlays/replicas under podman, over a tier and a PostgreSQL beside them:
what one made the other continues, and the names of designs are both's.

Run by deploy/test-image.sh --farm, which builds the images: farm_pod_test.py IMAGE. Needs podman, openssl,
root. In the place of the bucket stands nginx, over HTTP without signatures, as podman's pods have no
way to it by TLS; so the three options of the tier that belong to S3 are others here.
"""
import secrets
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import uuid
from pathlib import Path

import manifests
import pod
from container import CASES, USER, Container, podman

IMAGE = "remeshd"
TOP = Path(__file__).resolve().parents[2]
CLUSTER = TOP / "deploy/cluster"


class FarmPodTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.network = f"remeshd-test-{uuid.uuid4().hex[:8]}"
        cls.folder = Path(tempfile.mkdtemp())
        cls.names = [f"{cls.network}-{number}" for number in range(2)]
        try:
            podman("network", "create", cls.network)
            cls.make_secrets()
            cls.start_services()
            for name in cls.names:
                cls.play(name)
        except BaseException:
            cls.tearDownClass()
            raise

    @classmethod
    def make_secrets(cls):
        tls, farm, catalogue = (cls.folder / name for name in ("tls", "farm", "catalogue"))
        subprocess.run([TOP / "deploy/make-certificates.sh", tls, *cls.names], check=True)
        for folder in (farm, catalogue):
            folder.mkdir()
        (farm / "farm.key").write_text(secrets.token_hex(32))
        (catalogue / "password").write_text(secrets.token_hex(16))
        shutil.copy(tls / "ca.crt", catalogue / "ca.crt")
        cls.secrets = {"remeshd-tls": tls, "remeshd-farm": farm, "remeshd-catalogue": catalogue}
        (farm / "farm.key").chmod(0o440)
        subprocess.run(["chown", "-R", f"{USER}:{USER}", cls.folder], check=True)
        # PostgreSQL proves by the same authority that it is the one that is meant.
        server = cls.folder / "postgres"
        server.mkdir()
        shutil.copy(tls / "ca.crt", server)
        shutil.copy(tls / "ca.key", server)
        subprocess.run([TOP / "deploy/make-certificates.sh", server, "postgres"], check=True)
        (server / "ca.key").unlink()
        shutil.copy(catalogue / "password", server / "password")
        subprocess.run(["chmod", "-R", "a+rX", server], check=True)

    @classmethod
    def start_services(cls):
        tier = cls.folder / "tier"
        for each in ("objects", "temp"):
            (tier / each).mkdir(parents=True)
        subprocess.run(["chown", "-R", f"{USER}:{USER}", tier], check=True)
        on = ["--detach", "--network", cls.network]
        podman("run", *on, "--name", f"{cls.network}-tier", "--network-alias", "tier",
               "--user", f"{USER}:{USER}", "--read-only", "--tmpfs", "/tmp",
               "--volume", f"{CLUSTER}/nginx-main.conf:/etc/nginx/nginx.conf:ro",
               "--volume", f"{CLUSTER}/tier.conf:/etc/nginx/remeshd/tier.conf:ro",
               "--volume", f"{tier}:/var/lib/tier", f"{IMAGE}-nginx", "nginx", "-g", "daemon off;")
        # Its key is to be its own alone, so it is copied before it starts.
        podman("run", *on, "--name", f"{cls.network}-postgres", "--network-alias", "postgres",
               "--env", "POSTGRES_USER=remeshd", "--env", "POSTGRES_DB=remeshd",
               "--env", "POSTGRES_PASSWORD_FILE=/server/password", "--user", "postgres",
               "--env", "POSTGRES_INITDB_ARGS=--auth-host=scram-sha-256",
               "--volume", f"{cls.folder}/postgres:/server:ro", "--entrypoint", "sh",
               f"{IMAGE}-postgres", "-c",
               "install -m 600 /server/tls.* /tmp && exec postgres-entrypoint.sh -c ssl=on"
               " -c ssl_cert_file=/tmp/tls.crt -c ssl_key_file=/tmp/tls.key")
        limit = time.monotonic() + 60
        while podman("exec", f"{cls.network}-postgres", "pg_isready", "--host", "127.0.0.1",
                     check=False).returncode != 0:
            if time.monotonic() > limit or not Container(f"{cls.network}-postgres").state()["Running"]:
                raise AssertionError(podman("logs", f"{cls.network}-postgres", check=False).stderr)
            time.sleep(.2)

    @classmethod
    def play(cls, name):
        shared = manifests.rendered("replicas")["ConfigMap remeshd-farm"]["data"]
        text = pod.pod(IMAGE, name, cls.secrets, "replicas", {
            "REMESHD_TIER": "http://tier:8081/objects", "REMESHD_TIER_S3_REGION": None,
            "REMESHD_TIER_S3_CREDENTIALS_FILE": None,
            "REMESHD_CATALOGUE": shared["REMESHD_CATALOGUE"].replace("@postgres.postgres.svc/",
                                                                     "@postgres/")})
        file = cls.folder / f"{name}.yaml"
        file.write_text(text)
        podman("play", "kube", "--network", cls.network, file)
        Container(f"{name}-remeshd").wait_until_ready()

    @classmethod
    def tearDownClass(cls):
        for name in cls.names:
            podman("play", "kube", "--down", cls.folder / f"{name}.yaml", check=False)
            podman("volume", "rm", "--force", f"{name}-store", f"{name}-run", check=False)
        for each in ("tier", "postgres"):
            podman("rm", "--force", "--volumes", f"{cls.network}-{each}", check=False)
        podman("network", "rm", "--force", cls.network, check=False)
        for key, each in manifests.rendered("replicas").items():
            if key.startswith("ConfigMap "):
                podman("volume", "rm", "--force", each["metadata"]["name"], check=False)
        shutil.rmtree(cls.folder)

    def remesh(self, name, *arguments):
        """The command line with a certificate, asking one pod; its result."""
        return podman("run", "--rm", "--no-healthcheck", "--network", self.network, "--entrypoint",
                      "/usr/bin/remesh", "--volume", f"{self.folder}/tls:/tls:ro",
                      "--volume", f"{CASES}:/cases:ro", "--tmpfs", "/out:mode=1777", IMAGE,
                      "--address", f"{name}:50051", "--tls-ca", "/tls/ca.crt", "--tls-cert",
                      "/tls/client.crt", "--tls-key", "/tls/client.key", *arguments, check=False)

    def succeeds(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_1_the_probes_of_the_statefulset_succeed(self):
        container = manifests.container(manifests.rendered("replicas"))
        for name in self.names:
            for probe in ("startupProbe", "readinessProbe", "livenessProbe"):
                done = Container(f"{name}-remeshd").run(*container[probe]["exec"]["command"],
                                                        check=False)
                self.assertEqual(done.returncode, 0, f"{name} {probe}: {done.stdout}{done.stderr}")

    def test_2_any_pod_continues_what_one_began(self):
        first, second = self.names
        self.succeeds(self.remesh(first, "mesh", "/cases/tool1-a.json", "--nodes", "2000",
                                  "-o", "/out/a.vtu"))
        self.succeeds(self.remesh(second, "edit", "tool1-a", "--set", "pin_radius=5",
                                  "-o", "/out/b.vtu"))
        self.assertIn("tool1-a@2", self.succeeds(self.remesh(first, "log", "tool1-a")))

    def test_3_what_they_share_is_in_the_tier(self):
        objects = [each for each in (self.folder / "tier/objects").rglob("*") if each.is_file()]
        self.assertTrue(objects)
        kinds = {each.relative_to(self.folder / "tier/objects").parts[0] for each in objects}
        self.assertLessEqual({"recipe", "pack"}, kinds)

    def test_4_a_pod_that_is_lost_with_its_volume_is_missed_by_nobody(self):
        first, second = self.names
        before = self.succeeds(self.remesh(first, "log", "tool1-a"))
        podman("play", "kube", "--down", self.folder / f"{first}.yaml")
        podman("volume", "rm", "--force", f"{first}-store")
        self.assertEqual(self.succeeds(self.remesh(second, "log", "tool1-a")), before)
        self.succeeds(self.remesh(second, "edit", "tool1-a@1", "--set", "pin_radius=4.5",
                                  "-o", "/out/c.vtu"))
        self.play(first)
        self.assertIn("tool1-a@3", self.succeeds(self.remesh(first, "log", "tool1-a")))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        IMAGE = sys.argv.pop(1)
    unittest.main(verbosity=2)
