#!/usr/bin/python3
"""A design study by the tasks of a job array; one of its steps.

    study.py base FOLDER     # the base's mesh, what each parameter costs, who makes which design
    study.py run FOLDER      # the designs of one task: SLURM_ARRAY_TASK_ID
    study.py gather FOLDER   # one file of all results

FOLDER is on the shared file system and has study.json:

    {"model": "bracket.json", "options": {"nodes": 8000}, "levels": {"hole_radius": [8, 9, 10], "stiffener": [6, 8]}}

`levels` are all combined; or `designs` lists what each sets, [{"hole_radius": 8}, ...]. `depth`: most edits
between the base and a design (8). `tasks`: of the array (20). `evaluate`: a Python file with a function
evaluate(part), whose numbers by name stand in the results; it alone fetches meshes.

Designs are remeshed from each other along a plan that depends on the base and the designs alone. A
task makes what it needs of others' designs too, where the tier has not got it yet: revisions are named
by what they are made of, so nobody makes another mesh. Results are lines of JSON in results/N.jsonl
with the ids of revisions, never meshes. A task that is run again goes on after the last of its lines.
SIGUSR1 and SIGTERM have it end after the design that it is at, with exit code 75 where some are left.
"""
import argparse
import importlib.util
import itertools
import json
import os
import signal
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import remesh_client as rc
from remesh_client.studies import figures_of, plan_designs, tried_values, values_in

LEFT = 75  # EX_TEMPFAIL: run it again
PATIENCE = 120.0  # s for which a daemon that another task takes over is waited for
EVALUATION = "EVALUATION_FAILED"  # such a design is evaluated again when its task is run again
PASSING = (rc.Unavailable, rc.Busy, rc.Cancelled, rc.NotFound)  # another try may mend it


class StudyError(Exception):
    """Something is wrong with the study's files; says what."""


class Study:
    """The files of a study."""

    def __init__(self, folder):
        self.folder = Path(folder)
        try:
            told = json.loads((self.folder / "study.json").read_text(encoding="utf-8"))
        except (OSError, ValueError) as why:
            raise StudyError(f"{self.folder / 'study.json'} cannot be read: {why}") from why
        unknown = set(told) - {"model", "options", "levels", "designs", "depth", "tasks", "evaluate"}
        if unknown or "model" not in told or ("levels" in told) == ("designs" in told):
            raise StudyError("study.json has `model` and either `levels` or `designs`"
                             + "".join(f"; `{name}` is unknown" for name in sorted(unknown)))
        if not isinstance(told.get("tasks", 1), int) or told.get("tasks", 1) < 1:
            raise StudyError("study.json: `tasks` is a whole number from 1")
        self.model, self.options = self.folder / told["model"], told.get("options", {})
        self.depth, self.tasks = told.get("depth", 8), told.get("tasks", 20)
        self.evaluate = self.folder / told["evaluate"] if "evaluate" in told else None
        self.designs = told["designs"] if "designs" in told else [
            dict(zip(told["levels"], values)) for values in itertools.product(*told["levels"].values())]
        self.base_file = self.folder / "base.json"

    def base(self):
        """What the first step found."""
        try:
            found = json.loads(self.base_file.read_text(encoding="utf-8"))
        except (OSError, ValueError) as why:
            raise StudyError(f"run the step `base` first: {why}") from why
        if found["designs"] != self.designs:
            raise StudyError("study.json has changed: run the step `base` again")
        return found

    def plan(self, base):
        return plan_designs(base["values"], self.designs, depth=self.depth, shares=base["shares"])

    def results(self, task):
        return self.folder / "results" / f"{task}.jsonl"


def write_whole(path, text):
    """Nobody sees half of it."""
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    part.write_text(text, encoding="utf-8")
    part.replace(path)


def with_retries(work):
    """What a failure that passes does not end at once."""
    until = time.monotonic() + PATIENCE
    while True:
        try:
            return work()
        except PASSING as why:
            if time.monotonic() > until or isinstance(why, rc.NotFound):
                raise
            time.sleep(why.retry_after or 1.0)


def edited(part, change):
    """The same part where nothing changes."""
    return with_retries(lambda: part.edit(change, file=False, mesh=False)) if change else part


def make_base(study):
    with rc.connect(patience=PATIENCE) as daemon:
        part = with_retries(lambda: daemon.mesh(study.model, file=False, with_mesh=False,
                                                **study.options))
        names = sorted({name for design in study.designs for name in design})
        values = values_in(part.document(), names)
        shares = {}
        tried = tried_values(values, study.designs)
        for change in tried if len(tried) > 1 else []:
            try:
                report = edited(part, change).report
            except PASSING:
                raise
            except rc.RemeshError:
                continue  # what it costs is not known
            shares |= {name: 1 - report.nodes_kept / report.nodes for name in change}
    write_whole(study.base_file, json.dumps({
        "revision": part.revision, "values": values, "shares": shares, "designs": study.designs,
        "figures": figures_of(part.report)}, indent=1) + "\n")
    print(f"{len(study.designs)} designs of {part.revision}")
    return 0


