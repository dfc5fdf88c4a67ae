#!/usr/bin/python3
"""What tier and balancer add to an edit.

    PYTHONPATH=build/client/python tests/cluster/overhead.py build/bin/remeshd [--edits 60]

The same edits in turn by a daemon alone and by one that shares nginx's tier, has each edit
acknowledged there and stands behind a balancer, with the mesh each time. Told are medians of
the seconds of both and of their differences, edit by edit. Goal: at most 5 % or 10 ms.
"""
import argparse
import statistics
import sys
import time

import remesh_client as rc
from bed import Bed, NginxTier
from loops import MODEL, Loop

MOST_SECONDS, MOST_SHARE = .01, .05


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--edits", type=int, default=60)
    parser.add_argument("--nodes", type=int, default=15000)
    arguments = parser.parse_args()
    radii = Loop(0, arguments.edits, arguments.nodes).radii
    with Bed(arguments.remeshd, NginxTier, replicas=1) as bed, \
            rc.connect(bed.balance().address) as farm, \
            rc.local(arguments.remeshd, "--workers", "1") as alone:
        parts = {each: each.mesh(MODEL, nodes=arguments.nodes, file=False)
                 for each in (alone, farm)}
        seconds = {alone: [], farm: []}
        for number, radius in enumerate(radii):
            for each in (alone, farm) if number % 2 else (farm, alone):
                begun = time.perf_counter()
                parts[each] = parts[each].edit(pin_radius=radius, file=False)
                parts[each].mesh()
                seconds[each].append(time.perf_counter() - begun)
                time.sleep(.3)  # what is written behind does not compete: a solver runs now
    usual = statistics.median(seconds[alone])
    added = statistics.median(b - a for a, b in zip(seconds[alone], seconds[farm]))
    print(f"{arguments.edits} edits of {arguments.nodes} nodes: alone {1e3 * usual:.0f} ms, "
          f"in the farm {1e3 * statistics.median(seconds[farm]):.0f} ms, "
          f"added {1e3 * added:+.1f} ms ({100 * added / usual:+.1f} %)")
    return 1 if added > max(MOST_SECONDS, MOST_SHARE * usual) else 0


if __name__ == "__main__":
    sys.exit(main())
