#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""textbook.py: meshes of three parts, solved by CalculiX, beside the textbooks' closed solutions.

A bar that is bent by a force at its end, a quarter of a plate with a hole, a quarter of a cylinder
under pressure: each with tets of first and of second order and with edges of several lengths. What
the meshes do not say of a closed solution is prescribed of it, so that errors go to nought with the
edge length. Prints tables of errors and of the orders at which they fall.
"""
import argparse
import time
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

import exact
import remesh_client as rc

STEEL = rc.calculix.Elastic(210000, .3)  # MPa; lengths are in mm
_MATERIAL = (STEEL.young, STEEL.poisson)
MEASURES = ("displacement", "stress", "averaged")
EXPECTED = {1: (2, 1, 1), 2: (3, 2, 2)}  # by order of the tets, as MEASURES

# Quadrature of a tet, exact to degree 5 (Walkington 2000): barycentric coordinates, weights.
_A, _B, _C = .0927352503108912, .3108859192633006, .0455037041256497
_PLACES = np.array([[1 - 3 * p if k == j else p for k in range(4)]
                    for p in (_A, _B) for j in range(4)]
                   + [[.5 - _C if k in pair else _C for k in range(4)]
                      for pair in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))])
_WEIGHTS = np.repeat([.0734930431163619, .1126879257180159, .0425460207770815], [4, 4, 6])
_EDGES = np.array([[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])
_CHUNK = 10000  # tets at a time


@dataclass(frozen=True)
class Case:
    """A part, what holds and loads it, its solution, and a figure that engineers look at.

    figure: of (mesh, solution of CalculiX); `value` is what it is in theory.
    """

    name: str
    model: dict
    solution: exact.Solution
    supports: dict
    loads: dict
    quantity: str
    value: float
    figure: Callable
    sizes: dict = field(default_factory=dict)  # edge lengths by order


@dataclass(frozen=True)
class Row:
    """What one mesh came to. errors: as MEASURES, each as a share of the solution's own norm."""

    size: float
    nodes: int
    tets: int
    errors: tuple
    figure: float
    seconds: float


# The parts -----------------------------------------------------------------------------------


def bar():
    """Half of a bar: the closed displacement at one end, the closed shear stress at the other."""
    flexure = exact.Flexure(*_MATERIAL, length=4, half_width=.5, half_depth=.5, force=100)
    model = {
        "name": "bar", "unit": "mm", "parameters": {"length": 4},
        "features": [{"id": "bar", "nature": "ADDITIVE", "type": "block",
                      "parameters": {"dx": "length", "dy": .5, "dz": 1},
                      "placement": {"origin": ["length / 2", .25, -.5]}}],
        "groups": {"root": "bar.x_min", "tip": "bar.x_max", "middle": "bar.y_min"}}

    def root(axis):
        return lambda points: flexure.displacement(points)[:, axis]

    def tip(mesh, solution):
        return mean_over(mesh, mesh.groups["tip"], solution.displacements[:, 2])

    return Case("bar", model, flexure,
                {"root": {name: root(axis) for axis, name in enumerate("xyz")}, "middle": "y"},
                {"tip": rc.calculix.Traction(flexure.traction)},
                "mean displacement of the end, mm", flexure.timoshenko, tip)


def plate():
    """A quarter of a square about a hole in an infinite plate: its closed stress on the outside."""
    hole = exact.Hole(*_MATERIAL, radius=1, tension=100)
    model = {
        "name": "plate", "unit": "mm", "parameters": {"half": 2, "thickness": .5},
        "features": [{"id": "plate", "nature": "ADDITIVE", "type": "block",
                      "parameters": {"dx": "half", "dy": "half", "dz": "thickness"},
                      "placement": {"origin": ["half / 2", "half / 2", 0]}},
                     {"id": "hole", "nature": "SUBTRACTIVE", "type": "cylinder",
                      "parameters": {"radius": 1, "height": "thickness"}}],
        "groups": {"symmetry_x": "plate.x_min", "symmetry_y": "plate.y_min",
                   "ends": "plate.bottom | plate.top", "outside": "plate.x_max | plate.y_max"}}

    def peak(mesh, solution):
        return mean_at(mesh, solution.stresses[:, 0], 0, 1) / hole.tension

    return Case("plate", model, hole, {"symmetry_x": "x", "symmetry_y": "y", "ends": "z"},
                {"outside": rc.calculix.Traction(hole.traction)},
                "stress at the hole by tension", 3.0, peak)


