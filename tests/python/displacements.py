#!/usr/bin/env python3
"""displacements.py REMESHD [CASE...]: what CalculiX makes of regular and of remeshed meshes.

For each of the paper's cases and of the detailed parts, held at its lowest plane faces and loaded on
its highest: the displacement under the load (work by force) of the edit's mesh, and of regular
meshes of the edited model with as many nodes from several seeds. Prints a table; exit 1 where
CalculiX fails or warns, and with --check where the remeshed one is off.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

import remesh_client as rc
from remesh_client import calculix

CASES = Path(__file__).parent.parent / "cases"
PAPER = ("simple-ab", "tool1-ab", "tool1-ac", "tool2-ab", "tool2-bc", "tool2-cd", "tool3-ab")
DETAILED = ("carrier", "coldplate", "mount", "valve")
STEEL = calculix.Elastic(210000, .3)
LOAD = np.array([300.0, 0, -1000])


def documents(case):
    """Paths of a model and of its edit."""
    if case in DETAILED:
        return CASES / f"detailed/{case}.json", CASES / f"detailed/{case}.edit.json"
    stem, letters = case.rsplit("-", 1)
    return CASES / f"{stem}-{letters[0]}.json", CASES / f"{case}.edit.json"


def groups(points):
    """Selectors of the faces at the lower and at the upper end."""
    low, high = points[:, 2].min(), points[:, 2].max()
    near = 1e-6 * (high - low)
    return {"supports": f"* & nz < -0.9 && z < {low + near:.9g}",
            "load": f"* & nz > 0.9 && z > {high - near:.9g}"}


def grouped(points):
    return [rc.set_group(name, on) for name, on in groups(points).items()]


def displacement(part, complaints, solver):
    """Of the loaded faces along the load, on the mean."""
    solution = calculix.solve(part.mesh(), STEEL, {"supports": "xyz"}, {"load": LOAD}, limit=3600,
                              solver=solver)
    complaints.extend(solution.warnings)
    return solution.work / np.linalg.norm(LOAD)


def row(daemon, case, nodes, seeds, solver, complaints, **options):
    """Remeshed and regular displacements of a case."""
    model, edit = documents(case)
    probe = daemon.mesh(model, nodes=400)
    edited = probe.edit(edit)
    base = daemon.mesh(model, nodes=nodes, **options)
    base = base.edit(*grouped(probe.mesh().points))
    displacement(base, complaints, solver)
    part = base.edit(edit, *grouped(edited.mesh().points))
    remeshed = displacement(part, complaints, solver)
    regular = []
    for seed in range(1, seeds + 1):
        fresh = daemon.mesh(part.document(), nodes=part.report.nodes, seed=seed, **options)
        regular.append(displacement(fresh, complaints, solver))
    return part, remeshed, np.array(regular)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("remeshd")
    parser.add_argument("cases", nargs="*", default=PAPER + DETAILED, metavar="CASE")
    parser.add_argument("--nodes", type=int, default=15000)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--orders", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--even", action="store_true", help="one edge length everywhere")
    parser.add_argument("--solver", default="", help="of ccx; default: its own choice")
    parser.add_argument("--check", action="store_true",
                        help="fail where remeshed is off by more than .5 %% or twice the spread + .1 %%")
    arguments = parser.parse_intermixed_args()
    print("| case | order | nodes | kept | regular, mean | spread | remeshed | off |")
    print("|---|---|---|---|---|---|---|---|")
    wrong, complaints = [], []
    with rc.local(arguments.remeshd) as daemon:
        for case in arguments.cases or PAPER + DETAILED:
            for order in arguments.orders:
                part, remeshed, regular = row(daemon, case, arguments.nodes, arguments.seeds,
                                              arguments.solver, complaints, order=order,
                                              **({"even": True} if arguments.even else {}))
                mean = regular.mean()
                spread = np.ptp(regular) / mean
                off = remeshed / mean - 1
                print(f"| `{case}` | {order} | {part.report.nodes} | {part.report.nodes_kept} | "
                      f"{mean:.5g} | {100 * spread:.2f} % | {remeshed:.5g} | {100 * off:+.2f} % |",
                      flush=True)
                if abs(off) > min(.005, 2 * spread + .001):
                    wrong.append(f"{case}, order {order}")
    for line in complaints:
        print("CalculiX: " + line)
    if wrong:
        print("off by more than .5 %, or twice the spread and .1 %: " + "; ".join(wrong))
    sys.exit(1 if complaints or (arguments.check and wrong) else 0)


main()
