#!/usr/bin/python3
"""Two of the paper's cases through the daemon, small enough for every test run: validity only."""
import sys
import unittest

from cases import CASES
from comparison import compare
from daemon import Daemon

BINARIES = sys.argv.pop(1)


class PaperCases(unittest.TestCase):
    def test_remesh_and_regular_run_are_valid(self):
        with Daemon(BINARIES) as daemon:
            for case in CASES:
                if case.name in ("simple-ab", "tool1-ac"):
                    with self.subTest(case=case.name):
                        run = compare(daemon, case, nodes=8000, iterations=5, seed=1)
                        self.assertEqual([], run.faults)
                        self.assertLess(run.count_error(), 0.03)
                        self.assertGreater(run.remesh["nodes_kept"], 0.5 * run.remesh["nodes"])
                        self.assertLess(run.remesh["free_share"], 0.5)


if __name__ == "__main__":
    unittest.main()
