#!/usr/bin/python3
"""Time a node takes as the size field gets steeper, the number of nodes the same.

    tests/paper/grading.py [--nodes 15000] [--rounds 5] build/bin [FOLDER]   # default: pictures

A cube with a ball in its middle in which edges are 1 to 50 times shorter than far from it. Draws
grading.png; goal: at most 1.5 times what a node of an even mesh takes. The least of some rounds, in
turn.
"""
import argparse
import json
import subprocess
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

RATIOS = (1, 2, 5, 10, 20, 50)
SIDE = 100.0
GOAL = 1.5


def model(ratio, nodes):
    base = SIDE / (nodes / 1.41) ** (1 / 3)    # of an even mesh, about
    part = {"name": f"grading{ratio}", "unit": "mm", "features": [
        {"id": "cube", "type": "block", "nature": "ADDITIVE",
         "parameters": {"dx": SIDE, "dy": SIDE, "dz": SIDE}, "placement": {"origin": [0, 0, 0]}}]}
    if ratio > 1:
        size = base / ratio
        part["sizes"] = [{"id": "spot", "in": {"ball": [0, 0, SIDE / 2, 2 * size]}, "size": size}]
    return part


def run(binaries, ratio, nodes):
    """Seconds a node, nodes, and the longest over the shortest edge length aimed at."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "model.json").write_text(json.dumps(model(ratio, nodes)))
        subprocess.run([str(Path(binaries) / "remesh"), "--local", "-q", "--store",
                        str(folder / "store"), "mesh", str(folder / "model.json"),
                        "--nodes", str(nodes), *(["--even"] if ratio == 1 else []),
                        "-o", str(folder / "mesh.msh"), "--json", str(folder / "report.json")],
                       check=True, stdout=subprocess.DEVNULL)
        report = json.loads((folder / "report.json").read_text())
    made = int(report["nodes"])
    return report["seconds"]["total"] / made, made


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", help="folder of remesh")
    parser.add_argument("folder", nargs="?", default=Path(__file__).parent / "pictures", type=Path)
    parser.add_argument("--nodes", type=int, default=15000)
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    least = {}
    for _ in range(options.rounds):
        for ratio in RATIOS:
            seconds, made = run(options.binaries, ratio, options.nodes)
            least[ratio] = min(least.get(ratio, (seconds, made)), (seconds, made))
    shares = [least[r][0] / least[1][0] for r in RATIOS]
    for ratio, share in zip(RATIOS, shares):
        print(f"1 to {ratio}: {least[ratio][1]} nodes, {share:.2f} of an even mesh's time a node")
    plt.figure(figsize=(6, 3.6))
    plt.semilogx(RATIOS, shares, "o-")
    plt.axhline(GOAL, color="0.6", linestyle="--")
    plt.xticks(RATIOS, RATIOS)
    plt.xlabel("longest edge length over shortest")
    plt.ylabel("time a node / even")
    plt.ylim(0, max(2, 1.1 * max(shares)))
    plt.tight_layout()
    plt.savefig(options.folder / "grading.png", dpi=110)


if __name__ == "__main__":
    main()
