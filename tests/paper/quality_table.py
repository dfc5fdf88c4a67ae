#!/usr/bin/python3
"""Meshes the seven cases for many seeds and tells the worst quality of any mesh.

    tests/paper/quality_table.py [--nodes 15000 30000 100000] [--seeds 1 ... 10] [--cases NAME...]
                                 build/bin

puts the table into README.md between its two marks and draws pictures/fig18-quality.png. Angles and
measures are quality.py's, which shares nothing with the engine. Exit 0 if every goal holds, 1 if one
does not. All of it takes about an hour and a half of one core; with `--record FILE` several runs, of
some cases each, share the work, and one of all cases then finds it done. Meshing is with --even, else
as the CLI does by default: lattice start, iterations until quality stops improving.
"""
import argparse
import hashlib
import json
import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import quality
from cases import CASES
from daemon import Daemon

README = Path(__file__).with_name("README.md")
PICTURE = Path(__file__).with_name("pictures") / "fig18-quality.png"
BEGIN, END = "<!-- quality_table.py begin -->", "<!-- quality_table.py end -->"

LEAST_ANGLE, LARGEST_ANGLE, LEAST_MEASURE, MEAN_MEASURE = 25, 145, 0.42, 0.83
DRAWN = ("tool1-ac", "tool2-cd", "tool3-ab")  # Fig. 18 shows three, too
DRAWN_NODES = 15000


@dataclass
class Worst:
    """Of all meshes of one kind: (value, seed) where each measure is worst."""
    meshes: int = 0
    values: dict = field(default_factory=dict)

    def add(self, measured, seed):
        self.meshes += 1
        for name, value, worse in (("dih_min", measured["dih_min"], min), ("dih_max", measured["dih_max"], max),
                                   ("vl_min", measured["vl_min"], min), ("vl_mean", measured["vl_mean"], min)):
            here = (value, seed)
            self.values[name] = here if name not in self.values else worse(self.values[name], here)

    def good(self):
        v = {name: value for name, (value, _) in self.values.items()}
        return (v["dih_min"] >= LEAST_ANGLE and v["dih_max"] <= LARGEST_ANGLE and
                v["vl_min"] >= LEAST_MEASURE and v["vl_mean"] >= MEAN_MEASURE)

    def cells(self):
        forms = {"dih_min": ".1f", "dih_max": ".1f", "vl_min": ".3f", "vl_mean": ".3f"}
        return [f"{self.values[name][0]:{form}} ({self.values[name][1]})" for name, form in forms.items()]


class Record:
    """What has been measured of the meshes of the same daemon, a line of JSON for each case, number of
    nodes and seed. Without a file it remembers nothing."""

    def __init__(self, file, binaries, sized):
        self.file = file
        self.daemon = hashlib.sha256((Path(binaries) / "remeshd").read_bytes()).hexdigest() + sized * " sized"
        self.lines = {}
        if file and file.exists():
            for line in map(json.loads, file.read_text().splitlines()):
                if line["daemon"] == self.daemon:
                    self.lines[line["case"], line["nodes"], line["seed"]] = line["measured"]

    def find(self, case, nodes, seed):
        return self.lines.get((case, nodes, seed))

    def add(self, case, nodes, seed, measured):
        if self.file:
            line = {"daemon": self.daemon, "case": case, "nodes": nodes, "seed": seed, "measured": measured}
            with self.file.open("a") as out:
                out.write(json.dumps(line) + "\n")


def measures(file):
    """Volume-length measure of each tet."""
    points, tets = quality.load(file)
    corners = points[tets]
    edges = corners[:, [1, 2, 3, 2, 3, 3]] - corners[:, [0, 0, 0, 1, 1, 2]]
    volumes = np.einsum("ij,ij->i", np.cross(edges[:, 0], edges[:, 1]), edges[:, 2]) / 6
    return 6 * np.sqrt(2) * volumes / ((edges ** 2).sum((1, 2)) / 6) ** 1.5