def tube():
    """A quarter of a thick cylinder under pressure from inside."""
    lame = exact.Tube(*_MATERIAL, inner=1, outer=2, pressure=100)
    model = {
        "name": "tube", "unit": "mm", "parameters": {"inner": 1, "outer": 2, "height": .5},
        "features": [{"id": "tube", "nature": "ADDITIVE", "type": "revolution", "parameters": {
            "profile": [["inner", 0], ["outer", 0], ["outer", "height"], ["inner", "height"]],
            "angle": 90}}],
        "groups": {"symmetry_y": "tube.start", "symmetry_x": "tube.end",
                   "ends": "tube.side1 | tube.side3", "bore": "tube.side4"}}

    def hoop(mesh, solution):
        return mean_at(mesh, solution.stresses[:, 0], 0, 1)

    return Case("tube", model, lame, {"symmetry_x": "x", "symmetry_y": "y", "ends": "z"},
                {"bore": rc.calculix.Pressure(lame.pressure)},
                "hoop stress in the bore, MPa", lame.stress(np.array([[0, 1, 0.]]))[0, 0], hoop)


CASES = {"bar": bar, "plate": plate, "tube": tube}
# Edge lengths by order of the tets. The bar's stop where the six digits of CalculiX's displacements
# are seen in their derivatives.
SIZES = {"bar": {1: (.4, .2, .1, .05), 2: (.4, .25, .177, .125)},
         "plate": {1: (.4, .2, .1, .05), 2: (.5, .25, .125, .0884)},
         "tube": {1: (.4, .2, .1, .05), 2: (.5, .25, .125, .0884)}}


def mean_over(mesh, facets, values):
    """The mean of nodal values over plane facets, by area."""
    nodes = facets.facets if mesh.order == 1 else facets.facets6[:, 3:]
    a, b, c = (mesh.points[facets.facets[:, k]] for k in range(3))
    return np.average(values[nodes].mean(axis=1),
                      weights=np.linalg.norm(np.cross(b - a, c - a), axis=1))


def mean_at(mesh, values, x, y):
    """The mean of nodal values at the nodes over a point of the xy plane."""
    away = np.hypot(mesh.all_points[:, 0] - x, mesh.all_points[:, 1] - y)
    return values[away < 1e-6].mean()


# Errors --------------------------------------------------------------------------------------


