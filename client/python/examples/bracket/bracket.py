#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bracket.py MODEL: the lightest bracket that is stiff and strong enough.

Five parameters of the example `bracket` (remesh example bracket -o bracket.json) are changed by
COBYLA (Powell 1994), which needs no gradients. Each design is the last one remeshed, of second order,
and solved by CalculiX. Prints a line a design, and what remeshing saved.
"""
import argparse
import time

import numpy as np
from scipy.optimize import minimize

import remesh_client as rc

STEEL = rc.calculix.Elastic(210000, .3)  # MPa
DENSITY = 7.85e-6  # kg/mm^3
LOAD = (3000, 0, -2000)  # N, on the pipe's top
MOST_STRESS = 60.0  # MPa
MOST_DISPLACEMENT = .06  # mm


def stress_measure(mesh, solution, power=12):
    """A smooth maximum of the von Mises stress, MPa: its power mean, weighted by the volume of the
    nodes' tets. Nodes near the supports, where stress depends on how they are held, are left out."""
    corners = mesh.points[mesh.tets]
    volumes = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    weights = np.zeros(len(mesh.points))
    np.add.at(weights, mesh.tets, volumes[:, None] / 4)
    held = mesh.points[mesh.groups["supports"].nodes]
    near = np.array([np.linalg.norm(held - p, axis=1).min() < 12 for p in mesh.points])
    weights[near] = 0
    stress = solution.von_mises[:len(mesh.points)]
    return (np.sum(weights * stress**power) / weights.sum()) ** (1 / power)


class Bracket:
    """Designs of the bracket, each remeshed from the one before."""

    def __init__(self, part):
        self.part = part
        document = part.document()["parameters"]
        self.names = list(document)
        self.low = np.array([document[name]["lower"] for name in self.names], float)
        self.high = np.array([document[name]["upper"] for name in self.names], float)
        self.start = np.array([document[name]["value"] for name in self.names], float)
        self.known = {}
        self.remeshing = self.solving = 0.0

    def at(self, x):
        """Mass, kg, and what is left to the limits of stress and displacement, as shares of them.

        x: the parameters, each as a share of its range.
        """
        design = tuple(np.round(self.low + np.clip(x, 0, 1) * (self.high - self.low), 6))
        if design not in self.known:
            self.known[design] = self._solve(design)
        return self.known[design]

    def _solve(self, design):
        begin = time.monotonic()
        self.part = self.part.edit(dict(zip(self.names, design)))
        mesh = self.part.mesh()
        meshed = time.monotonic()
        solution = rc.calculix.solve(mesh, STEEL, {"supports": "xyz"}, {"load": LOAD})
        solved = time.monotonic()
        self.remeshing += meshed - begin
        self.solving += solved - meshed
        mass = DENSITY * self.part.report.exact_volume
        displacement = solution.work / np.linalg.norm(LOAD)
        stress = stress_measure(mesh, solution)
        report = self.part.report
        print(f"{len(self.known) + 1:3}  {mass:.4f} kg  {stress:5.1f} MPa  {displacement:.4f} mm  "
              f"kept {report.nodes_kept / report.nodes:4.0%}  remeshed {meshed - begin:.2f} s  "
              f"solved {solved - meshed:.2f} s  "
              + " ".join(f"{n}={v:.4g}" for n, v in zip(self.names, design)), flush=True)
        return mass, 1 - stress / MOST_STRESS, 1 - displacement / MOST_DISPLACEMENT


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model")
    parser.add_argument("--nodes", type=int, default=1500)
    parser.add_argument("--solves", type=int, default=40)
    arguments = parser.parse_args()
    with rc.connect() as daemon:
        first = daemon.mesh(arguments.model, nodes=arguments.nodes, order=2)
        bracket = Bracket(first)
        start = (bracket.start - bracket.low) / (bracket.high - bracket.low)
        limits = [{"type": "ineq", "fun": lambda x, k=k: bracket.at(x)[k]} for k in (1, 2)]
        limits += [{"type": "ineq", "fun": lambda x, k=k: x[k]} for k in range(len(start))]
        limits += [{"type": "ineq", "fun": lambda x, k=k: 1 - x[k]} for k in range(len(start))]
        minimize(lambda x: bracket.at(x)[0], start, method="COBYLA", constraints=limits,
                 options={"maxiter": arguments.solves, "rhobeg": .25, "tol": .01})
        fine = [(values[0], design) for design, values in bracket.known.items()
                if min(values[1:]) > -1e-3]
        begin = time.monotonic()
        daemon.mesh(bracket.part.document(), size=first.report.edge_length, order=2, seed=7,
                    file=False).mesh()
        regular = time.monotonic() - begin
    count = len(bracket.known)
    print(f"{count} designs: remeshing {bracket.remeshing:.1f} s, regular meshes would have taken "
          f"about {count * regular:.1f} s; solving {bracket.solving:.1f} s")
    if not fine:
        raise SystemExit("no design within the limits")
    mass, design = min(fine)
    begin = list(bracket.known.values())[0][0]
    print(f"lightest within the limits: {mass:.4f} kg, {1 - mass / begin:.0%} less than at first: "
          + ", ".join(f"{name} {value:.4g}" for name, value in zip(bracket.names, design)))


main()
