#!/usr/bin/python3
"""deploy/cluster/study.py: its designs, what it tells, and that a design that fails ends nothing.

    PYTHONPATH=build/client/python tests/cluster/study.py build/bin/remeshd
"""
import importlib.util
import json
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path

from bed import Replica

STUDY = Path(__file__).resolve().parents[2] / "deploy/cluster/study.py"
MODEL = Path(__file__).resolve().parents[1] / "cases/tool1-a.json"
_spec = importlib.util.spec_from_file_location("farm_study", STUDY)  # this file has its name
study = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(study)
PROGRAM = "remeshd"


def run(*arguments, **how):
    return subprocess.run([sys.executable, STUDY, *map(str, arguments)], capture_output=True,
                          text=True, timeout=120, **how)


class DesignsTest(unittest.TestCase):
    def test_neighbours_differ_in_one_parameter_by_one_step(self):
        parameters = [study.varied(each) for each in ("a=0:2:3", "b=5:3:2", "c.d=1:2:4")]
        designs = study.combinations(parameters)
        self.assertEqual(len({tuple(each.values()) for each in designs}), 24)
        steps = {name: values for name, values in parameters}
        for one, other in zip(designs, designs[1:]):
            [changed] = [name for name in one if one[name] != other[name]]
            places = [steps[changed].index(each[changed]) for each in (one, other)]
            self.assertEqual(abs(places[0] - places[1]), 1)

    def test_what_is_no_range_is_told(self):
        for wrong in ("a", "a=1:2", "a=1:2:1", "=1:2:3", "a=x:2:3"):
            done = run("--address", "localhost:1", "--progress", "none", "--vary", wrong)
            self.assertEqual(done.returncode, 2)
            self.assertIn("NAME=FIRST:LAST:LEVELS", done.stderr)

    def test_a_model_that_is_not_there_is_told(self):
        done = run("--address", "localhost:1", "--progress", "none", "--model", "none.json")
        self.assertEqual(done.returncode, 2)
        self.assertIn("none.json is no file", done.stderr)


class ProgressTest(unittest.TestCase):
    def test_the_course_of_a_long_study_stays_short(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "study.json"
            progress = study.Progress(file, designs=3000)
            for number in range(3000):
                progress._begun -= 1  # a second passes
                progress.made({"a": 1}, types.SimpleNamespace(volume=3000 - number, nodes_kept=3,
                                                              nodes=4))
                progress.write("running")
            told = json.loads(file.read_text())
        self.assertLessEqual(len(told["course"]), study.MOST_POINTS)
        self.assertGreater(len(told["course"]), study.MOST_POINTS / 3)
        for (before, less), (after, more) in zip(told["course"], told["course"][1:]):
            self.assertLess(before, after)
            self.assertLessEqual(less, more)
        self.assertEqual(told["lightest"], {"volume": 1, "values": {"a": 1}})
        self.assertEqual(told["kept"], .75)


class RunTest(unittest.TestCase):
    def test_a_design_that_cannot_be_meshed_is_counted_and_left_out(self):
        """A bore wider than the whole hub, and wider than the plate."""
        with tempfile.TemporaryDirectory() as folder:
            replica = Replica(PROGRAM, Path(folder) / "replica", ["--workers", "1"])
            try:
                file = Path(folder) / "study.json"
                done = run("--address", replica.address, "--progress", file, "--model", MODEL,
                           "--nodes", 500, "--vary", "bore.radius=9:60:2", "--vary",
                           "pin_radius=4:5:2", "--loop", 4, "--side-by-side", 1)
                self.assertEqual(done.returncode, 0, done.stderr)
                told = json.loads(file.read_text())
            finally:
                replica.stop()
        self.assertEqual((told["state"], told["done"], told["failed"]), ("finished", 2, 2))
        self.assertIn("bore.radius", done.stderr)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main(verbosity=2)
