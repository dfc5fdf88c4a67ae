#!/usr/bin/env python3
"""Runs the tests once for each fault of a mutated copy, and tells which faults they see.

run.py BUILD --record FILE [--programs test_model ...] [--folders engine/base ...] [--campaign]
run.py BUILD --record FILE --report       # prints what the record has so far

BUILD is a build of the copy (mutate.py). First every test runs by itself without a fault and must
pass; this tells its time and which faults' places it reaches. Then each fault runs with the tests
that reach it, cheap ones first, until one of them fails, crashes or takes more than ten times its
time. The record has a JSON line for each test and each fault; the same command goes on with it.
"""
import argparse
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import score

HERE = Path(__file__).resolve().parent
# The programs with the tests of each folder, the most telling first; others follow as they come.
NEAREST = [
    (("engine/base", "engine/model"), ["test_model"]),
    (("engine/kernel", "engine/delaunay", "engine/cellular", "engine/local_fuse",
      "engine/difference"), ["test_cellular"]),
    (("engine/mesh", "engine/improve"), ["test_improve"]),
    (("engine",), ["test_remesh"]),
    (("server/store",), ["test_disk", "test_server"]),
    (("server", "proto"), ["test_server"]),
    (("client",), ["test_client"]),
]
PROGRAMS = ["test_model", "test_cellular", "test_improve", "test_remesh", "test_server",
            "test_disk", "test_client"]
CAMPAIGN = ["remesh-campaign", "run", "--good-natured", "--seed", "5", "--edits", "30", "--shrink",
            "0", "--strict"]
TIERS = (0.1, 1, 10, float("inf"))  # s of a test; those of one tier run in one process a program
MOST_TESTS = 500  # of one process, for the length of its arguments
TIMES_NORMAL, GRACE = 10, 10.0  # a run may take so many times its normal time, and so many s more
FIRST_RUN = 1200.0  # s that a test without a fault may take
MOST_OUTPUT = 1 << 26  # bytes
MOST_UNSTEADY = 5  # tests that fail without a fault too, of one fault's run


@dataclass(frozen=True)
class Test:
    program: str
    name: str  # of GoogleTest; `campaign` of the campaign
    seconds: float = 0
    reached: frozenset = frozenset()


@dataclass(frozen=True)
class Ending:
    how: str  # passed, failed, crashed, hung, flooded
    test: str  # the one that failed, or that ran last
    seconds: float


class Bench:
    """Runs programs of a build, each in a process group and a folder of its own."""

    def __init__(self, programs_folder, memory_gib):
        self.folder = Path(programs_folder)
        self.memory = memory_gib << 30

    def command(self, program, tests):
        if program == CAMPAIGN[0]:
            return [str(self.folder / program), *CAMPAIGN[1:]]
        return [str(self.folder / program), "--gtest_fail_fast", "--gtest_color=no",
                "--gtest_filter=" + ":".join(tests)]

    def run(self, program, tests, limit, mutant=None, reached=None):
        environment = dict(os.environ)
        for name, value in (("MUTANT", mutant), ("MUTANTS_REACHED", reached)):
            environment.pop(name, None)
            if value is not None:
                environment[name] = str(value)
        with tempfile.TemporaryDirectory(prefix="m", ignore_cleanup_errors=True) as own, \
                tempfile.TemporaryFile() as output:
            environment["TMPDIR"] = own
            begin = time.monotonic()
            process = subprocess.Popen(
                ["prlimit", f"--as={self.memory}", "--core=0", *self.command(program, tests)],
                cwd=own, env=environment, stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                start_new_session=True)
            how = self._wait(process, output, begin + limit)
            seconds = time.monotonic() - begin
            try:
                os.killpg(process.pid, signal.SIGKILL)  # whatever it has started and left
            except ProcessLookupError:
                pass
            process.wait()
            output.seek(0)
            text = output.read(MOST_OUTPUT).decode(errors="replace")
        failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", text, re.M)
        begun = re.findall(r"^\[ RUN      \] (\S+)", text, re.M)
        test = failed[1] if failed else begun[-1] if begun else tests[0]
        return Ending(how, test, seconds)

    @staticmethod
    def _wait(process, output, end):
        while True:
            try:
                status = process.wait(timeout=0.2)
                return "passed" if status == 0 else "failed" if status > 0 else "crashed"
            except subprocess.TimeoutExpired:
                if time.monotonic() > end:
                    return "hung"
                if os.fstat(output.fileno()).st_size > MOST_OUTPUT:
                    return "flooded"

    def tests(self, program):
        listed = subprocess.run([self.folder / program, "--gtest_list_tests"], check=True,
                                capture_output=True, text=True).stdout
        suite = ""
        for line in listed.splitlines():
            name = line.split("#")[0].strip()
            if not line.startswith(" ") and name.endswith("."):
                suite = name
            elif line.startswith("  ") and suite and "DISABLED_" not in suite + name:
                yield suite + name


