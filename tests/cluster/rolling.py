#!/usr/bin/python3
"""No request fails while replicas are restarted one after another, and while they become more or fewer.

    PYTHONPATH=build/client/python tests/cluster/rolling.py build/bin/remeshd [--restarts 10]

Loops run over two replicas all the time. Each replica in turn is ended by SIGTERM and started again,
without its store: another machine. In the middle a third one joins and later leaves; clients
that connect from then on know of it. Exits with 1 where a loop sees an error, one byte differs from
what one daemon makes, or less than 95 % of the revisions that a replica had to have of another were
there in the tier.
"""
import argparse
import collections
import sys
import threading
import time

import remesh_client as rc
from bed import TIERS, Bed, add_tier_option
from loops import Loop, differences, reference

MOVED_SHARE = .95


class Load:
    """Loops one after another in each of some threads, until it is told to end."""

    def __init__(self, right, addresses):
        self.addresses, self.failed, self.loops = addresses, [], 0
        self._right, self._ended = right, threading.Event()
        self._threads = [threading.Thread(target=self._run, args=[each]) for each in right]
        for thread in self._threads:
            thread.start()

    def _run(self, right):
        first = True
        while first or not self._ended.is_set():
            first = False
            loop = Loop(right.number, len(right.radii), right.nodes)
            try:
                with rc.connect(self.addresses, patience=60) as daemon:
                    loop.run(daemon)
            except Exception as why:  # pylint: disable=broad-except
                loop.error = why
            self.failed += differences([loop], [right])
            self.loops += 1

    def end(self):
        self._ended.set()
        for thread in self._threads:
            thread.join()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--restarts", type=int, default=10)
    parser.add_argument("--loops", type=int, default=3)
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=2000)
    add_tier_option(parser, "faulty", "nginx", "swift")
    arguments = parser.parse_args()
    right = reference(arguments.remeshd, arguments.loops, arguments.edits, arguments.nodes)
    totals = collections.Counter()
    with Bed(arguments.remeshd, TIERS[arguments.tier], replicas=2, metrics=True) as bed:
        load = Load(right, bed.addresses)
        for restart in range(arguments.restarts):
            time.sleep(1.5)
            if restart == arguments.restarts // 3:
                bed.add()
                load.addresses = bed.addresses
            if restart == 2 * arguments.restarts // 3:
                load.addresses = bed.addresses[:2]
            replica = bed.replicas[restart % 2]
            totals += replica.revisions_from()
            replica.stop()
            replica.lose_store()
            replica.start()
        load.end()
        for replica in bed.replicas:
            totals += replica.revisions_from()
    moved, remade = totals["tier"], totals["remade"]
    share = moved / max(1, moved + remade)
    wrong = load.failed
    if share < MOVED_SHARE:
        wrong.append(f"only {100 * share:.0f} % of what moved came from the tier")
    print(f"{arguments.restarts} restarts, {load.loops} loops: {moved:.0f} revisions from the tier, "
          f"{remade:.0f} made again; {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
