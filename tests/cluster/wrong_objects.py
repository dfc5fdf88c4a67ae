#!/usr/bin/python3
"""What is wrong in the tier is never served.

    PYTHONPATH=build/client/python tests/cluster/wrong_objects.py build/bin/remeshd [--flips 1000]

A bit is changed in the recipe or the mesh of each revision of a loop, chance says which; then a
replica that has nothing serves them all. Every byte is to be right, what is wrong kept in the
quarantine, and written over: another replica finds nothing wrong any more. Then the same with
objects under another's key, and with those of another farm.
"""
import argparse
import random
import sys
import time

import remesh_client as rc
from bed import TIERS, Bed, FaultyTier, add_tier_option
from loops import Loop, digest


def flip(tier, key, chance):
    changed = bytearray(tier.get(key))
    bit = chance.randrange(8 * len(changed))
    changed[bit // 8] ^= 1 << bit % 8
    tier.put(key, bytes(changed))


def exchange(tier, keys):
    """Each object under the next one's key."""
    bodies = [tier.get(key) for key in keys]
    for key, body in zip(keys, bodies[1:] + bodies[:1]):
        tier.put(key, body)


def afresh(replica):
    replica.kill()
    replica.lose_store()
    replica.start()


def serve_all(address, made):
    """Revisions that are not served as they were made, a line each."""
    wrong = []
    with rc.connect(address) as daemon:
        for number, (each, right) in enumerate(made):
            try:
                if digest(daemon.open(each).mesh()) != right:
                    wrong.append(f"revision {number} has other bytes")
            except rc.RemeshError as why:
                wrong.append(f"revision {number}: {why.reason}: {why}")
    return wrong


def quarantined(replica):
    return replica.log().count(" is not used: ")


def settle(tier):
    """Waits until nothing is written any more."""
    before = None
    while before != (before := tier.list()):
        time.sleep(1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--flips", type=int, default=1000)
    parser.add_argument("--edits", type=int, default=40)
    parser.add_argument("--nodes", type=int, default=1000)
    add_tier_option(parser, "faulty", "nginx", "swift")
    arguments = parser.parse_args()
    chance, wrong, flips = random.Random(1), [], 0
    with Bed(arguments.remeshd, TIERS[arguments.tier], replicas=3) as bed:
        loop = Loop(0, arguments.edits, arguments.nodes)
        with rc.connect(bed.replicas[0].address) as daemon:
            loop.run(daemon)
        settle(bed.tier)
        keys = {each: {kind: next(key for key in bed.tier.list()
                                  if key.endswith(each) and key.startswith(f"{kind}/"))
                       for kind in ("recipe", "pack")} for each, _ in loop.made}

        def serve(what, changed):
            """By one that has nothing; then by another, which is to find nothing wrong."""
            one, other = bed.replicas[1:]
            for replica in (one, other):
                afresh(replica)
            before = quarantined(one), quarantined(other)
            wrong.extend(f"{what}: {line}" for line in serve_all(one.address, loop.made))
            found = quarantined(one) - before[0]
            if found < changed:
                wrong.append(f"{what}: {found} of {changed} wrong objects were found")
            settle(bed.tier)
            wrong.extend(f"{what}, mended: {line}" for line in serve_all(other.address, loop.made))
            left = quarantined(other) - before[1]
            if left:
                wrong.append(f"{what}: {left} objects are still wrong")
            print(f"{what}: {changed} wrong objects, {found} found, {left} left", flush=True)

        while flips < arguments.flips and not wrong:
            for each, _ in loop.made:
                flip(bed.tier, keys[each][chance.choice(("recipe", "pack"))], chance)
            flips += len(loop.made)
            serve(f"{flips} flips", len(loop.made))
        exchange(bed.tier, [keys[each]["pack"] for each, _ in loop.made])
        serve("another's meshes", len(loop.made))
        with Bed(arguments.remeshd, FaultyTier, replicas=1) as stranger:
            with rc.connect(stranger.addresses) as daemon:
                Loop(0, arguments.edits, arguments.nodes).run(daemon)
            settle(stranger.tier)
            for each, _ in loop.made:
                bed.tier.put(keys[each]["pack"], stranger.tier.get(keys[each]["pack"]))
        serve("another farm's meshes", len(loop.made))
    print(f"{flips} flips: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
