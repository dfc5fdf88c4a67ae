"""The image, built and run: what is in it, with which rights it runs, and that it does its work.

Run by deploy/test-image.sh, which builds it: image_test.py IMAGE. Needs podman and root.
"""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import uuid
from pathlib import Path

from container import CASES, USER, Container, environment, ledge, podman, start

DEPLOY = Path(__file__).resolve().parents[2] / "deploy"
IMAGE = "remeshd"


class ImageTest(unittest.TestCase):
    """What is in it."""

    @classmethod
    def setUpClass(cls):
        cls.facts = json.loads(podman("image", "inspect", IMAGE).stdout)[0]
        cls.root = Path(podman("image", "mount", IMAGE).stdout.strip())

    @classmethod
    def tearDownClass(cls):
        podman("image", "umount", IMAGE, check=False)

    def test_is_smaller_than_150_mb(self):
        print(f"\nimage: {self.facts['Size'] / 1e6:.1f} MB", file=sys.stderr)
        self.assertLess(self.facts["Size"], 150e6)

    def test_runs_as_a_user_that_is_not_root(self):
        self.assertEqual(self.facts["Config"]["User"], f"{USER}:{USER}")

    def test_asks_the_daemon_itself_for_its_health(self):
        self.assertEqual(self.facts["Healthcheck"]["Test"], ["CMD", "/usr/bin/remeshd", "--health"])

    def test_tells_version_revision_date_and_licence(self):
        labels = self.facts["Labels"]
        for name in ("title", "description", "version", "revision", "created", "licenses"):
            self.assertTrue(labels.get(f"org.opencontainers.image.{name}"), name)

    def test_has_the_three_programs_and_no_other(self):
        programs = set()
        for path in self.root.rglob("*"):
            if path.is_file() and not path.is_symlink() and path.stat().st_mode & 0o111:
                if ".so" not in path.name:
                    programs.add(str(path.relative_to(self.root)))
        self.assertEqual(programs, {"usr/bin/remesh", "usr/bin/remeshd",
                                    "usr/libexec/remeshd/remeshd-tetgen"})

    def test_has_nothing_that_gives_rights(self):
        for path in self.root.rglob("*"):
            if path.is_file() and not path.is_symlink():
                self.assertFalse(path.stat().st_mode & 0o6022, path)

    def test_carries_the_licence_and_those_of_what_it_links(self):
        docs = self.root / "usr/share/doc"
        self.assertTrue((docs / "remeshd/LICENSE").is_file())
        packages = [entry.name for entry in (self.root / "var/lib/dpkg/status.d").iterdir()]
        self.assertIn("libc6", packages)
        for package in packages:
            self.assertTrue((docs / package / "copyright").is_file(), package)


