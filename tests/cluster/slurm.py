#!/usr/bin/python3
"""A study as a job array of Slurm, of which tasks and daemons are lost.

    PYTHONPATH=build/client/python tests/cluster/slurm.py build/bin/remeshd [--tier swift]

Debian's slurmctld, and a slurmd for each of two nodes with two processors, all on this machine, run
deploy/slurm's study: four levels of three parameters, 20 tasks, a tier that is a folder (or Swift's
bucket). Each design is evaluated for a second, with its mesh. Meanwhile a daemon is killed (kill -9);
a task with its daemon is, and put back into the queue (scontrol requeue); and a task is told that its
time ends. Exits with 1 where a design is missing, an id or a byte of a mesh differs from what one
daemon alone makes of the same plan, a job failed, a node had two daemons at once, a task was not run
again, or anything is left on a node.
"""
import argparse
import json
import os
import random
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bed import TIERS
from doe import RANGES, alone
from remesh_client.studies import plan_designs
from slurm_bed import Slurm

SCRIPTS = Path(__file__).parent.parent.parent / "deploy/slurm"
CASES = Path(__file__).parent.parent / "cases"
EVALUATE = f"""
import sys, time
sys.path.insert(0, {str(Path(__file__).parent)!r})
from loops import digest
def evaluate(part):
    time.sleep(1)  # a solver
    return digest(part.mesh())
"""


