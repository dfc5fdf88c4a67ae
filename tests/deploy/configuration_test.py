"""The configurations that deploy/ gives the daemon are ones that it understands: each goes through
`remeshd --check-config`. configuration_test.py REMESHD.
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import yaml

TOP = Path(__file__).resolve().parents[2]
DEPLOY = TOP / "deploy"
REMESHD = "remeshd"


def check(arguments=(), variables=None):
    """What the daemon says of a configuration; a warning is a failure too."""
    others = {name: value for name, value in os.environ.items() if not name.startswith("REMESHD_")}
    done = subprocess.run([REMESHD, "--check-config", *map(str, arguments)], text=True,
                          env={**others, **(variables or {})}, capture_output=True)
    return done.stdout + done.stderr


def variables_of(unit):
    """The environment that a unit of systemd sets."""
    text = unit.read_text().replace("%S", "/var/lib").replace("%t", "/run")
    return dict(re.findall(r"^Environment=(\w+)=(.*)$", text, flags=re.M))


class ConfigurationTest(unittest.TestCase):
    def setUp(self):
        """Certificates where the configurations have them, for their files must be there."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tls = Path(folder.name)
        subprocess.run([DEPLOY / "make-certificates.sh", self.tls, "remeshd"], check=True)

    def moved(self, text):
        return text.replace("/etc/remeshd-tls", str(self.tls))

    def test_of_the_image(self):
        self.assertEqual(check(["--config", DEPLOY / "container.toml"]), "OK\n")

    def test_of_kubernetes(self):
        config = self.tls / "remeshd.toml"
        config.write_text(self.moved((DEPLOY / "kubernetes/base/remeshd.toml").read_text()))
        self.assertEqual(check(["--config", config]), "OK\n")

    def make_secrets(self):
        for name, text in (("farm.key", "0123456789abcdef\n"), ("s3-credentials", "ACCESS SECRET\n"),
                           ("pgpass", "postgres:5432:remeshd:remeshd:secret\n")):
            (self.tls / name).write_text(text)
            (self.tls / name).chmod(0o600)

    def test_of_a_farm_on_kubernetes(self):
        config = self.tls / "remeshd.toml"
        config.write_text(self.moved((DEPLOY / "kubernetes/base/remeshd.toml").read_text()))
        text = (DEPLOY / "kubernetes/overlays/replicas/sharing.env").read_text()
        variables = dict(re.findall(r"^(REMESHD_\w+)=(.*)$", text, flags=re.M))
        self.assertIn("REMESHD_TIER", variables)
        self.assertEqual(self.check_of_farm(["--config", config], variables), "OK\n")

    def test_of_a_farm_by_compose(self):
        text = (DEPLOY / "cluster/compose.yaml").read_text()
        service = yaml.safe_load(text)["services"]["replica-1"]
        self.assertEqual(self.check_of_farm(["--config", DEPLOY / "container.toml"],
                                            service["environment"]), "OK\n")

    def check_of_farm(self, arguments, variables):
        """With the secrets of a farm where this test has them."""
        self.make_secrets()
        moved = {name: re.sub("/etc/remeshd-(farm|catalogue)|/run/secrets", str(self.tls), value)
                 for name, value in variables.items()}
        return check(arguments, moved)

    def test_of_compose(self):
        service = yaml.safe_load((DEPLOY / "compose.yaml").read_text())["services"]["remeshd"]
        variables = {name: self.moved(value) for name, value in service["environment"].items()}
        self.assertEqual(check(["--config", DEPLOY / "container.toml"], variables), "OK\n")

    def test_of_the_systemd_unit(self):
        variables = variables_of(DEPLOY / "remeshd.service")
        self.assertIn("REMESHD_STORE", variables)
        self.assertEqual(check(variables=variables), "OK\n")

    def test_of_the_systemd_unit_with_certificates(self):
        added = variables_of(DEPLOY / "remeshd.service.d/tls.conf")
        self.assertIn("REMESHD_TLS_KEY", added)
        added = {name: self.moved(value) for name, value in added.items()}
        self.assertEqual(check(variables={**variables_of(DEPLOY / "remeshd.service"), **added}), "OK\n")

    def test_unknown_options_are_seen(self):
        self.assertNotEqual(check(variables={"REMESHD_STORES": "/var/lib"}), "OK\n")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        REMESHD = sys.argv.pop(1)
    unittest.main(verbosity=2)
