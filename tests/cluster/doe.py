#!/usr/bin/python3
"""A factorial design of experiments on a Dask cluster, one of whose machines is lost.

    PYTHONPATH=build/client/python tests/cluster/doe.py build/bin/remeshd [--case tool2-a] [--levels 4]

A scheduler and two workers, each with a daemon of its own; the daemons share a tier. Three
parameters of different features have so many levels each, the first of them the base's. All designs
are made twice: each from the base, and each from its best parent. When a third of the latter is
done, a worker and its daemon are killed at once (kill -9); with --restart they start again 2 s
later. Exits with 1 where a design is missing, an id or a byte of a mesh differs from what one
daemon alone makes of the same plan, or best parents save less than 30 % of the seconds computed,
on the cluster (where the loss leaves more of the machine to the other daemon) or by one daemon.
"""
import argparse
import itertools
import os
import subprocess
import sys
import threading
import time
from pathlib import Path

from distributed import Client

import remesh_client as rc
from bed import Bed, FaultyTier
from loops import digest
from remesh_client.dask import DesignResult, learn_shares, map_designs, plan_designs

CASES = Path(__file__).parent.parent / "cases"
RANGES = {"tool1-a": {"pin_radius": (4, 5.5), "hole_circle": (36, 33), "bore.radius": (9, 7.5)},
          "tool2-a": {"pipe_x": (15, 21), "mount1.radius": (5, 4.1), "wall.dz": (60, 51)}}
LEAST_SAVED = .3


class Cluster:
    """A scheduler, and a worker process beside each replica of a bed; a context manager."""

    def __init__(self, bed):
        self._bed, self._file = bed, bed.folder / "scheduler.json"
        self._scheduler = self._start("scheduler", "--port", "0", "--host", "127.0.0.1")
        self.workers = [self.start_worker(replica) for replica in bed.replicas]

    def _start(self, kind, *options, **environment):
        return subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--scheduler-file", self._file,
             "--no-dashboard", *options], env={**os.environ, **environment},
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def start_worker(self, replica):
        return self._start("worker", "--nthreads", "1", "--no-nanny", "--local-directory",
                           self._bed.folder, REMESH_ADDRESS=replica.address)

    def client(self):
        client = Client(scheduler_file=str(self._file))
        client.wait_for_workers(len(self.workers))
        return client

    def lose(self, number, restart):
        """Kills a worker with its daemon; restart: they are there again after 2 s."""
        replica = self._bed.replicas[number]
        self.workers[number].kill()
        replica.kill()
        self.workers[number].wait()
        if restart:
            time.sleep(2)
            replica.start()
            self.workers[number] = self.start_worker(replica)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in (*self.workers, self._scheduler):
            process.kill()
            process.wait()


def factorial(case, levels):
    """Designs, the first of which has the base's values."""
    steps = [[round(first + (last - first) * k / (levels - 1), 6) for k in range(levels)]
             for first, last in RANGES[case].values()]
    return [dict(zip(RANGES[case], values)) for values in itertools.product(*steps)]


def alone(program, case, nodes, plan):
    """(id, digest) of each design, and the seconds computed, by one daemon that follows a plan."""
    with rc.local(program) as daemon:
        parts = {-1: daemon.mesh(CASES / f"{case}.json", nodes=nodes, file=False)}
        seconds = 0.0
        for design in plan.order:
            parent = parts[plan.parents[design]]
            parts[design] = parent
            if plan.changes[design]:
                parts[design] = parent.edit(plan.changes[design], file=False)
                seconds += parts[design].report.seconds.total
        return [(parts[design].revision, digest(parts[design].mesh()))
                for design in range(len(plan.parents))], seconds


def lose_midway(cluster, futures, restart):
    """A thread that waits for a third of the designs, then loses a worker and its daemon."""
    def lose():
        while sum(future.done() for future in futures) < len(futures) // 3:
            time.sleep(.02)
        cluster.lose(0, restart)
    thread = threading.Thread(target=lose)
    thread.start()
    return thread


def on_cluster(arguments, designs, depth, lose):
    """DesignResults or exceptions, digests by id, the shares learned, the seconds that passed."""
    with Bed(arguments.remeshd, FaultyTier, replicas=2) as bed, Cluster(bed) as cluster, \
            rc.connect(bed.addresses) as daemon, cluster.client() as client:
        base = daemon.mesh(CASES / f"{arguments.case}.json", nodes=arguments.nodes, file=False)
        shares = learn_shares(client, base, designs, measure=arguments.measure,
                              addresses=bed.addresses)
        begun = time.monotonic()
        futures = map_designs(client, base, designs, addresses=bed.addresses, depth=depth,
                              shares=shares)
        loss = lose_midway(cluster, futures, arguments.restart) if lose else None
        made = [future.exception() or future.result() for future in futures]
        passed = time.monotonic() - begun
        if loss is not None:
            loss.join()
        digests = {each.revision: digest(daemon.open(each.revision).mesh()) for each in made
                   if isinstance(each, DesignResult)}
    return made, digests, shares, passed


def differences(made, digests, right):
    """What is not as it has to be, a line each."""
    wrong = []
    for number, (each, (revision, bytes_right)) in enumerate(zip(made, right)):
        if not isinstance(each, DesignResult):
            wrong.append(f"design {number}: {each!r}")
        elif each.revision != revision:
            wrong.append(f"design {number} has another id")
        elif digests[revision] != bytes_right:
            wrong.append(f"design {number} has other bytes")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--case", choices=RANGES, default="tool1-a")
    parser.add_argument("--levels", type=int, default=4)
    parser.add_argument("--nodes", type=int, default=5000)
    parser.add_argument("--measure", choices=("nodes", "seconds"), default="nodes",
                        help="what the cost of an edit is learned from")
    parser.add_argument("--restart", action="store_true", help="what was killed starts again")
    parser.add_argument("--untimed", action="store_true", help="other work runs beside it")
    arguments = parser.parse_args()
    designs = factorial(arguments.case, arguments.levels)
    print(f"{len(designs)} designs of {arguments.case} at {arguments.nodes} nodes", flush=True)
    wrong, sums, sums_alone = [], [], []
    for order, depth, lose in (("from the base", 1, False), ("from best parents", 8, True)):
        made, digests, shares, passed = on_cluster(arguments, designs, depth, lose)
        plan = plan_designs(designs[0], designs, depth=depth, shares=shares)
        right, seconds_alone = alone(arguments.remeshd, arguments.case, arguments.nodes, plan)
        wrong += [f"{order}: {line}" for line in differences(made, digests, right)]
        results = [each for each in made if isinstance(each, DesignResult)]
        sums.append(sum(each.seconds for each in results))
        sums_alone.append(seconds_alone)
        print(f"{order}: depth {max(plan.depths)}, {sums[-1]:.2f} s computed in {passed:.2f} s, by "
              f"one daemon alone {seconds_alone:.2f} s", flush=True)
        if not lose and len({each.replica for each in results}) != 2:
            wrong.append(f"{order}: one daemon made them all")
    saved, saved_alone = (1 - best / root for root, best in (sums, sums_alone))
    print(f"best parents save {saved:.0%} of the seconds, by one daemon alone {saved_alone:.0%}; "
          + ", ".join(f"{name} {share:.3f}" for name, share in shares.items()))
    if min(saved, saved_alone) < LEAST_SAVED and not arguments.untimed:
        wrong.append(f"that is less than {LEAST_SAVED:.0%}")
    print(f"{len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