def shapes(order):
    """Shape functions at the points of the quadrature (q, i), and their derivatives by the second
    to the fourth barycentric coordinate (q, i, 3)."""
    slopes = np.array([[-1.0, -1, -1], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    if order == 1:
        return _PLACES, np.broadcast_to(slopes, (len(_PLACES), 4, 3))
    first, second = _EDGES.T
    values = np.hstack([_PLACES * (2 * _PLACES - 1),
                        4 * _PLACES[:, first] * _PLACES[:, second]])
    mids = 4 * (_PLACES[:, first, None] * slopes[second] + _PLACES[:, second, None] * slopes[first])
    return values, np.concatenate([(4 * _PLACES - 1)[:, :, None] * slopes, mids], axis=1)


def hooke(gradients, material):
    """(k, 6) stresses xx yy zz xy yz zx of displacements with these gradients (k, 3, 3)."""
    strains = gradients + gradients.transpose(0, 2, 1)
    shear = material.young / (2 * (1 + material.poisson))
    trace = np.trace(strains, axis1=1, axis2=2)
    stresses = shear * (strains + material.poisson / (1 - 2 * material.poisson)
                        * trace[:, None, None] * np.eye(3))
    return stresses[:, [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]


def energy(stresses, material):
    """(k,) twice the strain energy by volume of stresses (k, 6)."""
    squares = (stresses**2) @ [1, 1, 1, 2, 2, 2]
    trace = stresses[:, :3].sum(axis=1)
    return ((1 + material.poisson) * squares - material.poisson * trace**2) / material.young


def errors(mesh, found, solution):
    """Norms of what is wrong, by those of the closed solution, over the mesh's volume.

    displacement: its square. stress: the energy of the stresses that the displacements make in
    each tet. averaged: the same of CalculiX's nodal stresses, interpolated.
    """
    values, derivatives = shapes(mesh.order)
    nodes = mesh.tets if mesh.order == 1 else mesh.tets10
    wrong, whole = np.zeros(3), np.zeros(3)
    for begin in range(0, len(nodes), _CHUNK):
        chunk = nodes[begin:begin + _CHUNK]
        corners = mesh.all_points[chunk]
        jacobians = np.einsum("qiw,kij->kqjw", derivatives, corners)
        weights = (_WEIGHTS * np.linalg.det(jacobians)).ravel() / 6
        slopes = np.einsum("qiw,kqwj->kqij", derivatives, np.linalg.inv(jacobians))
        gradients = np.einsum("kic,kqij->kqcj", found.displacements[chunk], slopes)
        points = np.einsum("qi,kij->kqj", values, corners).reshape(-1, 3)
        moved, averaged = (np.einsum("qi,kij->kqj", values, nodal[chunk]).reshape(len(points), -1)
                           for nodal in (found.displacements, found.stresses))
        move, stress = solution.displacement(points), solution.stress(points)
        made = hooke(gradients.reshape(-1, 3, 3), solution)
        wrong += [weights @ ((moved - move)**2).sum(axis=1),
                  weights @ energy(made - stress, solution),
                  weights @ energy(averaged - stress, solution)]
        strain = weights @ energy(stress, solution)
        whole += [weights @ (move**2).sum(axis=1), strain, strain]
    return tuple(np.sqrt(wrong / whole))


def measure(daemon, case, order, size, solver=""):
    """The Row of a case meshed with edges of one length."""
    begin = time.monotonic()
    part = daemon.mesh(case.model, size=size, order=order, even=True, file=False)
    mesh = part.mesh()
    found = rc.calculix.solve(mesh, STEEL, case.supports, case.loads, solver=solver)
    seconds = time.monotonic() - begin
    for warning in (*part.warnings, *found.warnings):
        print(f"{case.name}, order {order}, size {size}: {warning}", flush=True)
    return Row(size, len(mesh.all_points), len(mesh.tets), errors(mesh, found, case.solution),
               case.figure(mesh, found), seconds)


def fitted(rows, which):
    """The order of convergence: the slope of log error over log size."""
    sizes, wrong = zip(*((row.size, row.errors[which]) for row in rows))
    return np.polyfit(np.log(sizes), np.log(wrong), 1)[0]


# Tables and pictures -------------------------------------------------------------------------


def between(before, row, which):
    """The order between two successive sizes; None of the first one."""
    if before is None:
        return None
    return np.log(row.errors[which] / before.errors[which]) / np.log(row.size / before.size)


def print_table(case, order, rows):
    print(f"\n### {case.name}, tet{4 if order == 1 else 10}\n")
    print("| edge length | nodes | tets | displacement | order | stress | order | averaged | order | "
          f"{case.quantity} | off | seconds |")
    print("|" + "---|" * 12)
    for before, row in zip([None, *rows], rows):
        cells = []
        for which in range(3):
            rate = between(before, row, which)
            cells += [f"{100 * row.errors[which]:.3g} %", "" if rate is None else f"{rate:.2f}"]
        print(f"| {row.size:g} | {row.nodes} | {row.tets} | {' | '.join(cells)} | "
              f"{row.figure:.5g} | {100 * (row.figure / case.value - 1):+.3g} % | "
              f"{row.seconds:.1f} |")
    fits = " | | ".join(f"{fitted(rows, which):.2f}" for which in range(3))
    expected = " | | ".join(map(str, EXPECTED[order]))
    print(f"| *fit* | | | | {fits} | {case.value:.5g} | | |")
    print(f"| *theory* | | | | {expected} | | | |", flush=True)


def guide(axis, results, which):
    """Dotted lines as steep as theory, one for each order, above the errors."""
    for order in sorted({order for _, order in results}):
        rows = [row for (_, of), rows in results.items() if of == order for row in rows]
        steep = EXPECTED[order][which]
        sizes = np.array([min(row.size for row in rows), max(row.size for row in rows)])
        above = 1.5 * max(row.errors[which] / row.size**steep for row in rows)
        axis.loglog(sizes, above * sizes**steep, ":", color="grey")
        axis.annotate(f"{steep}", (sizes.mean(), above * sizes.mean()**steep), ha="right",
                      va="bottom")


def draw(path, results):
    """Errors over edge length, a picture for each measure."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    figure, axes = pyplot.subplots(1, 3, figsize=(13, 4.6))
    colours = dict(zip(CASES, ("tab:blue", "tab:orange", "tab:green")))
    for which, (axis, title) in enumerate(zip(axes, MEASURES)):
        for (name, order), rows in results.items():
            axis.loglog([row.size for row in rows], [row.errors[which] for row in rows],
                        marker="o" if order == 1 else "s", linestyle="-" if order == 1 else "--",
                        color=colours[name], label=f"{name}, tet{4 if order == 1 else 10}")
        guide(axis, results, which)
        axis.set_title(title)
        axis.set_xlabel("edge length, mm")
        axis.grid(True, which="both", alpha=.3)
    axes[0].set_ylabel("error by the solution's norm")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="lower center", ncol=len(results))
    figure.tight_layout(rect=(0, .07, 1, 1))
    figure.savefig(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", default=list(CASES), metavar="CASE",
                        help=f"of {', '.join(CASES)}; default: all")
    parser.add_argument("--orders", type=int, nargs="+", default=[1, 2], choices=(1, 2))
    parser.add_argument("--count", type=int, default=4, help="sizes of each, from the largest")
    parser.add_argument("--address", default="local", help="of a daemon; default: one of its own")
    parser.add_argument("--plot", metavar="FILE", help=".svg or .png; needs matplotlib")
    arguments = parser.parse_intermixed_args()
    results = {}
    with rc.connect(arguments.address) as daemon:
        for name in arguments.cases:
            case = CASES[name]()
            for order in arguments.orders:
                rows = [measure(daemon, case, order, size)
                        for size in SIZES[name][order][:arguments.count]]
                print_table(case, order, rows)
                results[name, order] = rows
    if arguments.plot:
        draw(arguments.plot, results)


if __name__ == "__main__":
    main()