class ContainerTest(unittest.TestCase):
    """A container that meshes."""

    @classmethod
    def setUpClass(cls):
        name = f"remeshd-test-{uuid.uuid4().hex[:8]}"
        cls.volume = name
        cls.out = Path(tempfile.mkdtemp())
        os.chown(cls.out, USER, USER)
        podman("volume", "create", cls.volume)
        cls.containers = []
        try:
            cls.container = cls.another()
        except BaseException:
            cls.tearDownClass()
            raise

    @classmethod
    def another(cls):
        """One container more on the same volume, once it is ready."""
        name = f"{cls.volume}-{len(cls.containers)}"
        cls.containers.append(Container(name))
        start(name, IMAGE, cls.volume, cls.out).wait_until_ready()
        return cls.containers[-1]

    @classmethod
    def tearDownClass(cls):
        for container in cls.containers:
            container.remove()
        podman("volume", "rm", "--force", cls.volume, check=False)
        shutil.rmtree(cls.out)

    def test_1_runs_without_any_right(self):
        process = self.container.process()
        self.assertEqual(process["Uid"].split(), [str(USER)] * 4)
        self.assertEqual(process["Gid"].split(), [str(USER)] * 4)
        for capabilities in ("CapInh", "CapPrm", "CapEff", "CapBnd", "CapAmb"):
            self.assertEqual(int(process[capabilities], 16), 0, capabilities)
        self.assertEqual(process["NoNewPrivs"], "1")

    def test_2_has_a_root_that_cannot_be_written_to(self):
        done = self.container.remesh("mesh", "/cases/fig8-a.json", "--local", "--nodes", "60",
                                     "-o", "/usr/mesh.vtu", check=False)
        self.assertEqual(done.returncode, 8, done.stderr)
        self.assertIn("Read-only file system", done.stderr)

    def test_3_answers_the_health_check_of_the_image(self):
        self.assertEqual(podman("healthcheck", "run", self.container.name).returncode, 0)

    def test_4_logs_json(self):
        lines = self.container.log().splitlines()
        self.assertTrue(lines)
        for line in lines:
            self.assertIsInstance(json.loads(line), dict, line)

    def test_5_meshes_edits_and_keeps_the_revisions_over_a_restart(self):
        self.container.remesh("mesh", "/cases/tool1-a.json", "-o", "/out/a.vtu")
        self.container.remesh("edit", "tool1-a", "/cases/tool1-ac.edit.json",
                              "-o", "/out/ac.vtu", "--json", "/out/ac.json")
        report = json.loads((self.out / "ac.json").read_text())
        self.assertGreater(report["tets_kept"], report["tets"] / 2)
        log = self.container.remesh("log", "tool1-a").stdout
        self.assertIn("tool1-a@2", log)

        self.assertEqual(self.container.stop(), 0, self.container.log())
        type(self).container = self.another()

        self.assertEqual(self.container.remesh("log", "tool1-a").stdout, log)
        self.container.remesh("get", "tool1-a@2", "-o", "/out/again.vtu")
        self.assertEqual((self.out / "again.vtu").read_bytes(), (self.out / "ac.vtu").read_bytes())

    def test_6_finds_the_tetgen_helper(self):
        (self.out / "ledge.json").write_text(ledge())
        self.container.remesh("mesh", "/out/ledge.json", "--nodes", "3000", "--even",
                              "-o", "/out/t.vtu", "--json", "/out/t.json")
        self.assertEqual(json.loads((self.out / "t.json").read_text())["way"], "WAY_TETGEN")

    def test_7_does_a_job_of_the_farm(self):
        artefacts = self.out / "artefacts"
        job = subprocess.run([DEPLOY / "ci-job.sh", self.container.name, artefacts,
                              CASES / "tool1-a.json", DEPLOY / "demo/pins-5.edit.json"],
                             capture_output=True, text=True, env=environment())
        self.assertEqual(job.returncode, 0, job.stderr)
        self.assertEqual({each.name for each in artefacts.iterdir()},
                         {"tool1-a.vtu", "tool1-a.json", "pins-5.edit.vtu", "pins-5.edit.json",
                          "revisions.txt"})
        self.assertEqual(len((artefacts / "revisions.txt").read_text().splitlines()), 2)

    def test_8_is_not_healthy_where_the_daemon_does_not_run(self):
        done = podman("run", "--rm", "--no-healthcheck", "--network", "none", IMAGE, "--health",
                      check=False)
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_8_comes_back_after_it_was_killed(self):
        before = self.container.remesh("log", "tool1-a").stdout
        podman("kill", "--signal", "KILL", self.container.name)
        podman("wait", self.container.name)
        podman("start", self.container.name)
        self.container.wait_until_ready()
        self.assertEqual(self.container.remesh("log", "tool1-a").stdout, before)

    def test_9_ends_by_sigterm_with_exit_code_0(self):
        self.assertEqual(self.container.stop(), 0, self.container.log())


if __name__ == "__main__":
    if len(sys.argv) > 1:
        IMAGE = sys.argv.pop(1)
    unittest.main(verbosity=2)
