"""What deploy/image-root.sh puts into the image, made from a build folder without any container:
image_root_test.py BUILD.
"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
BUILD = TOP / "build"
PROGRAMS = ("usr/bin/remesh", "usr/bin/remeshd", "usr/libexec/remeshd/remeshd-tetgen")


class ImageRootTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name)
        subprocess.run([TOP / "deploy/image-root.sh", BUILD, cls.out], check=True)
        cls.root = cls.out / "image"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def files(self):
        return [path for path in self.root.rglob("*") if path.is_file()]

    def test_is_smaller_than_150_mb(self):
        self.assertLess(sum(path.stat().st_size for path in self.files()), 150e6)

    def test_has_the_three_programs_and_no_other(self):
        programs = {str(path.relative_to(self.root)) for path in self.files()
                    if path.stat().st_mode & 0o111 and ".so" not in path.name}
        self.assertEqual(programs, set(PROGRAMS))

    def test_has_every_library_that_the_programs_load(self):
        loader = next(self.root.glob("lib*/ld-linux*"))
        libraries = next(self.root.glob("usr/lib/*-linux-gnu"))
        for program in PROGRAMS:
            found = subprocess.run([loader, "--inhibit-cache", "--library-path", libraries, "--list",
                                    self.root / program], capture_output=True, text=True)
            self.assertEqual(found.returncode, 0, found.stderr)
            for line in found.stdout.splitlines():
                if "=>" in line:
                    self.assertIn(f"=> {self.root}/", line, program)

    def test_names_the_packages_and_their_licences(self):
        packages = [path.name for path in (self.root / "var/lib/dpkg/status.d").iterdir()]
        self.assertLessEqual({"libc6", "libgrpc29", "ca-certificates"}, set(packages))
        for package in packages:
            self.assertTrue((self.root / f"usr/share/doc/{package}/copyright").is_file(), package)

    def test_only_the_daemon_reads_its_folders(self):
        for folder in ("lib/remeshd", "run/remeshd"):
            self.assertEqual((self.out / "state" / folder).stat().st_mode & 0o777, 0o700, folder)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        BUILD = Path(sys.argv.pop(1))
    unittest.main(verbosity=2)
