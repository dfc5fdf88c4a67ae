"""Facts about deploy/compose.yaml."""
import unittest
from pathlib import Path

import yaml

COMPOSE = Path(__file__).resolve().parents[2] / "deploy/compose.yaml"


class ComposeTest(unittest.TestCase):
    def setUp(self):
        self.compose = yaml.safe_load(COMPOSE.read_text())
        self.service = self.compose["services"]["remeshd"]

    def test_builds_the_image_of_this_tree(self):
        build = self.service["build"]
        self.assertTrue((COMPOSE.parent / build["context"] / build["dockerfile"]).is_file())

    def test_can_write_to_the_store_alone(self):
        self.assertIs(self.service["read_only"], True)
        writable = [each for each in self.service["volumes"] if not each.endswith(":ro")]
        self.assertEqual(writable, ["store:/var/lib/remeshd"])
        self.assertIn("store", self.compose["volumes"])

    def test_has_no_right(self):
        self.assertEqual(self.service["cap_drop"], ["ALL"])
        self.assertEqual(self.service["security_opt"], ["no-new-privileges:true"])
        self.assertNotIn("privileged", self.service)

    def test_is_limited(self):
        for limit in ("mem_limit", "cpus", "pids_limit", "ulimits"):
            self.assertIn(limit, self.service)

    def test_serves_this_machine_alone(self):
        for port in self.service["ports"]:
            self.assertTrue(port.startswith("127.0.0.1:"), port)


if __name__ == "__main__":
    unittest.main(verbosity=2)
