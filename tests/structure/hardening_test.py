"""The programs that are installed are built as the build says (CMakeLists.txt, remeshd_harden).

usage: hardening_test.py PROGRAM...; the first is the daemon.
"""
import subprocess
import sys
import unittest

PROGRAMS = sys.argv[1:]


def read_elf(program, *what):
    return subprocess.run(["readelf", "-W", *what, program], check=True, capture_output=True,
                          text=True).stdout


class Hardening(unittest.TestCase):
    def test_addresses_are_random(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertIn("DYN", read_elf(program, "--file-header"))

    def test_what_the_loader_fills_in_is_read_only(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertIn("GNU_RELRO", read_elf(program, "--program-headers"))
                self.assertIn("NOW", read_elf(program, "--dynamic"))

    def test_the_daemon_checks_its_stack_and_its_copies(self):
        symbols = read_elf(PROGRAMS[0], "--dyn-syms")
        self.assertIn("__stack_chk_fail", symbols)
        self.assertRegex(symbols, r"__\w+_chk@")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