class Record:
    """A file of JSON lines that is added to, by any thread."""

    def __init__(self, path, mark):
        self.path = Path(path)
        self.lock = threading.Lock()
        self.lines = []
        if self.path.exists():
            whole = self.path.read_text().rpartition("\n")[0]
            self.lines = [json.loads(line) for line in whole.splitlines()]
            if not self.lines or self.lines[0] != mark:
                sys.exit(f"{path} is of other mutants; give another file")
            self.path.write_text(whole + "\n")  # without a line that was cut off
        else:
            self.add(mark)

    def add(self, line):
        with self.lock:
            self.lines.append(line)
            with self.path.open("a") as file:
                file.write(json.dumps(line) + "\n")

    def tests(self):
        return {(t["program"], t["test"]): Test(t["program"], t["test"], t["seconds"],
                                                frozenset(t["reached"]))
                for t in self.lines if "test" in t}

    def outcomes(self):
        return {line["mutant"]: line["outcome"] for line in self.lines if "mutant" in line}


def without_fault(bench, program, name, size):
    """The test as measured; None where it fails twice."""
    for _ in range(2):
        with tempfile.NamedTemporaryFile() as reached:
            reached.truncate(size)
            ending = bench.run(program, [name], FIRST_RUN, reached=reached.name)
            if ending.how == "passed":
                marks = Path(reached.name).read_bytes()
                return Test(program, name, round(ending.seconds, 3),
                            frozenset(n for n, mark in enumerate(marks) if mark))
    return None


def measure_tests(bench, programs, record, size, jobs):
    """Every test by itself without a fault; ends where one fails."""
    wanted = [(p, name) for p in programs if p != CAMPAIGN[0] for name in bench.tests(p)]
    wanted += [(p, "campaign") for p in programs if p == CAMPAIGN[0]]
    known = record.tests()
    left = [w for w in wanted if w not in known]
    failing = []

    def one(which):
        test = without_fault(bench, *which, size)
        if test is None:
            failing.append(f"{which[0]} {which[1]}")
            return
        record.add({"program": test.program, "test": test.name, "seconds": test.seconds,
                    "reached": sorted(test.reached)})

    with ThreadPoolExecutor(jobs) as pool:
        for k, _ in enumerate(pool.map(one, left), 1):
            if k % 50 == 0 or k == len(left):
                say(f"{k}/{len(left)} tests without a fault")
    if failing:
        sys.exit("these fail without a fault:\n  " + "\n  ".join(failing))
    known = record.tests()
    return [known[w] for w in wanted]


def nearest(folder):
    return next((programs for folders, programs in NEAREST
                 if any(folder == f or folder.startswith(f + "/") for f in folders)), [])


def batches(tests, folder):
    """Tests of one program and about one duration together: cheap ones first, near ones first."""
    near = nearest(folder)

    def order(program):
        return (near.index(program) if program in near else len(near), program)

    groups = {}
    for test in tests:
        tier = next(k for k, most in enumerate(TIERS) if test.seconds < most)
        if test.program == CAMPAIGN[0]:
            tier = len(TIERS)
        groups.setdefault((tier, order(test.program)), []).append(test)
    for key in sorted(groups):
        group = sorted(groups[key], key=lambda t: (t.seconds, t.name))
        for begin in range(0, len(group), MOST_TESTS):
            yield group[begin:begin + MOST_TESTS]


def limit_of(batch):
    return TIMES_NORMAL * sum(t.seconds for t in batch) + GRACE


