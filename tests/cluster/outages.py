#!/usr/bin/python3
"""Loops end where the tier and a replica are out at once, as soon as the tier is back.

    PYTHONPATH=build/client/python tests/cluster/outages.py build/bin/remeshd [--outages 5]

Edits are acknowledged in the tier. In the middle of loops the tier goes down, and a replica is
killed; some seconds later the tier is back, and then the replica. A client of one replica alone
hears UNAVAILABLE meanwhile, with a delay. Exits with 1 where a loop sees an error, or one byte
differs from what one daemon makes.
"""
import argparse
import random
import sys
import time

import remesh_client as rc
from bed import TIERS, Bed, add_tier_option
from loops import MODEL, Loop, differences, reference, run_all


def heard_while_out(address, nodes):
    """What is wrong with the answer to a new design, a line each."""
    with rc.connect(address, patience=0) as daemon:
        try:
            daemon.mesh(MODEL, nodes=nodes, seed=random.randrange(1000, 10 ** 9), file=False)
            return ["an edit was acknowledged without the tier"]
        except rc.RemeshError as why:
            if why.reason != "TIER_UNAVAILABLE" or not why.retry_after:
                return [f"a client hears {why.reason}, {why.retry_after} s: {why}"]
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--outages", type=int, default=5)
    parser.add_argument("--loops", type=int, default=3)
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=2000)
    add_tier_option(parser, "faulty", "swift")
    arguments = parser.parse_args()
    size = (arguments.loops, arguments.edits, arguments.nodes)
    right = reference(arguments.remeshd, *size)
    chance, outages, wrong = random.Random(1), 0, []
    with Bed(arguments.remeshd, TIERS[arguments.tier]) as bed:
        while outages < arguments.outages and not wrong:
            bed.tier.clear()
            for replica in bed.replicas:
                replica.kill()
                replica.lose_store()
                replica.start()
            loops = [Loop(number, *size[1:]) for number in range(arguments.loops)]
            threads = run_all(loops, bed.addresses, patience=120)
            before = 0
            while any(thread.is_alive() for thread in threads):
                time.sleep(chance.uniform(.5, 1.5))
                if outages >= arguments.outages or not any(t.is_alive() for t in threads):
                    continue
                if sum(len(loop.made) for loop in loops) < before + len(loops):
                    continue  # the last one is not over: a tier that is back is left alone at first
                bed.tier.mode = "down"
                victim, other = chance.sample(bed.replicas, 2)
                victim.kill()
                wrong += heard_while_out(other.address, arguments.nodes)
                time.sleep(chance.uniform(0, 4))
                bed.tier.mode = "well"
                victim.start()
                before = sum(len(loop.made) for loop in loops)
                outages += 1
            wrong += differences(loops, right)
            print(f"{outages} outages so far, longest edit "
                  f"{max(loop.longest for loop in loops):.1f} s", flush=True)
    print(f"{outages} outages: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
