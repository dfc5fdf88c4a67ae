#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bracket.py MODEL: the lightest bracket that is stiff and strong enough.

Five parameters of the example `bracket` (remesh example bracket -o bracket.json) are changed by
SLSQP with gradients from design velocities and adjoint solutions, or by COBYLA, which needs none.
Each design is the last one remeshed, of second order, and solved by CalculiX. While surfaces are within
HOLD edge lengths of where they were, and tets are good, connectivity is held. Prints a line a design,
and what remeshing saved.
"""
import argparse
import os
import shutil
import subprocess
import time

import numpy as np
from scipy.optimize import minimize

import remesh_client as rc
from measures import Solved
from remesh_client.v1.report_pb2 import Report

MOST_STRESS = 50.0  # MPa
MOST_DISPLACEMENT = .06  # mm
HOLD = 3.0  # edge lengths
NEARLY = 1e-3  # share of a limit: a design that misses it by less is within it


class EnoughSolves(Exception):
    """As many as asked for."""


class Bracket:
    """Designs of the bracket, each remeshed from the one before."""

    def __init__(self, daemon, part, most_solves):
        self.daemon, self.part = daemon, part
        self.length = part.report.edge_length
        document = part.document()["parameters"]
        self.names = list(document)
        self.low = np.array([document[name]["lower"] for name in self.names], float)
        self.high = np.array([document[name]["upper"] for name in self.names], float)
        begin = np.array([document[name]["value"] for name in self.names], float)
        self.start = (begin - self.low) / (self.high - self.low)
        self.most_solves = most_solves
        self.solves = self.held = 0
        self.known = {}  # by design: values
        self.revisions = {}  # by design
        self.slopes = {}  # by design: derivatives by x
        self.last = None  # the design that `solved` is of
        self.solved = None
        self.remeshing = self.regular = self.solving = 0.0

    def design_at(self, x):
        """Parameters, from x: each as a share of its range."""
        return tuple(np.round(self.low + np.clip(x, 0, 1) * (self.high - self.low), 6))

    def values(self, x):
        """Mass, kg, and what is left to the limits of stress and displacement, as shares of them."""
        design = self.design_at(x)
        if design not in self.known:
            self.known[design] = self._solve(design)
        return self.known[design]

    def gradients(self, x):
        """Of the same by x: (3, parameters)."""
        design = self.design_at(x)
        if design not in self.slopes:
            if design != self.last:
                self._solve(design)
            begin = time.monotonic()
            rows = self.solved.gradients(*self.names) * (self.high - self.low)
            self.solving += time.monotonic() - begin
            self.solves += 1
            self.slopes[design] = np.array([rows[0], -rows[2] / MOST_STRESS,
                                            -rows[1] / MOST_DISPLACEMENT])
        return self.slopes[design]

    def _solve(self, design):
        if self.solves >= self.most_solves:
            raise EnoughSolves
        begin = time.monotonic()
        self.part = self.part.edit(dict(zip(self.names, design)), options={"hold": HOLD})
        self.part.mesh()
        remeshed = time.monotonic()
        self.daemon.mesh(self.part.document(), size=self.length, order=2, seed=2 + self.solves,
                         file=False).mesh()  # for its time alone
        meshed = time.monotonic()
        self.solved, self.last = Solved(self.part), design
        self.revisions[design] = self.part.revision
        self.solves += 1
        ended = time.monotonic()
        self.remeshing += remeshed - begin
        self.regular += meshed - remeshed
        self.solving += ended - meshed
        measures, report = self.solved.measures, self.part.report
        held = report.way == Report.WAY_MORPHED
        self.held += held
        print(f"{len(self.known) + 1:3}  {measures.mass:.4f} kg  {measures.stress:5.1f} MPa  "
              f"{measures.displacement:.4f} mm  "
              f"{'held' if held else f'kept {report.nodes_kept / report.nodes:.0%}':9}  "
              f"remeshed {remeshed - begin:.2f} s, anew {meshed - remeshed:.2f} s  "
              f"solved {ended - meshed:.2f} s  "
              + " ".join(f"{n}={v:.4g}" for n, v in zip(self.names, design)), flush=True)
        return (measures.mass, 1 - measures.stress / MOST_STRESS,
                1 - measures.displacement / MOST_DISPLACEMENT)

    def by_gradients(self):
        minimize(lambda x: self.values(x)[0], self.start, method="SLSQP",
                 jac=lambda x: self.gradients(x)[0], bounds=[(0, 1)] * len(self.start),
                 constraints=[{"type": "ineq", "fun": lambda x: np.array(self.values(x)[1:]),
                               "jac": lambda x: self.gradients(x)[1:]}],
                 options={"ftol": 1e-4, "maxiter": self.most_solves})

    def by_values(self):
        limits = [{"type": "ineq", "fun": lambda x, k=k: self.values(x)[k]} for k in (1, 2)]
        limits += [{"type": "ineq", "fun": lambda x, k=k: x[k]} for k in range(len(self.start))]
        limits += [{"type": "ineq", "fun": lambda x, k=k: 1 - x[k]} for k in range(len(self.start))]
        minimize(lambda x: self.values(x)[0], self.start, method="COBYLA", constraints=limits,
                 options={"maxiter": self.most_solves, "rhobeg": .25, "tol": .01})

    def tell(self):
        """Prints totals, and the lightest design within the limits, which it returns."""
        fine = [(values[0], design) for design, values in self.known.items()
                if min(values[1:]) > -NEARLY]
        print(f"{len(self.known)} designs, {self.held} held, {self.solves} solutions: remeshing "
              f"{self.remeshing:.1f} s, regular meshes {self.regular:.1f} s, solving "
              f"{self.solving:.1f} s")
        if not fine:
            raise SystemExit("no design within the limits")
        mass, design = min(fine)
        begin = next(iter(self.known.values()))[0]
        print(f"lightest within the limits: {mass:.4f} kg, {1 - mass / begin:.0%} less than at first: "
              + ", ".join(f"{name} {value:.4g}" for name, value in zip(self.names, design)))
        return design


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model")
    parser.add_argument("--nodes", type=int, default=1500)
    parser.add_argument("--solves", type=int, default=40, help="at most, adjoint ones among them")
    parser.add_argument("--no-gradients", action="store_true", help="by COBYLA")
    parser.add_argument("--page", metavar="FILE",
                        help="from the first design to the lightest, in 3-D, by `remesh report`")
    arguments = parser.parse_args()
    if arguments.page and not shutil.which("remesh"):
        parser.error("--page: the program `remesh` is not in the PATH")
    with rc.connect() as daemon:
        first = daemon.mesh(arguments.model, nodes=arguments.nodes, order=2)
        bracket = Bracket(daemon, first, arguments.solves)
        try:
            bracket.by_values() if arguments.no_gradients else bracket.by_gradients()
        except EnoughSolves:
            pass
        design = bracket.tell()
        if arguments.page:
            subprocess.run(["remesh", "report", first.revision, bracket.revisions[design],
                            "-o", arguments.page],
                           env={**os.environ, "REMESH_ADDRESS": daemon.address}, check=True)


if __name__ == "__main__":
    main()