def load_evaluate(path):
    if path is None:
        return lambda part: None
    spec = importlib.util.spec_from_file_location("evaluate", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.evaluate


class Results:
    """The lines of one task, whichever thread adds them."""

    def __init__(self, path):
        path.parent.mkdir(exist_ok=True)
        whole = [line for line in path.read_text().splitlines(True) if line.endswith("\n")] \
            if path.exists() else []
        self.made = {line["design"] for line in map(json.loads, whole)
                     if line.get("error", {}).get("reason") != EVALUATION}
        write_whole(path, "".join(whole))  # half a line was written last
        self._file, self._lock = open(path, "a", encoding="utf-8"), threading.Lock()

    def add(self, line):
        with self._lock:
            self._file.write(json.dumps(line) + "\n")
            self._file.flush()
            os.fsync(self._file.fileno())
            self.made.add(line["design"])


class Maker:
    """Makes designs and what they are made of, by a connection of its own."""

    def __init__(self, daemon, base, plan):
        self._plan = plan
        self._base = with_retries(lambda: daemon.open(base["revision"]))
        self._parts = {-1: self._base}  # a Part, or the error that there is none for

    def make(self, design):
        """Raises RemeshError."""
        path = []
        while design not in self._parts:
            path.append(design)
            design = self._plan.parents[design]
        for design in reversed(path):
            above = self._parts[self._plan.parents[design]]
            try:
                self._parts[design] = (
                    edited(self._base, self._plan.from_base[design])
                    if isinstance(above, Exception) else edited(above, self._plan.changes[design]))
            except PASSING:
                raise
            except rc.RemeshError as why:
                self._parts[design] = why
        if isinstance(self._parts[design], Exception):
            raise self._parts[design]
        return self._parts[design]


def line_of(part, value):
    line = {"revision": part.revision, "parent": part.parent,
            "way": part.report.Way.Name(part.report.way)[4:],
            "warnings": [each.code for each in part.warnings], "figures": figures_of(part.report)}
    return line if value is None else {**line, "value": value}


def error_of(reason, why):
    return {"error": {"reason": reason, "message": str(why)}}


def told(maker, design, evaluate):
    """What the line of a design says. Raises what another try may mend."""
    try:
        part = maker.make(design)
    except PASSING:
        raise
    except rc.RemeshError as why:
        return error_of(why.reason, why)
    try:
        return line_of(part, evaluate(part))
    except PASSING:
        raise
    except Exception as why:  # pylint: disable=broad-except
        return {**line_of(part, None), **error_of(EVALUATION, repr(why))}


def blocks(order, count):
    """Designs one after another share what they are made of, so each has a run of them."""
    return [order[k * len(order) // count:(k + 1) * len(order) // count] for k in range(count)]


def run_task(study, task, ended):
    base = study.base()
    plan, evaluate = study.plan(base), load_evaluate(study.evaluate)
    if not 0 <= task < study.tasks:
        raise StudyError(f"task {task} is none of the {study.tasks} of study.json")
    results = Results(study.results(task))
    mine = [each for each in blocks(plan.order, study.tasks)[task] if each not in results.made]
    threads = max(1, min(len(mine), int(os.environ.get("SLURM_CPUS_PER_TASK", "1"))))

    def run_block(designs):
        with rc.connect(patience=PATIENCE) as daemon:
            maker = Maker(daemon, base, plan)
            for design in designs:
                if ended.is_set():
                    return
                results.add({"design": design, "task": task, "values": study.designs[design],
                             **told(maker, design, evaluate)})

    with ThreadPoolExecutor(threads) as pool:
        for done in [pool.submit(run_block, block) for block in blocks(mine, threads)]:
            done.result()
    left = sum(each not in results.made for each in mine)
    print(f"task {task}: {len(mine) - left} designs made, {left} left")
    return LEFT if left else 0


def gather(study):
    lines = {}
    for path in sorted((study.folder / "results").glob("*.jsonl")):
        for text in path.read_text(encoding="utf-8").splitlines(True):
            if text.endswith("\n"):
                line = json.loads(text)
                lines[line["design"]] = line
    write_whole(study.folder / "results.jsonl",
                "".join(json.dumps(lines[each]) + "\n" for each in sorted(lines)))
    missing = [each for each in range(len(study.designs)) if each not in lines]
    failed = sum("error" in line for line in lines.values())
    print(f"{len(lines)} of {len(study.designs)} designs, {failed} of them failed")
    if missing:
        raise StudyError(f"designs {missing} are missing: submit the study again")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("step", choices=("base", "run", "gather"))
    parser.add_argument("folder")
    arguments = parser.parse_args()
    ended = threading.Event()
    try:
        study = Study(arguments.folder)
        if arguments.step == "base":
            return make_base(study)
        if arguments.step == "gather":
            return gather(study)
        for number in (signal.SIGUSR1, signal.SIGTERM):
            signal.signal(number, lambda *_: ended.set())
        return run_task(study, int(os.environ["SLURM_ARRAY_TASK_ID"]), ended)
    except (StudyError, rc.RemeshError, KeyError, OSError) as why:
        print(f"study.py: {why}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
