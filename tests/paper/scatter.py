#!/usr/bin/python3
"""How much a displacement depends on the seed of the mesh: tool1-a in CalculiX.

    tests/paper/scatter.py [--seeds 1 2 3 4 5] [--nodes 3000] [--order 1|2] [--even] build/bin

The bottom of the plate is held, the top of pin1 is loaded along x by a total force, spread over its
facets evenly. Told is the mean displacement along x of the loaded face, weighted as the force is:
twice the work for a unit of force. Needs `ccx` (Debian: calculix-ccx).
"""
import argparse
import statistics
import subprocess
import tempfile
from pathlib import Path

import numpy as np

MODEL = Path(__file__).parent.parent / "cases/tool1-a.json"
FORCE = 1000.0        # N
MATERIAL = "*MATERIAL, NAME=steel\n*ELASTIC\n210000, .3\n"
# Of a C3D4 or C3D10: corners of each face, and the mid-nodes between them.
FACES = {"S1": ((0, 1, 2), (4, 5, 6)), "S2": ((0, 3, 1), (7, 8, 4)),
         "S3": ((1, 3, 2), (8, 9, 5)), "S4": ((2, 3, 0), (9, 7, 6))}


def parameter(line, name):
    """Of a line that begins with a keyword; None where it has none of that name."""
    for field in line.split(",")[1:]:
        if field.split("=")[0].strip().upper() == name:
            return field.split("=")[1].strip()
    return None


def read_mesh(file):
    """Nodes and elements by label, and the facets of each surface: labels of corners and of mid-nodes."""
    nodes, elements, surfaces, kind, name = {}, {}, {}, None, None
    for line in file.read_text().splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            kind = line.split(",")[0].strip().upper()
            name = parameter(line, "NAME")
            continue
        fields = [f.strip() for f in line.split(",")]
        if kind == "*NODE":
            nodes[int(fields[0])] = np.array([float(f) for f in fields[1:4]])
        elif kind == "*ELEMENT":
            elements[int(fields[0])] = [int(f) for f in fields[1:]]
        elif kind == "*SURFACE":
            element = elements[int(fields[0])]
            corners, mids = ([element[k] for k in at if k < len(element)] for at in FACES[fields[1]])
            surfaces.setdefault(name, []).append((corners, mids))
    return nodes, elements, surfaces


def share_of_force(nodes, facets):
    """By node the share of a force that is spread evenly over plane facets.

    The shape functions of a quadratic triangle integrate to 0 at its corners, to a third at its mid-nodes.
    """
    shares, whole = {}, 0.0
    for corners, mids in facets:
        a, b, c = (nodes[n] for n in corners)
        area = .5 * np.linalg.norm(np.cross(b - a, c - a))
        whole += area
        for n in mids or corners:
            shares[n] = shares.get(n, 0.0) + area / 3
    return {n: share / whole for n, share in shares.items()}


def displacement(folder, mesh):
    nodes, elements, surfaces = read_mesh(mesh)
    shares = share_of_force(nodes, surfaces["pin1_top"])
    lines = [f"*INCLUDE, INPUT={mesh.name}", MATERIAL.rstrip(),
             "*ELSET, ELSET=all_tets, GENERATE", f"{min(elements)}, {max(elements)}",
             "*SOLID SECTION, ELSET=all_tets, MATERIAL=steel",
             "*NSET, NSET=loaded", *(f"{n}," for n in sorted(shares)),
             "*STEP", "*STATIC", "*BOUNDARY", "plate_bottom, 1, 3", "*CLOAD",
             *(f"{n}, 1, {FORCE * share:.12g}" for n, share in sorted(shares.items())),
             "*NODE PRINT, NSET=loaded", "U", "*END STEP", ""]
    (folder / "job.inp").write_text("\n".join(lines))
    subprocess.run(["ccx", "job"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    mean = 0.0
    for line in (folder / "job.dat").read_text().splitlines():
        fields = line.split()
        if len(fields) == 4 and fields[0].isdigit():
            mean += shares[int(fields[0])] * float(fields[1])
    return len(nodes), mean


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("binaries", help="folder of remesh")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2, 3, 4, 5])
    parser.add_argument("--nodes", type=int, default=3000)
    parser.add_argument("--order", type=int, choices=(1, 2), default=1, help="of the tets")
    parser.add_argument("--even", action="store_true")
    options = parser.parse_args()
    found = []
    for seed in options.seeds:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            mesh = folder / "mesh.inp"
            subprocess.run([str(Path(options.binaries) / "remesh"), "--local", "-q", "--store",
                            str(folder / "store"), "mesh", str(MODEL),
                            "--nodes", str(options.nodes), "--seed", str(seed),
                            "--order", str(options.order),
                            *(["--even"] if options.even else []), "-o", str(mesh)], check=True)
            nodes, mean = displacement(folder, mesh)
        print(f"seed {seed}: {nodes} nodes, {1000 * mean:.4f} um")
        found.append(mean)
    scatter = (max(found) - min(found)) / statistics.mean(found)
    print(f"(max - min) / mean: {100 * scatter:.2f} %")


if __name__ == "__main__":
    main()