def run(daemon, case, nodes, seed):
    """Meshes the original, remeshes, and meshes anew; returns the files of the two meshes of the
    modified model beside the original's, by kind."""
    options = ["--seed", seed]
    original = daemon.run("mesh", case.path(case.original), "--nodes", nodes, *options, out="original")
    remesh = daemon.run("edit", original["revision"], case.path(case.edit), out="remesh")
    daemon.run("mesh", case.path(case.modified), "--nodes", remesh["nodes"], *options, out="regular")
    return {kind: daemon.file(kind + ".vtu") for kind in ("original", "remesh", "regular")}


def draw(drawn):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, len(drawn), figsize=(4 * len(drawn), 3), sharey=True)
    bins = np.linspace(0, 1, 51)
    for ax, (name, shares) in zip(axes, drawn.items()):
        for kind, style in (("regular", {"alpha": 0.45}), ("remesh", {"histtype": "step", "linewidth": 1.4})):
            q = shares[kind]
            ax.hist(q, bins, weights=np.full(len(q), 100 / len(q)), label=kind, **style)
        ax.set_title(name)
        ax.set_xlabel("volume-length measure")
    axes[0].set_ylabel("% of tets")
    axes[0].legend(loc="upper left")
    figure.tight_layout()
    PICTURE.parent.mkdir(exist_ok=True)
    figure.savefig(PICTURE, dpi=110)


def table(rows, seeds):
    lines = [f"Seeds {min(seeds)} to {max(seeds)}; in brackets the seed of the worst mesh. *first* is the mesh "
             "of the original model, *regular* that of the modified model with the remesh's node count.", "",
             "| case | nodes | mesh | least dihedral | largest dihedral | least volume-length | least mean |",
             "|---|---|---|---|---|---|---|"]
    names = {"original": "first", "remesh": "remesh", "regular": "regular"}
    for (case, nodes, kind), worst in rows.items():
        lines.append(f"| {case} | {nodes:,} | {names[kind]} | " + " | ".join(worst.cells()) + " |")
    meshes = sum(w.meshes for w in rows.values())
    missed = [key for key, worst in rows.items() if not worst.good()]
    lines += ["", f"{meshes} meshes. Goals: dihedral angles {LEAST_ANGLE} to {LARGEST_ANGLE} degrees, "
              f"volume-length at least {LEAST_MEASURE}, its mean at least {MEAN_MEASURE}: " +
              ("all hold." if not missed else f"missed in {len(missed)} of {len(rows)} rows.")]
    return "\n".join(lines) + "\n", not missed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", help="folder of remeshd and remesh")
    parser.add_argument("--nodes", nargs="+", type=int, default=[15000, 30000, 100000])
    parser.add_argument("--seeds", nargs="+", type=int, default=list(range(1, 11)))
    parser.add_argument("--cases", nargs="+", choices=[c.name for c in CASES])
    parser.add_argument("--record", type=Path, help="file of what has been measured, to go on with")
    parser.add_argument("--sized", action="store_true", help="by the default rules, not even")
    options = parser.parse_args()

    record = Record(options.record, options.binaries, options.sized)
    rows, drawn = {}, {}
    for case in CASES:
        if options.cases and case.name not in options.cases:
            continue
        with Daemon(options.binaries, sized=options.sized) as daemon:
            for nodes in options.nodes:
                for seed in options.seeds:
                    to_draw = case.name in DRAWN and nodes == DRAWN_NODES and case.name not in drawn
                    measured = record.find(case.name, nodes, seed)
                    if measured is None or to_draw:
                        files = run(daemon, case, nodes, seed)
                        measured = {kind: quality.quality(*quality.load(file)) for kind, file in files.items()}
                        record.add(case.name, nodes, seed, measured)
                    if to_draw:
                        drawn[case.name] = {kind: measures(file) for kind, file in files.items()}
                    for kind, values in measured.items():
                        rows.setdefault((case.name, nodes, kind), Worst()).add(values, seed)
                for kind in ("original", "remesh", "regular"):
                    print(case.name, nodes, kind, *rows[case.name, nodes, kind].cells(), flush=True)
    text, good = table(rows, options.seeds)
    if not options.cases:
        before, rest = README.read_text().split(BEGIN)
        README.write_text(before + BEGIN + "\n" + text + END + rest.split(END)[1])
        draw(drawn)
    print(text)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
