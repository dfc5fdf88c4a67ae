"""Facts about deploy/remeshd.service, as far as they can be told without starting it."""
import re
import tempfile
import unittest
from pathlib import Path

from programs import program, run

UNIT = Path(__file__).resolve().parents[2] / "deploy/remeshd.service"


class ServiceTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        # The programs need not be installed here, and verify asks whether they can be started.
        cls.unit = Path(cls.folder.name) / UNIT.name
        cls.unit.write_text(re.sub(r"^(Exec\w+)=\S+", rf"\1={program('true')}", UNIT.read_text(),
                                   flags=re.M))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_systemd_finds_nothing_wrong(self):
        # An unknown key is a warning on stderr and no failure.
        self.assertEqual(run("systemd-analyze", "verify", self.unit, with_messages=True), "")

    def test_has_few_rights(self):
        # 10 is a service without any restriction; 1.4 when this was written.
        run("systemd-analyze", "security", "--no-pager", "--offline=true", "--threshold=15", self.unit)

    def test_has_a_store_that_it_may_write_to(self):
        text = UNIT.read_text()
        self.assertIn("StateDirectory=remeshd\n", text)
        self.assertIn("Environment=REMESHD_STORE=%S/remeshd\n", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
