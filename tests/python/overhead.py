#!/usr/bin/python3
"""What the client itself takes of the time of `part.mesh()`.

    PYTHONPATH=build/client/python tests/python/overhead.py build/bin/remeshd [--nodes 15000]

Of each edit the mesh is timed from the result on: waiting, in which the daemon works out the
difference and its bytes travel, and the client's own work, all else. Told are medians and the
greatest, in ms.
"""
import argparse
import statistics
import time
from pathlib import Path

import remesh_client as rc

MODEL = Path(__file__).parent.parent / "cases/tool1-a.json"


class Waiting:
    """Answers of a call, timed while they are waited for."""

    def __init__(self, answers):
        self.answers, self.seconds = answers, 0.0

    def __next__(self):
        begun = time.perf_counter()
        try:
            return next(self.answers)
        finally:
            self.seconds += time.perf_counter() - begun

    def __getattr__(self, name):
        return getattr(self.answers, name)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("--nodes", type=int, default=15000)
    parser.add_argument("--order", type=int, default=1)
    parser.add_argument("--edits", type=int, default=40)
    arguments = parser.parse_args()
    whole, own, shares = [], [], []
    with rc.local(arguments.remeshd) as daemon:
        part = daemon.mesh(MODEL, nodes=arguments.nodes, order=arguments.order)
        part.mesh()
        call = daemon._farm.replicas[0].stream._call
        call.answers = Waiting(call.answers)
        for k in range(arguments.edits):
            part = part.edit(pin_radius=4.5 + .02 * k)
            waited, begun = call.answers.seconds, time.perf_counter()
            mesh = part.mesh()
            whole.append(1e3 * (time.perf_counter() - begun))
            own.append(whole[-1] - 1e3 * (call.answers.seconds - waited))
            shares.append(part.report.nodes_kept / part.report.nodes)
    print(f"{len(mesh.points)} nodes, order {arguments.order}, {arguments.edits} edits, "
          f"{100 * statistics.median(shares):.0f} % kept")
    print(f"part.mesh() {statistics.median(whole):.1f} ms, of which the client's own "
          f"{statistics.median(own):.1f}, least {min(own):.1f}, most {max(own):.1f}")


if __name__ == "__main__":
    main()