def run_mutant(bench, mutant, tests, unsteady):
    """(outcome, how, what saw it)"""
    reaching = [t for t in tests if mutant.number in t.reached]
    if not reaching:
        return score.UNREACHED, "", ""
    doubtful = 0
    for batch in batches(reaching, mutant.folder):
        program = batch[0].program
        left = [t for t in batch if (program, t.name) not in unsteady]
        while left:
            ending = bench.run(program, [t.name for t in left], limit_of(left), mutant.number)
            if ending.how == "passed":
                break
            blamed = [t for t in left if t.name == ending.test] or left
            left = [t for t in left if t not in blamed]
            again = bench.run(program, [t.name for t in blamed], limit_of(blamed))
            if again.how == "passed":
                # On a machine that has become busy all is slow: a hang must last beside what the
                # same test takes now.
                if ending.how == "hung":
                    ending = bench.run(program, [t.name for t in blamed],
                                       TIMES_NORMAL * again.seconds + GRACE, mutant.number)
                if ending.how != "passed":
                    return score.SEEN, ending.how, f"{program} {ending.test}"
                continue
            # It fails without the fault too, at times: it says nothing.
            unsteady.update((program, t.name) for t in blamed)
            say(f"unsteady: {program} {ending.test}")
            doubtful += 1
            if doubtful > MOST_UNSTEADY:
                sys.exit("too many tests fail without a fault; is the machine overloaded?")
    return score.UNSEEN, "", ""


def say(line):
    print(line, file=sys.stderr, flush=True)


def source_of(build):
    for line in (Path(build) / "CMakeCache.txt").read_text().splitlines():
        if line.startswith("CMAKE_HOME_DIRECTORY:"):
            return Path(line.split("=", 1)[1])
    sys.exit(f"{build} is no build")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", metavar="BUILD")
    parser.add_argument("--record", required=True, metavar="FILE")
    parser.add_argument("--programs", nargs="+", help="test programs (those built of the usual)")
    parser.add_argument("--folders", nargs="+", help="mutants of these alone, as engine/base")
    parser.add_argument("--mutants", nargs="+", type=int, help="these numbers alone")
    parser.add_argument("--campaign", action="store_true", help="what tests do not see goes there")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--memory", type=int, default=8, help="GiB of addresses a process has (8)")
    parser.add_argument("--report", action="store_true", help="run nothing")
    chosen = parser.parse_args()

    table = source_of(chosen.build) / "mutants.tsv"
    mutants = score.read_mutants(table)
    equivalents = score.read_equivalents(HERE / "equivalent.tsv")
    record = Record(chosen.record, {"mutants": hashlib.sha256(table.read_bytes()).hexdigest()})
    if not chosen.report:
        bench = Bench(Path(chosen.build) / "bin", chosen.memory)
        programs = chosen.programs or [p for p in PROGRAMS if (bench.folder / p).is_file()]
        programs += [CAMPAIGN[0]] if chosen.campaign else []
        tests = measure_tests(bench, programs, record, max(m.number for m in mutants) + 1,
                              chosen.jobs)
        run_all(bench, mutants, tests, equivalents, record, chosen)
    print(score.report(mutants, record.outcomes(), equivalents), end="")


def run_all(bench, mutants, tests, equivalents, record, chosen):
    done = record.outcomes()
    left = [m for m in mutants if m.number not in done
            and (not chosen.folders or m.folder in chosen.folders)
            and (not chosen.mutants or m.number in chosen.mutants)
            and (m.file, m.before, m.after) not in equivalents]
    unsteady = set()

    def one(mutant):
        begin = time.monotonic()
        outcome, how, by = run_mutant(bench, mutant, tests, unsteady)
        record.add({"mutant": mutant.number, "outcome": outcome, "how": how, "by": by,
                    "seconds": round(time.monotonic() - begin, 1)})
        say(f"mutant {mutant.number} {mutant.file}:{mutant.line} {mutant.operator}: {outcome} "
            f"{how} {by}".rstrip())

    with ThreadPoolExecutor(chosen.jobs) as pool:
        for _ in pool.map(one, left):
            pass


if __name__ == "__main__":
    main()
