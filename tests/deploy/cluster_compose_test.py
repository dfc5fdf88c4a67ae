"""Facts about deploy/cluster: compose.yaml, and what its services read."""
import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import yaml

import monitoring
from programs import program

CLUSTER = Path(__file__).resolve().parents[2] / "deploy/cluster"
NGINX = shutil.which("nginx") or "/usr/sbin/nginx"
REPLICAS = ("replica-0", "replica-1", "replica-2")


class ComposeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.compose = yaml.safe_load((CLUSTER / "compose.yaml").read_text())
        cls.services = cls.compose["services"]

    def test_has_what_a_farm_needs_and_no_more(self):
        self.assertEqual(set(self.services),
                         {*REPLICAS, "prepare", "tier", "postgres", "gateway", "study"})

    def test_builds_from_this_tree(self):
        for name in (*REPLICAS, "study"):
            build = self.services[name]["build"]
            self.assertTrue((CLUSTER / build["context"] / build["dockerfile"]).is_file(), name)

    def test_images_of_others_are_named_by_variables(self):
        for name in ("prepare", "tier", "postgres", "gateway"):
            self.assertRegex(self.services[name]["image"], r"^\$\{[A-Z]+_IMAGE:-.+\}$", name)

    def test_no_service_has_a_right_or_a_root_that_it_can_write_to(self):
        for name, service in self.services.items():
            self.assertIs(service["read_only"], True, name)
            self.assertEqual(service["cap_drop"], ["ALL"], name)
            self.assertEqual(service["security_opt"], ["no-new-privileges:true"], name)
            self.assertNotIn("privileged", service, name)
            if name != "prepare":  # makes volumes others'
                self.assertNotIn("cap_add", service, name)

    def test_every_service_that_stays_is_limited(self):
        for name in set(self.services) - {"prepare"}:
            for limit in ("mem_limit", "cpus", "pids_limit", "restart"):
                self.assertIn(limit, self.services[name], name)

    def test_what_others_wait_for_has_a_health_check(self):
        for name, service in self.services.items():
            for other, how in service.get("depends_on", {}).items():
                if how["condition"] == "service_healthy" and other not in REPLICAS:  # the image's
                    self.assertIn("healthcheck", self.services[other], f"{name} {other}")

    def test_serves_this_machine_alone(self):
        published = {name: service["ports"] for name, service in self.services.items()
                     if "ports" in service}
        self.assertEqual(list(published), ["gateway"])
        for port in published["gateway"]:
            self.assertTrue(port.startswith("127.0.0.1:"), port)

    def test_only_the_gateway_is_on_a_network_with_a_way_out(self):
        self.assertIs(self.compose["networks"]["inside"]["internal"], True)
        for name, service in self.services.items():
            self.assertIs("outside" in service["networks"], name == "gateway", name)

    def test_each_replica_has_a_store_of_its_own(self):
        stores = [volume.split(":")[0] for name in REPLICAS
                  for volume in self.services[name]["volumes"] if volume.endswith("/remeshd")]
        self.assertEqual(len(set(stores)), 3, stores)

    def test_no_secret_is_written_down(self):
        text = (CLUSTER / "compose.yaml").read_text()
        self.assertNotRegex(text, r"POSTGRES_PASSWORD:|//\w+:\w+@")

    def test_addresses_that_are_given_out_are_none_of_the_fixed_ones(self):
        [network] = self.compose["networks"]["inside"]["ipam"]["config"]
        self.assertIn(".128/25", network["ip_range"])
        for name in REPLICAS:
            address = self.services[name]["networks"]["inside"]["ipv4_address"]
            self.assertLess(int(address.rpartition(".")[2]), 128)
            self.assertIn(f"{name}.remeshd:{address}", self.services["gateway"]["extra_hosts"])

    def test_files_that_are_mounted_are_there(self):
        for name, service in self.services.items():
            for volume in service["volumes"]:
                source = volume.split(":")[0]
                if source.startswith("."):
                    self.assertTrue((CLUSTER / source).exists(), f"{name} {source}")
                else:
                    self.assertIn(source, self.compose["volumes"], name)


class NginxTest(unittest.TestCase):
    """Of the gateway and the tier."""

    def test_understands_its_files(self):
        for files in (("nginx.conf", "page.conf"), ("tier.conf",)):
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                (folder / "remeshd").mkdir()
                for each in ("nginx-main.conf", *files):
                    text = (CLUSTER / each).read_text()
                    text = re.sub(r"replica-\d\.remeshd", "127.0.0.1", text)
                    text = text.replace("/tmp/", f"{folder}/").replace("/etc/nginx/remeshd", f"{folder}/farm")
                    text = text.replace("/var/lib/tier", str(folder))
                    (folder / "remeshd" / each if each in files else folder / each).write_text(text)
                done = subprocess.run([NGINX, "-t", "-p", folder, "-c", folder / "nginx-main.conf"],
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_page_knows_the_replicas_of_compose(self):
        text = (CLUSTER / "page.conf").read_text()
        farm = json.loads(re.search(r"return 200 '(.*)'", text)[1])
        self.assertEqual(farm["replicas"], list(REPLICAS))
        self.assertEqual(re.findall(r"location = /metrics/(\S+)", text), list(REPLICAS))
        services = yaml.safe_load((CLUSTER / "compose.yaml").read_text())["services"]
        for name in REPLICAS:
            self.assertEqual(int(services[name]["environment"]["REMESHD_WORKERS"]), farm["workers"])


class PageTest(unittest.TestCase):
    def test_metrics_that_it_reads_are_the_server_s(self):
        text = (CLUSTER / "page/page.js").read_text()
        self.assertLessEqual(monitoring.metrics(text), monitoring.registered_metrics())

    def test_takes_nothing_from_elsewhere(self):
        for file in (CLUSTER / "page").iterdir():
            for address in re.findall(r"https?://[^\s\"'`]+", file.read_text()):
                self.assertEqual(address, "http://www.w3.org/2000/svg", file.name)


@unittest.skipUnless(os.geteuid() == 0, "makes files others'")
class PrepareTest(unittest.TestCase):
    def test_makes_secrets_once_and_for_who_reads_them(self):
        if subprocess.run(["id", "postgres"], capture_output=True).returncode != 0:
            self.skipTest("no user postgres")
        with tempfile.TemporaryDirectory() as name:
            folders = [Path(name) / each for each in ("replicas", "postgres", "tier", "study")]
            for each in folders:
                each.mkdir()
            replicas, postgres, tier, _ = folders
            made = []
            for _ in range(2):
                subprocess.run([program("sh"), CLUSTER / "prepare.sh", *folders], check=True)
                made.append([file.read_text() for file in
                             (replicas / "farm.key", replicas / "pgpass", postgres / "password")])
            self.assertEqual(made[0], made[1])
            key, passwords, password = made[0]
            self.assertRegex(key, "^[0-9a-f]{64}$")
            self.assertRegex(password, "^[0-9a-f]{64}$")
            self.assertEqual(passwords, f"postgres:5432:remeshd:remeshd:{password}\n")
            for file in (replicas / "farm.key", replicas / "pgpass", postgres / "password"):
                self.assertEqual(file.stat().st_mode & 0o777, 0o600, file)
            self.assertEqual((replicas / "farm.key").stat().st_uid, 65532)
            self.assertEqual((tier / "objects").stat().st_uid, 65532)


if __name__ == "__main__":
    unittest.main(verbosity=2)
