#!/usr/bin/python3
"""deploy/slurm/node_daemon.py: tasks on a node share a daemon, however each of them ends.

    PYTHONPATH=build/client/python tests/deploy/node_daemon_test.py build/bin/remeshd
"""
import fcntl
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

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cluster"))
from bed import FaultyTier

SCRIPT = Path(__file__).resolve().parents[2] / "deploy/slurm/node_daemon.py"
MODEL = Path(__file__).resolve().parents[1] / "cases/tool1-a.json"
REMESHD = ""
# Tells its address and waits for the file that lets it go.
TASK = """
import os, pathlib, sys, time
told, release, code = sys.argv[1:]
pathlib.Path(told + ".part").write_text(os.environ["REMESH_ADDRESS"] + " " + str(os.getpid()))
os.rename(told + ".part", told)
while not os.path.exists(release):
    time.sleep(.01)
sys.exit(int(code))
"""


def wait_for(what, seconds=30):
    until = time.monotonic() + seconds
    while not (found := what()):
        if time.monotonic() > until:
            raise AssertionError(f"{what} is not so after {seconds} s")
        time.sleep(.02)
    return found


def open_files(pid):
    try:
        return [os.readlink(path) for path in Path(f"/proc/{pid}/fd").iterdir()]
    except OSError:
        return []