class Node:
    """The daemons that run in the scratch of tasks, found by their command lines."""

    def __init__(self, program, scratch):
        self._program, self._scratch = os.fsencode(program), scratch
        self.most = 0  # at a time in one folder

    def daemons(self):
        """Process ids by the folder's name."""
        found = {}
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = path.read_bytes().split(b"\0")
            except OSError:
                continue
            store = next((Path(os.fsdecode(word)) for word in words
                          if word.startswith(os.fsencode(self._scratch))), None)
            if words[0] == self._program and store is not None and store.name == "store":
                found.setdefault(store.parent.name, []).append(int(path.parent.name))
        self.most = max([self.most, *map(len, found.values())])
        return found


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def task_processes(job):
    """Of the job: its shell, node_daemon.py and study.py."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        try:
            if f"SLURM_JOB_ID={job}".encode() in path.read_bytes().split(b"\0"):
                found.append(int(path.parent.name))
        except OSError:
            continue
    return found


def command_of(pid):
    try:
        return Path(f"/proc/{pid}/cmdline").read_text(errors="replace")
    except OSError:
        return ""


class Losses:
    """What is lost while the array runs, each once; what was done, a line each."""

    def __init__(self, slurm, node, array, study):
        self._slurm, self._node, self._array, self._study = slurm, node, array, study
        self._left = ["daemon", "task", "time"]
        self._chance, self.lines, self.again = random.Random(1), [], []

    def cause(self):
        """The next one, where a task runs that has several designs left."""
        running = [(job, node, f"{self._array}_{task}")
                   for job, node, name, task in self._slurm.jobs("RUNNING")
                   if name == self._study.name and self._lines(task) == 1]
        running = [each for each in running if each[2] not in self.again]
        folders = {name: pids for name, pids in self._node.daemons().items()
                   if name.split("-")[2] == self._array}
        done = sum(self._lines(path.stem) for path in (self._study / "results").glob("*.jsonl"))
        if not self._left or not running or done < 8 * (4 - len(self._left)):
            return
        job, node, task = self._chance.choice(running)
        daemon = folders.get(f"remesh-{os.getuid()}-{self._array}-{node}")
        if not daemon:
            return
        what = self._left.pop(0)
        if what == "daemon":
            kill(daemon[0])
        elif what == "task":
            for pid in [daemon[0], *task_processes(job)]:
                kill(pid)
            self._requeue(task)
        else:
            # As --signal=B:USR1@60 has it. (`scancel --batch` may send it twice.)
            os.kill(next(pid for pid in task_processes(job) if "slurm_script" in command_of(pid)),
                    signal.SIGUSR1)
        if what != "daemon":
            self.again.append(task)
        self.lines.append(f"{what} lost after {done} designs, {task} on {node}")

    def _lines(self, task):
        """Designs that a task has made."""
        path = self._study / f"results/{task}.jsonl"
        return path.read_text().count("\n") if path.exists() else 0

    def _requeue(self, job):
        for _ in range(50):  # it may be about to end of what was killed
            try:
                return self._slurm.run("scontrol", "requeue", job)
            except subprocess.CalledProcessError:
                time.sleep(.1)
        raise RuntimeError(f"job {job} could not be put back into the queue")

    @property
    def missing(self):
        return self._left


def write_study(folder, case, nodes, levels, tasks):
    steps = {name: [round(first + (last - first) * k / (levels - 1), 6) for k in range(levels)]
             for name, (first, last) in RANGES[case].items()}
    folder.mkdir()
    (folder / "evaluate.py").write_text(EVALUATE)
    (folder / "study.json").write_text(json.dumps(
        {"model": str(CASES / f"{case}.json"), "options": {"nodes": nodes}, "levels": steps,
         "tasks": tasks, "evaluate": "evaluate.py"}))


def differences(study, program, case, nodes):
    """What is not as one daemon makes it, a line each."""
    base = json.loads((study / "base.json").read_text())
    plan = plan_designs(base["values"], base["designs"], shares=base["shares"])
    right, _ = alone(program, case, nodes, plan)
    lines = {line["design"]: line for line in map(
        json.loads, (study / "results.jsonl").read_text().splitlines())}
    return [f"design {design}: {lines.get(design)}" for design, made in enumerate(right)
            if design not in lines or made != (lines[design].get("revision"),
                                                lines[design].get("value"))]


def run(arguments, folder, tier):
    program, scratch, study = os.path.abspath(arguments.remeshd), folder / "node", folder / "study"
    scratch.mkdir()
    node, wrong = Node(program, scratch), []
    write_study(study, arguments.case, arguments.nodes, arguments.levels, arguments.tasks)
    with Slurm(folder / "slurm") as slurm:
        base, array, gather = slurm.run(
            SCRIPTS / "submit.sh", study, "--cpus-per-task=1", *arguments.sbatch, REMESHD=program,
            REMESH_SCRATCH=str(scratch), REMESH_PYTHON=sys.executable,
            PYTHONPATH=":".join(each for each in sys.path if each), **tier).split()
        losses, begun = Losses(slurm, node, array, study), time.monotonic()
        while slurm.jobs() and time.monotonic() - begun < arguments.limit:
            if not arguments.nothing_lost:
                losses.cause()
            node.daemons()
            time.sleep(.1)
        seconds = time.monotonic() - begun
        wrong += [f"job {job} ({name}) did not end" for job, _, name, _ in slurm.jobs()]
        tasks, restarts = [f"{array}_{task}" for task in range(arguments.tasks)], 0
        for job in (base, *tasks, gather):
            details = slurm.details(job)
            restarts += int(details["Restarts"])
            if details["JobState"] != "COMPLETED":
                wrong.append(f"job {job} is {details['JobState']}")
            if job in losses.again and details["Restarts"] == "0":
                wrong.append(f"job {job} was not started again")
    if losses.missing and not arguments.nothing_lost:
        wrong.append(f"nothing could be lost for {losses.missing}")
    if (study / "base.json").exists() and (study / "results.jsonl").exists():
        wrong += differences(study, program, arguments.case, arguments.nodes)
    else:
        wrong.append("there are no results")
    if node.most > 1:
        wrong.append(f"{node.most} daemons in one folder")
    if left := node.daemons():
        wrong.append(f"daemons are left: {left}")
    if left := [path.name for path in scratch.iterdir()]:
        wrong.append(f"folders are left: {left}")
    if wrong:
        wrong += [f"{path.name}: {path.read_text()[-1000:]}" for path in (study / "logs").iterdir()
                  if path.read_text()]
    designs = arguments.levels ** 3
    print(*losses.lines, f"{designs} designs by {arguments.tasks} tasks on 2 nodes, {seconds:.0f} s, "
          f"{restarts} started again: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--case", choices=RANGES, default="tool1-a")
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--tasks", type=int, default=20)
    parser.add_argument("--nodes", type=int, default=2000)
    parser.add_argument("--nothing-lost", action="store_true")
    parser.add_argument("--sbatch", action="append", default=[],
                        help="an option of it: --nothing-lost --levels 5 --tasks 2 --sbatch=--time=2 "
                             "for tasks that take longer than they may")
    parser.add_argument("--tier", choices=("folder", "swift"), default="folder")
    parser.add_argument("--limit", type=float, default=900, help="s that it may take")
    parser.add_argument("--keep", action="store_true", help="the folder with all files")
    arguments = parser.parse_args()
    folder = Path(tempfile.mkdtemp(prefix="remesh-slurm-"))
    tier = TIERS["swift"](folder / "tier") if arguments.tier == "swift" else None
    try:
        return run(arguments, folder, {} if tier is None else environment_of(tier, folder))
    finally:
        if tier is not None:
            tier.stop()
        if arguments.keep:
            print(folder)
        else:
            shutil.rmtree(folder, ignore_errors=True)


def environment_of(tier, folder):
    """The daemon's options, as submit.sh hands them on."""
    key = folder / "key"
    key.write_text(secrets.token_hex(16))
    key.chmod(0o600)
    options = ["--tier", tier.url, "--tier-key-file", str(key), *map(str, tier.options)]
    return {"REMESHD_" + name[2:].upper().replace("-", "_"): value
            for name, value in zip(options[::2], options[1::2])}


if __name__ == "__main__":
    sys.exit(main())
