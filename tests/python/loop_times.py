#!/usr/bin/env python3
"""loop_times.py REMESHD [PEER]: what an optimiser's loop on the bracket takes.

A random walk of the bracket's parameters, all together and each alone. Every design is remeshed from
the one before, meshed anew by ours with the same edge length, and by Gmsh HXT (PEER is
remesh-peer-gmsh) with as many nodes at the start. Prints a table of ratios, of sums over the steps:
the daemon's own seconds, and those of the client's call with the mesh in its hands.
"""
import argparse
import json
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import remesh_client as rc

HELD = 2  # WAY_MORPHED
BRACKET = Path(__file__).parents[2] / "client/examples/models/bracket.json"


class Hxt:
    """Gmsh HXT on the same models; 0 s without its program."""

    def __init__(self, program, folder):
        self._program, self._folder, self.size = program, Path(folder), 0.0

    def _ask(self, *arguments):
        return json.loads(subprocess.run([self._program, *map(str, arguments)], check=True,
                                         stdout=subprocess.PIPE).stdout)

    def fit(self, document, nodes, size):
        """Finds the size that gives about as many nodes."""
        self.size = size
        for _ in range(4):
            if self._program:
                self.size *= (self.mesh(document)["nodes"] / nodes) ** (1 / 3)

    def mesh(self, document):
        model, geometry = self._folder / "model.json", self._folder / "model.brep"
        model.write_text(json.dumps(document))
        self._ask("geometry", model, geometry)
        return self._ask("mesh", geometry, self.size, "hxt", 12)


def walk(document, moving, steps, random):
    """Values of the parameters that move, step by step: each by up to a tenth of its range."""
    every = document["parameters"]
    values = {name: every[name]["value"] for name in moving}
    for _ in range(steps):
        for name in moving:
            low, high = every[name]["lower"], every[name]["upper"]
            step = random.uniform(-.1, .1) * (high - low)
            if not low <= values[name] + step <= high:
                step = -step
            values[name] += step
        yield dict(values)


def row(daemon, hxt, base, moving, steps, hold, random):
    """Seconds: of edits, of regular meshes, the same at the client, of HXT; the shares kept, and held."""
    times, kept, held = np.zeros((steps, 5)), [], 0
    part = base
    length = base.report.edge_length
    for k, values in enumerate(walk(base.document(), moving, steps, random)):
        begin = time.monotonic()
        part = part.edit(values, options={"hold": hold}, file=False)
        part.mesh()
        edited = time.monotonic()
        regular = daemon.mesh(part.document(), size=length, order=2, seed=1000 + k, file=False)
        regular.mesh()
        ended = time.monotonic()
        kept.append(part.report.nodes_kept / part.report.nodes)
        held += part.report.way == HELD
        theirs = hxt.mesh(part.document())["cpu"] if hxt._program else 0
        times[k] = (part.report.seconds.total, regular.report.seconds.total, edited - begin,
                    ended - edited, theirs)
    return times.sum(axis=0) / steps, np.mean(kept), held / steps


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("peer", nargs="?")
    parser.add_argument("--nodes", type=int, nargs="+", default=[1500, 15000])
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--hold", type=float, default=0, help="edge lengths; see MeshOptions.hold")
    arguments = parser.parse_args()
    print("| nodes | moving | held | nodes kept | edit, ms | by regular | at the client | by HXT |")
    print("|---|---|---|---|---|---|---|---|")
    with rc.local(arguments.remeshd) as daemon, tempfile.TemporaryDirectory() as folder:
        hxt = Hxt(arguments.peer, folder)
        for nodes in arguments.nodes:
            base = daemon.mesh(BRACKET, nodes=nodes, order=2)
            hxt.fit(base.document(), base.report.nodes, base.report.edge_length)
            every = list(base.document()["parameters"])
            for moving in [every, *([name] for name in every)]:
                random = np.random.default_rng(1)
                (edit, regular, call, regular_call, theirs), kept, held = row(
                    daemon, hxt, base, moving, arguments.steps, arguments.hold, random)
                print(f"| {base.report.nodes} | {'all' if len(moving) > 1 else moving[0]} | "
                      f"{held:.0%} | {kept:.0%} | {1000 * edit:.0f} | {edit / regular:.2f} | "
                      f"{call / regular_call:.2f} | "
                      + (f"{edit / theirs:.2f} |" if theirs else "- |"), flush=True)


main()
