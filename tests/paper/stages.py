#!/usr/bin/python3
"""Draws the stages of a mesh and of a remesh as in the paper's Figs. 3, 15 and 16.

    tests/paper/stages.py build/bin [FOLDER]     # default: tests/paper/pictures

The case is tool1-ac, which translates four holes as the paper's Fig. 14 does.
"""
import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import PolyCollection

from cases import CASES
from daemon import Daemon
from model_geometry import Model

CASE = next(c for c in CASES if c.name == "tool1-ac")
COPIED, NEW, FREE = "0.72", "tab:red", "tab:blue"


class Stage:
    """Nodes, what they are, and tets of one dump."""

    def __init__(self, path):
        data = meshio.read(path)
        self.nodes = np.asarray(data.points)
        self.tets = np.vstack([np.empty((0, 4), int)] + [c.data for c in data.cells if c.type == "tetra"])
        self.new, self.free = (data.point_data[k].ravel().astype(bool) for k in ("new", "free"))


def slice_polygons(nodes, tets, height):
    """Where the plane z = height cuts the tets: a triangle or a quadrilateral each."""
    polygons, owners = [], []
    above = nodes[:, 2] > height
    for t in np.flatnonzero((above[tets].sum(1) % 4) > 0):
        upper, lower = ([n for n in tets[t] if above[n] == side] for side in (True, False))
        pairs = [(u, v) for u in upper for v in lower]
        if len(pairs) == 4:
            pairs[2], pairs[3] = pairs[3], pairs[2]  # round the quadrilateral
        s = [(height - nodes[v, 2]) / (nodes[u, 2] - nodes[v, 2]) for u, v in pairs]
        polygons.append([nodes[v, :2] + k * (nodes[u, :2] - nodes[v, :2]) for (u, v), k in zip(pairs, s)])
        owners.append(t)
    return polygons, np.array(owners)


def volume_length(nodes, tets):
    a, b, c, d = (nodes[tets[:, i]] for i in range(4))
    volume = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
    edges = sum(((p - q) ** 2).sum(1) for p, q in ((a, b), (a, c), (a, d), (b, c), (b, d), (c, d)))
    return 6 * np.sqrt(2) * np.abs(volume) / (edges / 6) ** 1.5


def last_attempt(folder):
    """The dumps of the attempt that was taken: `4-local-4-edge-lengths`."""
    return max(folder.iterdir(), key=lambda attempt: int(attempt.name.split("-")[0]))


def evolution(folder, model, out):
    """Fig. 3: a cut through the plate while VTM runs."""
    stages = [("after the first placing of boundary nodes", "07-optimise-01"),
              ("after one loop", "07-optimise-02"), ("after ten loops", "08-peel")]
    figure, axes = plt.subplots(1, 3, figsize=(15, 5.4))
    for letter, ax, (title, name) in zip("abc", axes, stages):
        stage = Stage(folder / (name + ".vtu"))
        inside = stage.tets[model.inside(stage.nodes[stage.tets].mean(1))]
        polygons, owners = slice_polygons(stage.nodes, inside, 6)
        drawn = PolyCollection(polygons, array=volume_length(stage.nodes, inside)[owners], cmap="viridis",
                               edgecolors="k", linewidths=.4)
        drawn.set_clim(0, 1)
        ax.add_collection(drawn)
        ax.set_title(f"{letter}) {title}")
        frame(ax)
    figure.colorbar(drawn, ax=axes, shrink=.7, label="volume-length")
    save(figure, out / "fig03-evolution.png")


def copied_and_new(folder, out):
    """Fig. 15: top view of the nodes that the remesh starts from."""
    stage = Stage(folder / "05-nodes.vtu")
    figure, axes = plt.subplots(1, 2, figsize=(10, 5.2))
    axes[0].set_title("a) copied nodes")
    axes[1].set_title("b) new nodes")
    dots(axes[0], stage.nodes[~stage.new], COPIED)
    dots(axes[1], stage.nodes[~stage.new], "0.9")
    dots(axes[1], stage.nodes[stage.new], NEW)
    save(figure, out / "fig15-nodes.png")


def free_nodes(folder, out):
    """Fig. 16: the nodes that the optimisation moves, before and after the two expansions."""
    start = Stage(folder / "05-nodes.vtu")
    last = Stage(folder / "07-optimise-05.vtu")
    ever = np.zeros(len(last.nodes), bool)  # a node at rest is no longer marked as free
    for name in ("05-nodes", *(f"07-optimise-0{k}" for k in range(1, 6))):
        free = Stage(folder / (name + ".vtu")).free
        ever[:len(free)] |= free
    figure = plt.figure(figsize=(10, 10.2))
    for k, (title, nodes, colour) in enumerate((("a) new nodes", start.nodes[start.new], NEW),
                                                ("b) free nodes", start.nodes[start.free], FREE),
                                                ("c) expanded free nodes", last.nodes[ever], FREE))):
        ax = figure.add_subplot(2, 2, k + 1)
        ax.set_title(title)
        dots(ax, start.nodes, "0.9")
        dots(ax, nodes, colour)
    ax = figure.add_subplot(2, 2, 4, projection="3d", elev=35, azim=-60)
    ax.set_title("d) expanded free nodes, rotated")
    ax.scatter(*last.nodes[ever].T, s=2, c=FREE, linewidths=0)
    ax.set_box_aspect(np.ptp(last.nodes[ever], axis=0), zoom=1.25)
    ax.set_axis_off()
    save(figure, out / "fig16-free.png")


def dots(ax, nodes, colour):
    ax.scatter(nodes[:, 0], nodes[:, 1], s=2, c=colour, linewidths=0)
    frame(ax)


def frame(ax):
    ax.set_xlim(-52, 52)
    ax.set_ylim(-52, 52)
    ax.set_aspect("equal")
    ax.set_axis_off()


def save(figure, path):
    figure.savefig(path, dpi=80, bbox_inches="tight")
    plt.close(figure)
    print(path)


def main(binaries, out=Path(__file__).with_name("pictures")):
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder, Daemon(binaries, "--dumps", folder) as daemon:
        def mesh(nodes):
            return daemon.run("mesh", CASE.path(CASE.original), "--nodes", nodes, "--iterations", 10,
                              out="original")["revision"]

        remesh = daemon.run("edit", mesh(15000), CASE.path(CASE.edit), out="remesh")["revision"]
        evolution(last_attempt(Path(folder) / mesh(4000)), Model(CASE.path(CASE.original)), out)
        copied_and_new(last_attempt(Path(folder) / remesh), out)
        free_nodes(last_attempt(Path(folder) / remesh), out)


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
