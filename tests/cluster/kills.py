#!/usr/bin/python3
"""Loops go on where replicas are killed.

    PYTHONPATH=build/client/python tests/cluster/kills.py build/bin/remeshd [--kills 50] [--lose-stores]

Three replicas share a tier, which has each edit before it is acknowledged. While loops run, one
after another is killed and started again, at any moment, or, with --lose-stores, without what it
had. Exits with 1 where a client saw an error, one byte differs from what one daemon makes, or there
was more than one computation a kill beyond those that one daemon makes, and those that a kill ended.
"""
import argparse
import collections
import random
import sys
import time

from bed import TIERS, Bed, add_tier_option
from loops import Loop, differences, reference, run_all


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--loops", type=int, default=3)
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=2000)
    add_tier_option(parser, "faulty", "nginx", "swift")
    parser.add_argument("--balancer", action="store_true",
                        help="clients know the address of a balancer alone")
    parser.add_argument("--lose-stores", action="store_true")
    parser.add_argument("--asyncio", action="store_true", help="loops are tasks that share a client")
    arguments = parser.parse_args()
    size = (arguments.loops, arguments.edits, arguments.nodes)
    right = reference(arguments.remeshd, *size)
    chance, kills, rounds, wrong = random.Random(1), 0, 0, []
    begun = time.monotonic()
    came = collections.Counter()
    with Bed(arguments.remeshd, TIERS[arguments.tier], metrics=True) as bed:
        balancer = bed.balance() if arguments.balancer else None
        while kills < arguments.kills and not wrong:
            rounds += 1
            if rounds > 1:  # nothing of the loops is known yet
                for replica in bed.replicas:
                    came += replica.revisions_from()
                    replica.kill()
                    replica.lose_store()
                bed.tier.clear()
                for replica in bed.replicas:
                    replica.start()
            loops = [Loop(number, *size[1:]) for number in range(arguments.loops)]
            threads = run_all(loops, balancer.address if balancer else bed.addresses,
                              tasks=arguments.asyncio)
            while any(thread.is_alive() for thread in threads):
                time.sleep(chance.uniform(.05, .8))
                if kills >= arguments.kills or not any(t.is_alive() for t in threads):
                    continue
                victim = chance.choice(bed.replicas)
                came += victim.revisions_from()
                victim.kill()
                if arguments.lose_stores:
                    victim.lose_store()
                time.sleep(chance.uniform(0, .3))
                victim.start()
                kills += 1
            wrong = differences(loops, right)
            longest = max(loop.longest for loop in loops)
            print(f"round {rounds}: {kills} kills so far, longest edit {longest:.2f} s", flush=True)
        for replica in bed.replicas:
            came += replica.revisions_from()
    seconds = time.monotonic() - begun
    more = came["computed"] + came["remade"] - rounds * sum(len(loop.made) for loop in right)
    if more > kills:
        wrong.append(f"{more:.0f} computations more")
    print(f"{kills} kills in {rounds} x {arguments.loops} loops of {arguments.edits} edits, "
          f"{seconds:.0f} s, {more:.0f} computations more: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