class NodeDaemonTest(unittest.TestCase):
    def setUp(self):
        self.scratch = Path(tempfile.mkdtemp(prefix="node-"))
        self.folder = self.scratch / f"remesh-{os.getuid()}-7-here"
        self.environment = {
            **{name: value for name, value in os.environ.items() if not name.startswith("SLURM_")},
            "REMESHD": REMESHD, "REMESH_SCRATCH": str(self.scratch), "SLURM_ARRAY_JOB_ID": "7",
            "SLURMD_NODENAME": "here",
            "REMESHD_WORKERS": "1", "REMESHD_GRACE": "1"}
        self.tasks, self.count = [], 0

    def tearDown(self):
        for task in self.tasks:
            task.release.touch()
        for task in self.tasks:
            task.wait()
        self.assertEqual(self.daemons(), [])
        shutil.rmtree(self.scratch)

    def start(self, code=0, **environment):
        self.count += 1
        told, release, errors = (self.scratch / f"{name}{self.count}"
                                 for name in ("told", "release", "errors"))
        with open(errors, "w", encoding="utf-8") as stderr:
            task = subprocess.Popen(
                [sys.executable, SCRIPT, sys.executable, "-c", TASK, told, release, str(code)],
                env={**self.environment, **environment}, stderr=stderr)
        task.told, task.release, task.errors = told, release, errors
        self.tasks.append(task)
        return task

    def began(self, task):
        """Its address, once its command runs."""
        wait_for(lambda: task.told.exists() or task.poll() is not None)
        return task.told.read_text().split()[0]

    def let_go(self, task):
        task.release.touch()
        return task.wait(30)

    def daemons(self):
        """Process ids of daemons with a store in the scratch."""
        found = []
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = path.read_bytes().split(b"\0")
            except OSError:
                continue
            if os.fsencode(REMESHD) == words[0] and any(
                    word.startswith(os.fsencode(self.scratch)) for word in words):
                found.append(int(path.parent.name))
        return found

    def answers(self, address):
        return subprocess.run([REMESHD, "--health", address], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode == 0

    def test_tasks_at_the_same_time_share_one_that_goes_with_the_last(self):
        tasks = [self.start() for _ in range(3)]
        addresses = {self.began(task) for task in tasks}
        self.assertEqual(addresses, {f"unix:{self.folder}/socket"})
        self.assertEqual(len(self.daemons()), 1)
        for number, task in enumerate(tasks):
            self.assertTrue(self.answers(*addresses))
            self.assertEqual(self.let_go(task), 0)
            if number < 2:  # it may have been the one that ran the daemon
                wait_for(lambda: self.answers(*addresses))
                self.assertEqual(len(self.daemons()), 1)
        self.assertEqual(self.daemons(), [])
        self.assertFalse(self.folder.exists())

    def test_one_that_is_killed_is_started_again(self):
        task = self.start()
        address, (daemon,) = self.began(task), self.daemons()
        os.kill(daemon, signal.SIGKILL)
        wait_for(lambda: self.daemons() not in ([], [daemon]) and self.answers(address))
        self.assertEqual(self.let_go(task), 0)

    def test_a_task_that_is_killed_leaves_nothing_and_another_one_takes_over(self):
        first = self.start()
        address, (daemon,) = self.began(first), self.daemons()
        second = self.start()
        self.began(second)
        command = int(first.told.read_text().split()[1])
        first.kill()
        wait_for(lambda: not Path(f"/proc/{command}").exists())
        wait_for(lambda: self.daemons() not in ([], [daemon]) and self.answers(address))
        self.assertEqual(len(self.daemons()), 1)
        self.let_go(second)
        self.assertFalse(self.folder.exists())

    def test_tasks_come_and_go_at_any_time(self):
        for _ in range(4):
            tasks = [self.start(code) for code in range(4)]
            for code, task in enumerate(tasks):
                task.release.touch()
                time.sleep(.03)
            self.assertEqual([task.wait(60) for task in tasks], [0, 1, 2, 3])
        self.assertFalse(self.folder.exists())

    def test_a_task_may_come_while_the_last_one_leaves(self):
        self.folder.mkdir(mode=0o700)
        with open(self.folder / "users", "w", encoding="utf-8") as users:
            fcntl.flock(users, fcntl.LOCK_EX)  # this is the last one
            task = self.start()
            wait_for(lambda: str(self.folder / "users") in open_files(task.pid))
            time.sleep(.1)
            shutil.rmtree(self.folder)
        self.assertTrue(self.answers(self.began(task)))
        self.assertEqual(self.let_go(task), 0)

    def test_a_signal_reaches_the_command(self):
        task = self.start()
        self.began(task)
        task.terminate()
        self.assertEqual(task.wait(30), 128 + signal.SIGTERM)
        self.assertFalse(self.folder.exists())

    def test_tasks_of_two_nodes_share_none(self):
        tasks = [self.start(SLURMD_NODENAME=node) for node in ("here", "there")]
        self.assertEqual(len({self.began(task) for task in tasks}), 2)
        self.assertEqual(len(self.daemons()), 2)

    def test_a_task_may_have_one_of_its_own(self):
        tasks = [self.start(REMESH_SHARE="task", SLURM_JOB_ID=str(job)) for job in (8, 9)]
        self.assertEqual(len({self.began(task) for task in tasks}), 2)
        self.assertEqual(len(self.daemons()), 2)

    def test_the_tier_gets_all_before_the_last_one_leaves(self):
        key = self.scratch / "key"
        key.write_text(secrets.token_hex(16))
        key.chmod(0o600)
        tier = FaultyTier()
        task = self.start(REMESHD_TIER=tier.url, REMESHD_TIER_KEY_FILE=str(key))
        with rc.connect(self.began(task)) as daemon:
            part = daemon.mesh(MODEL, nodes=500, file=False)
            wait_for(lambda: len(tier.objects) == 2)
            tier.mode = "silent"
            made = [part.revision, part.edit(pin_radius=5, file=False).revision]
        task.release.touch()
        time.sleep(1)
        tier.mode = "well"
        self.assertEqual(task.wait(60), 0)
        tier.stop()
        self.assertEqual(sorted(key.rpartition("/")[2] for key in tier.list()), sorted(made * 2))

    def refused(self, said, **environment):
        task = self.start(**environment)
        self.assertEqual(task.wait(30), 69)
        self.assertIn(said, task.errors.read_text())
        self.assertFalse(task.told.exists())

    def test_a_daemon_that_does_not_start_says_why(self):
        self.refused("REMESHD_WORKERZ", REMESHD_WORKERZ="1")
        self.refused("none/remeshd cannot be started", REMESHD="none/remeshd")

    def test_a_folder_that_others_may_write_to_is_refused(self):
        self.folder.mkdir()
        self.folder.chmod(0o777)
        self.refused("is not a folder of this user alone")

    def test_a_scratch_that_does_not_do_is_refused(self):
        self.refused("too long a path", REMESH_SCRATCH="/" + 100 * "x")
        self.refused("cannot be made: No such file", REMESH_SCRATCH=str(self.scratch / "none"))
        self.refused("neither `job` nor `task`", REMESH_SHARE="node")


if __name__ == "__main__":
    REMESHD = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
