#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""noise.py MODEL: how much of what an optimiser sees is the mesh's doing.

One parameter of the bracket goes over one edge length in 50 steps. At each, displacement and stress
are worked out on a fresh mesh, on one remeshed from the step before, and on one whose connectivity
is held from the middle of the way. Each series is compared with the cubic that fits it best: what
is left is noise.
"""
import argparse

import numpy as np

import remesh_client as rc
from measures import Solved
from remesh_client.v1.report_pb2 import Report

NAMES = ("displacement", "stress")


def series(parts):
    """(steps, 2): displacement and stress of each part."""
    return np.array([[solved.measures.displacement, solved.measures.stress]
                     for solved in map(Solved, parts)])


def noise(x, values):
    """Root mean square about the best cubic, as a share of the mean."""
    x = (x - x.mean()) / np.ptp(x)
    rest = values - np.polyval(np.polyfit(x, values, 3), x)
    return np.sqrt(np.mean(rest**2)) / abs(values.mean())


def chain(part, name, values, **options):
    """The parts of one edit after the other."""
    for value in values:
        part = part.edit({name: value}, options=options)
        yield part


def plot(path, x, name, found):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(2, 1, figsize=(7, 7), sharex=True)
    for k, axis in enumerate(axes):
        for way, values in found.items():
            axis.plot(x, values[:, k], ".-", label=way, linewidth=.8, markersize=4)
        axis.set_ylabel(NAMES[k] + (", mm", ", MPa")[k])
        axis.grid(alpha=.3)
    axes[0].legend()
    axes[1].set_xlabel(f"{name}, mm")
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model")
    parser.add_argument("--parameter", default="pipe_x")
    parser.add_argument("--nodes", type=int, default=1500)
    parser.add_argument("--steps", type=int, default=50)
    parser.add_argument("--even", action="store_true", help="one edge length everywhere")
    parser.add_argument("--plot", metavar="FILE")
    arguments = parser.parse_args()
    name = arguments.parameter
    with rc.connect() as daemon:
        options = {"order": 2, "even": True} if arguments.even else {"order": 2}
        base = daemon.mesh(arguments.model, nodes=arguments.nodes, **options)
        length = base.report.edge_length
        bounds = base.document()["parameters"][name]
        begin = min(bounds["value"], bounds["upper"] - length)
        x = begin + length * np.arange(1, arguments.steps + 1) / arguments.steps
        remeshed = list(chain(base, name, x))
        fresh = [daemon.mesh(part.document(), size=length, file=False, **options)
                 for part in remeshed]
        held = list(chain(fresh[len(x) // 2], name, x, hold=.6))
        found = {way: series(parts) for way, parts in
                 (("fresh", fresh), ("remeshed", remeshed), ("held", held))}
    print(f"{name} from {x[0]:.4g} to {x[-1]:.4g}, edges of {length:.3g}; rms about a cubic")
    print("| | " + " | ".join(NAMES) + " | nodes kept |")
    print("|---|---|---|---|")
    for (way, values), parts in zip(found.items(), (fresh, remeshed, held)):
        kept = np.mean([part.report.nodes_kept / part.report.nodes for part in parts])
        print(f"| {way} | " + " | ".join(f"{100 * noise(x, values[:, k]):.4f} %" for k in range(2))
              + f" | {kept:.0%} |")
    same = sum(part.report.way == Report.WAY_MORPHED for part in held)
    print(f"{same} of {len(held)} held meshes have the connectivity of the one in the middle")
    if arguments.plot:
        plot(arguments.plot, x, name, found)


if __name__ == "__main__":
    main()
