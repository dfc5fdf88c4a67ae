#!/usr/bin/python3
"""Garbage of the tier goes, and loops go on.

    PYTHONPATH=build/client/python tests/cluster/tier_garbage.py build/bin/remeshd build/bin/remesh

Loops run at one replica; `remesh cache gc --tier` takes the tier to half of its bytes, but for what
a replica pinned; another replica, that has nothing, continues each loop. Then recipes that nothing
needs are to go, which marks them and deletes none. Exits with 1 where more stays than was asked for,
a pinned mesh went, a recipe was deleted, or one byte of a loop differs from what one daemon makes.
"""
import argparse
import re
import subprocess
import sys
import time

import remesh_client as rc

from bed import TIERS, Bed, add_tier_option
from loops import Loop, digest, reference


def settle(bed):
    """Waits until the tier has all that it is to get."""
    for _ in range(600):
        if not list(bed.folder.glob("replica*/store/outbox/*/*")):
            return
        time.sleep(.05)
    raise TimeoutError("the outbox does not become empty")


def remesh(program, replica, *arguments):
    done = subprocess.run([program, "--address", replica.address, "cache", *arguments],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return {name: float(value) for name, value in re.findall(r"(\w+)[\w ]*? +([\d.]+)\n", done.stdout)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("remesh")
    parser.add_argument("--loops", type=int, default=2)
    parser.add_argument("--edits", type=int, default=10)
    parser.add_argument("--nodes", type=int, default=1000)
    add_tier_option(parser, "nginx", "swift")
    arguments = parser.parse_args()
    size = (arguments.loops, arguments.edits, arguments.nodes)
    right, wrong = reference(arguments.remeshd, *size), []
    with Bed(arguments.remeshd, TIERS[arguments.tier], replicas=1) as bed:
        with rc.connect(bed.addresses[0]) as daemon:
            loops = [Loop(number, *size[1:]) for number in range(arguments.loops)]
            for loop in loops:
                loop.run(daemon)
        settle(bed)
        pinned = loops[0].made[1][0]
        remesh(arguments.remesh, bed.replicas[0], "pin", pinned)
        before = bed.tier.list()
        total = remesh(arguments.remesh, bed.replicas[0], "gc", "--tier", "--dry-run")["tier"]
        done = remesh(arguments.remesh, bed.replicas[0], "gc", "--tier", "--disk", str(total / 2))
        after = bed.tier.list()
        if done["tier"] > total / 2:
            wrong.append(f"{done['tier']} MB stay of {total}")
        if not any(key.startswith("pack/") and key.endswith(pinned) for key in after):
            wrong.append("a pinned mesh went")
        fresh = bed.add()
        with rc.connect(fresh.address) as daemon:
            for loop, made in zip(loops, right):
                last = daemon.open(made.made[-1][0])
                if digest(last.mesh()) != made.made[-1][1]:
                    wrong.append(f"loop {loop.number} ends with another mesh")
                for identity, expected in made.made:
                    if digest(daemon.open(identity).mesh()) != expected:
                        wrong.append(f"{identity[:12]} is another mesh")
        recipes = {key for key in before if key.startswith("recipe/")}
        settle(bed)
        marked = remesh(arguments.remesh, bed.replicas[0], "gc", "--tier", "--disk", "0",
                        "--recipes-unused", "0")
        left = set(bed.tier.list())
        doomed = [key for key in left if key.startswith("doomed/")]
        if marked["recipes"] or not recipes <= left or not doomed:
            wrong.append(f"{marked['recipes']:.0f} recipes went, {len(recipes - left)} are missing, "
                         f"{len(doomed)} are marked")
    print(f"{total:.1f} MB in {len(before)} objects, {done['meshes']:.0f} meshes went, "
          f"{len(doomed)} recipes marked: {len(wrong)} wrong", *wrong, sep="\n  ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
