#!/usr/bin/python3
"""Loops go on where the tier fails, and it is made up for when it is well again.

    PYTHONPATH=build/client/python tests/cluster/tier_faults.py build/bin/remeshd [--edits 20]

Edits are acknowledged by the local store. In the middle of a loop the tier goes down, falls silent,
is full, answers 500 or cuts its bodies. No client may see an error; every byte is to be as one
daemon makes it; an edit may take 50 ms more (medians); who asks another replica for a revision that
only the tier has hears UNAVAILABLE, never NOT_FOUND; and when the tier is well, it gets all.
"""
import argparse
import statistics
import sys
import time

import remesh_client as rc
from bed import TIERS, Bed, add_tier_option
from loops import Loop, differences, reference

MODES = ("down", "silent", "full", "failing", "cutting")
MOST_ADDED = .05  # s


def settled(bed, ids, seconds=40):
    """Whether the tier gets the recipes and meshes of all of them."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        keys = bed.tier.list()
        if all(any(key.startswith(f"{kind}/") and key.endswith(each) for key in keys)
               for each in ids for kind in ("recipe", "pack")):
            return True
        time.sleep(.1)
    return False


def try_mode(mode, tier, program, right, edits, nodes):
    """What is wrong, a line each, and the seconds that an edit takes more."""
    wrong, seconds = [], {"well": [], mode: []}
    with Bed(program, TIERS[tier], replicas=2, acknowledge="local") as bed:
        loop, times = Loop(0, edits, nodes), []
        here, there = bed.addresses
        with rc.connect(here) as daemon:
            def after_each():
                times.append(time.monotonic())
                if len(times) > 1:
                    seconds[bed.tier.mode].append(times[-1] - times[-2])
                if len(times) == edits // 2:
                    bed.tier.mode = mode
            loop.run(daemon, after_each)
        last = loop.made[-1][0]
        wrong += differences([loop], [right])
        with rc.connect(there) as daemon:
            try:
                daemon.open(last)
                wrong.append("another replica knows what the tier has not got")
            except rc.RemeshError as why:
                if why.reason != "TIER_UNAVAILABLE" and mode != "full":
                    wrong.append(f"another replica says {why.reason}: {why}")
        bed.tier.mode = "well"
        if not settled(bed, [each for each, _ in loop.made]):
            wrong.append("the tier did not get all when it was well again")
        with rc.connect(there) as daemon:
            if daemon.open(last).mesh().points.shape != daemon.open(last).mesh().points.shape:
                wrong.append("another replica has another mesh")
        return wrong, statistics.median(seconds[mode]) - statistics.median(seconds["well"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--edits", type=int, default=20)
    parser.add_argument("--nodes", type=int, default=2000)
    parser.add_argument("--modes", nargs="+", choices=MODES, default=MODES)
    parser.add_argument("--untimed", action="store_true", help="other work runs beside it")
    add_tier_option(parser, "faulty", "swift")
    arguments = parser.parse_args()
    right, = reference(arguments.remeshd, 1, arguments.edits, arguments.nodes)
    failed = False
    for mode in arguments.modes:
        wrong, added = try_mode(mode, arguments.tier, arguments.remeshd, right, arguments.edits,
                                arguments.nodes)
        if added > MOST_ADDED and not arguments.untimed:
            wrong.append("edits take longer")
        print(f"{mode}: {1e3 * added:+.0f} ms an edit, {len(wrong)} wrong", *wrong, sep="\n  ",
              flush=True)
        failed = failed or bool(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
