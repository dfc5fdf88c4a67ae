#!/usr/bin/python3
"""A study that runs through a farm: every combination of some values of three parameters.

    PYTHONPATH=build/client/python deploy/cluster/study.py --address localhost:50050 --progress FILE

The combinations are taken in an order in which each differs from the one before in one parameter by
one step, and cut into loops. Several loops run side by side, each with a connection and a route of
its own: its first design is remeshed from the base, each further one from the one before, and its
mesh comes here, as to a solver. A design that cannot be meshed is counted and left out. Where no
replica is available a loop waits; nothing is lost, and what was made already is not made again.

FILE gets, every second, how far it is, as JSON: the page (deploy/cluster/page) shows it.
"""
import argparse
import functools
import json
import os
import queue
import signal
import sys
import threading
import time
from pathlib import Path

import remesh_client as rc

MODEL = Path(__file__).with_name("tool1-a.json")
VARIED = ("pin_radius=4:5.5:10", "hole_circle=36:33:10", "bore.radius=9:7.5:10")
PASSING = (rc.Unavailable, rc.Busy, rc.Cancelled, rc.DeadlineExceeded)
PAUSE = 2.0  # s before another try
MOST_POINTS = 240  # of the course


def varied(text):
    """`NAME=FIRST:LAST:LEVELS` as (name, values)."""
    name, equals, rest = text.partition("=")
    try:
        first, last, levels = rest.split(":")
        first, last, levels = float(first), float(last), int(levels)
        if not (name and equals) or levels < 2:
            raise ValueError
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not NAME=FIRST:LAST:LEVELS with two levels or more") from None
    return name, [round(first + (last - first) * k / (levels - 1), 6) for k in range(levels)]


def combinations(parameters):
    """All of them, neighbours in the list being neighbours in one parameter."""
    designs = [{}]
    for name, values in parameters:
        designs = [{**design, name: value} for number, design in enumerate(designs)
                   for value in (values if number % 2 == 0 else values[::-1])]
    return designs


class Progress:
    """How far the study is; threads tell it."""

    def __init__(self, file, **facts):
        self._file, self._facts, self._lock = Path(file), facts, threading.Lock()
        self._begun, self._every, self._course = time.time(), 1.0, [[0.0, 0]]
        self._done = self._failed = self._waiting = 0
        self._lightest = None
        self._kept = self._nodes = 0

    def made(self, values, report):
        with self._lock:
            self._done += 1
            self._kept += report.nodes_kept
            self._nodes += report.nodes
            if self._lightest is None or report.volume < self._lightest["volume"]:
                self._lightest = {"volume": report.volume, "values": values}

    def failed(self):
        with self._lock:
            self._failed += 1

    def waits(self, change):
        """A loop begins (1) or ends (-1) to wait for a replica."""
        with self._lock:
            self._waiting += change

    def write(self, state):
        """state: `running`, `finished`, `stopped`. The file is whole at any moment."""
        with self._lock:
            passed = time.time() - self._begun
            if passed - self._course[-1][0] >= self._every or state != "running":
                self._course.append([round(passed, 1), self._done])
            if len(self._course) > MOST_POINTS:
                self._course, self._every = self._course[::2], 2 * self._every
            told = {**self._facts, "state": state, "begun": self._begun, "seconds": passed,
                    "done": self._done, "failed": self._failed, "waiting": self._waiting,
                    "lightest": self._lightest, "course": self._course,
                    "kept": self._kept / self._nodes if self._nodes else None}
        beside = self._file.with_suffix(".new")
        beside.write_text(json.dumps(told))
        os.replace(beside, self._file)

    def summary(self):
        with self._lock:
            return (f"{self._done} designs in {time.time() - self._begun:.1f} s, "
                    f"{self._failed} could not be meshed")


class Loop:
    """Designs one after another, by a connection of its own."""

    def __init__(self, number, designs):
        self._number, self._designs = number, designs

    def run(self, arguments, progress, stop):
        """`stop` is an Event after which it does no more."""
        part = None
        with rc.connect(arguments.address, patience=60) as daemon:
            def first():
                return daemon.mesh(arguments.model, nodes=arguments.nodes, file=False,
                                   route=f"loop {self._number}")

            def remeshed(base, values):
                patiently = functools.partial(self._patiently, progress=progress, stop=stop)
                base = base or patiently(first)
                made = patiently(lambda: base.edit(values, file=False))
                patiently(made.mesh)
                return made

            for values in self._designs:
                try:
                    try:
                        part = remeshed(part, values)
                    except rc.NotFound:  # the farm lost what it stands on
                        part = remeshed(None, values)
                except rc.RemeshError as why:
                    if stop.is_set():
                        return
                    print(f"{values}: {why}", file=sys.stderr, flush=True)
                    progress.failed()
                else:
                    progress.made(values, part.report)
                if stop.wait(arguments.think):
                    return

    @staticmethod
    def _patiently(ask, progress, stop):
        """What it gives; asked again where what is wrong passes."""
        waits = False
        try:
            while True:
                try:
                    return ask()
                except PASSING as why:
                    if not waits:
                        progress.waits(1)
                        waits = True
                    if stop.wait(why.retry_after or PAUSE):
                        raise
        finally:
            if waits:
                progress.waits(-1)


def work(loops, arguments, progress, stop):
    while not stop.is_set():
        try:
            loop = loops.get_nowait()
        except queue.Empty:
            return
        loop.run(arguments, progress, stop)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--address", required=True,
                        help="of the balancer, or of all replicas with commas between")
    parser.add_argument("--progress", required=True, metavar="FILE", help="where it is told")
    parser.add_argument("--model", type=Path, default=MODEL, help="default: %(default)s")
    parser.add_argument("--vary", type=varied, action="append", metavar="NAME=FIRST:LAST:LEVELS",
                        help="default: " + ", ".join(VARIED))
    parser.add_argument("--nodes", type=int, default=15000, help="of a mesh")
    parser.add_argument("--side-by-side", type=int, default=9, metavar="N", help="loops at a time")
    parser.add_argument("--loop", type=int, default=25, metavar="N", help="designs of a loop")
    parser.add_argument("--think", type=float, default=0, metavar="S",
                        help="s between a loop's designs, as a solver takes them")
    arguments = parser.parse_args()
    if not arguments.model.is_file():
        parser.error(f"--model: {arguments.model} is no file")
    if arguments.side_by_side < 1 or arguments.loop < 1:
        parser.error("--side-by-side and --loop: at least 1")
    parameters = arguments.vary or [varied(each) for each in VARIED]
    designs = combinations(parameters)
    loops = queue.Queue()
    for number, first in enumerate(range(0, len(designs), arguments.loop)):
        loops.put(Loop(number, designs[first:first + arguments.loop]))
    progress = Progress(
        arguments.progress, model=arguments.model.stem, nodes=arguments.nodes, designs=len(designs),
        unit=json.loads(arguments.model.read_text())["unit"],
        parameters=[{"name": name, "from": min(values), "to": max(values), "levels": len(values)}
                    for name, values in parameters])
    stop = threading.Event()
    for end in (signal.SIGTERM, signal.SIGINT):
        signal.signal(end, lambda *_: stop.set())
    threads = [threading.Thread(target=work, args=[loops, arguments, progress, stop], daemon=True)
               for _ in range(arguments.side_by_side)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads) and not stop.is_set():
        progress.write("running")
        time.sleep(1)
    progress.write("stopped" if stop.is_set() else "finished")
    print(progress.summary(), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
