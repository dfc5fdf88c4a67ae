#!/usr/bin/python3
"""deploy/slurm/study.py: tasks of an array make all designs, as one daemon does. Without Slurm.

    PYTHONPATH=build/client/python tests/deploy/slurm_study_test.py build/bin/remeshd
"""
import json
import os
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import remesh_client as rc
from remesh_client.studies import plan_designs

SCRIPTS = Path(__file__).resolve().parents[2] / "deploy/slurm"
MODEL = Path(__file__).resolve().parents[1] / "cases/tool1-a.json"
REMESHD = ""
LEVELS = {"pin_radius": [4, 5], "hole_circle": [36, 34], "bore.radius": [9, 8]}
EVALUATE = """
import os
def evaluate(part):
    if os.path.exists({gate!r}):
        raise RuntimeError("the solver is ill")
    return {{"nodes": len(part.mesh().points)}}
"""


class SlurmStudyTest(unittest.TestCase):
    def setUp(self):
        self.folder = Path(tempfile.mkdtemp(prefix="study-"))
        key = self.folder / "key"
        key.write_text(secrets.token_hex(16))
        key.chmod(0o600)
        self.environment = {
            **{name: value for name, value in os.environ.items() if not name.startswith("SLURM_")},
            "REMESHD": REMESHD, "REMESH_SCRATCH": str(self.folder), "REMESHD_WORKERS": "1",
            "REMESHD_TIER": str(self.folder / "tier"), "REMESHD_TIER_KEY_FILE": str(key),
            "REMESHD_TIER_ACK": "tier", "SLURM_ARRAY_JOB_ID": "7"}
        self.tell()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def tell(self, **more):
        study = {"model": str(MODEL), "options": {"nodes": 500}, "levels": LEVELS, "tasks": 3, **more}
        (self.folder / "study.json").write_text(json.dumps(
            {name: value for name, value in study.items() if value is not None}))

    def start(self, step, task=0, threads=1):
        return subprocess.Popen(
            [sys.executable, SCRIPTS / "node_daemon.py", sys.executable, SCRIPTS / "study.py", step,
             self.folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            env={**self.environment, "SLURM_ARRAY_TASK_ID": str(task),
                 "SLURM_CPUS_PER_TASK": str(threads)})

    def run_step(self, *step, code=0):
        process = self.start(*step)
        said, _ = process.communicate()
        self.assertEqual(process.returncode, code, said)
        return said

    def results(self):
        return [json.loads(line)
                for line in (self.folder / "results.jsonl").read_text().splitlines()]

    def alone(self):
        """Ids and numbers of nodes as one daemon makes them."""
        base = json.loads((self.folder / "base.json").read_text())
        plan = plan_designs(base["values"], base["designs"], shares=base["shares"])
        with rc.local(REMESHD) as daemon:
            parts = {-1: daemon.mesh(MODEL, nodes=500, file=False)}
            for design in plan.order:
                above = parts[plan.parents[design]]
                change = plan.changes[design]
                parts[design] = above.edit(change, file=False) if change else above
            return [(parts[k].revision, parts[k].report.nodes) for k in range(len(plan.order))]

    def test_all_tasks_make_all_designs_as_one_daemon_does(self):
        self.run_step("base")
        tasks = [self.start("run", task, threads=1 + task % 2) for task in range(3)]
        for task in tasks:
            said, _ = task.communicate()
            self.assertEqual(task.returncode, 0, said)
        self.assertIn("8 of 8 designs, 0 of them failed", self.run_step("gather"))
        self.assertEqual([(line["revision"], line["figures"]["nodes"]) for line in self.results()],
                         self.alone())

    def test_a_task_that_is_told_to_end_goes_on_when_it_is_run_again(self):
        self.tell(tasks=1)
        self.run_step("base")
        path = self.folder / "results/0.jsonl"
        process = self.start("run")
        while not path.exists() or path.read_text().count("\n") < 2:
            time.sleep(.01)
        process.send_signal(signal.SIGUSR1)
        said, _ = process.communicate()
        self.assertEqual(process.returncode, 75, said)
        before = path.read_text().splitlines()
        self.assertLess(len(before), 8)
        path.write_text("\n".join(before) + '\n{"design": 7, "ta')  # and was killed as it wrote
        self.run_step("gather", code=1)
        self.assertIn(f"{8 - len(before)} designs made, 0 left", self.run_step("run"))
        self.assertEqual(path.read_text().splitlines()[:len(before)], before)
        self.run_step("gather")
        self.assertEqual([line["revision"] for line in self.results()],
                         [revision for revision, _ in self.alone()])

    def test_what_an_evaluation_gives_stands_in_the_results_and_one_that_failed_is_made_up_for(self):
        gate = self.folder / "ill"
        (self.folder / "evaluate.py").write_text(EVALUATE.format(gate=str(gate)))
        self.tell(evaluate="evaluate.py", designs=[{"pin_radius": 5}, {"pin_radius": -1}], levels=None,
                  tasks=1)
        gate.touch()
        self.run_step("base")
        self.run_step("run")
        self.run_step("gather")
        good, bad = self.results()
        self.assertEqual(good["error"]["reason"], "EVALUATION_FAILED")
        self.assertNotEqual(bad["error"]["reason"], "EVALUATION_FAILED")
        self.assertNotIn("revision", bad)
        gate.unlink()
        self.assertIn("1 designs made", self.run_step("run"))
        self.run_step("gather")
        good, _ = self.results()
        self.assertEqual(good["value"], {"nodes": good["figures"]["nodes"]})
        self.assertNotIn("error", good)

    def test_what_is_wrong_with_a_study_is_told(self):
        self.assertIn("run the step `base` first", self.run_step("run", code=1))
        self.run_step("base")
        self.tell(levels={"pin_radius": [4, 6]})
        self.assertIn("study.json has changed", self.run_step("run", code=1))
        self.tell(level={})
        self.assertIn("`level` is unknown", self.run_step("base", code=1))
        self.tell(tasks=0)
        self.assertIn("`tasks` is a whole number", self.run_step("base", code=1))
        self.tell(levels={"pin_radios": [4, 6]})
        self.assertIn("no parameter 'pin_radios'", self.run_step("base", code=1))


if __name__ == "__main__":
    REMESHD = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
