# SPDX-License-Identifier: Apache-2.0
"""Linear elasticity by CalculiX (`ccx`, Debian: calculix-ccx).

    from remesh_client import calculix
    solution = calculix.solve(mesh, calculix.Elastic(210000, 0.3), supports={"plate.bottom": "xyz"},
                              loads={"pin1.top": (1000, 0, 0), "hole.wall": calculix.Pressure(5)})
    solution.displacements, solution.von_mises

Names are those of groups of the model, or of its faces. Units are those of the mesh: with mm and N,
moduli, pressures and stresses are in MPa.
"""
from __future__ import annotations

import os
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Callable, Mapping, Sequence, Union

import numpy as np

from remesh_client import _loads
from remesh_client._frd import read_frd
from remesh_client._loads import Floats
from remesh_client.mesh import Mesh, NodeSet

_AXES = {"x": 1, "y": 2, "z": 3}
_JOB = "job"


@dataclass(frozen=True)
class Elastic:
    """An isotropic material: Young's modulus, force by area, and Poisson's ratio."""

    young: float
    poisson: float


@dataclass(frozen=True)
class Pressure:
    """Force by area against the outward normal."""

    value: float


@dataclass(frozen=True)
class Traction:
    """Force by area that differs from point to point: field(points (k, 3), outward unit normals
    (k, 3)) gives it, (k, 3)."""

    field: Callable[[Floats, Floats], Floats]


# "xyz": held; {"x": 0.1}: moved by so much; {"x": f}: by f(points (k, 3)), (k,)
Move = Union[float, Callable[[Floats], Floats]]
Support = Union[str, Mapping[str, Move]]
Load = Union[Sequence[float], Pressure, Traction]  # a total force x y z, or by area


class CalculixError(RuntimeError):
    """`ccx` failed; the message is what it said, `output` all of it."""

    def __init__(self, message: str, output: str = "") -> None:
        super().__init__(message)
        self.output = output


@dataclass(frozen=True)
class Solution:
    """Of one load case; N is len(mesh.all_points).

    displacements: (N, 3). stresses: (N, 6) xx yy zz xy yz zx, averaged at nodes by ccx, tension
    positive. forces: (N, 3) the nodal forces applied. Numbers have the six digits of ccx's file.
    warnings: what ccx warned of.
    """

    displacements: Floats
    stresses: Floats
    forces: Floats
    warnings: tuple[str, ...] = ()

    @cached_property
    def von_mises(self) -> Floats:
        """(N,) von Mises stress."""
        xx, yy, zz, xy, yz, zx = self.stresses.T
        shear = xy**2 + yz**2 + zx**2
        squares = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
        stress: Floats = np.sqrt(0.5 * squares + 3 * shear)
        return stress

    @property
    def work(self) -> float:
        """Twice the strain energy where supports do not move: forces times displacements."""
        return float((self.forces * self.displacements).sum())


def solve(mesh: Mesh, material: Elastic, supports: Mapping[str, Support],
          loads: Mapping[str, Load], *, forces: Floats | None = None, limit: float = 600,
          threads: int = 1,
          program: os.PathLike[str] | str = "ccx", solver: str = "",
          folder: os.PathLike[str] | str | None = None) -> Solution:
    """Displacements and stresses of a mesh of either order, C3D4 or C3D10.

    supports: by name of a group or face: "xyz", the directions in which its nodes are held, or a
    mapping of directions to prescribed displacements, each a number or a function of the nodes'
    points (k, 3). loads: by name of a group or face: a total force, spread evenly by area; a
    Pressure, which on a group of the model is scaled by the group's exact area divided by that of
    its facets; or a Traction. Each becomes nodal forces that are consistent with the elements.
    forces: additional nodal forces, (n, 3), by node of `mesh.all_points`. limit: s that ccx may
    take. threads: of ccx. program: ccx, by name or path. solver: by its name in ccx; default: ccx's
    own choice, which is direct; "ITERATIVE CHOLESKY" takes a fraction of the time on large meshes
    of second order, but its results were off by 0.6 % on some parts, because it stops early.
    folder: where ccx's files are kept; default: a temporary folder.

    Raises CalculixError, with ccx's message, where it is missing, fails or takes too long; KeyError
    for a name that is not on the mesh; ValueError for an empty set and bad values.
    """
    total = np.zeros((len(mesh.all_points), 3)) if forces is None else np.array(forces, float)
    if total.shape != mesh.all_points.shape:
        raise ValueError(f"forces have the shape {total.shape}, not {mesh.all_points.shape}")
    for name, load in loads.items():
        total += _nodal_forces(mesh, named(mesh, name), load)
    deck = _deck(mesh, material, supports, total, solver)
    if folder is not None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        return _run(mesh, deck, total, Path(folder), limit, threads, program)
    with tempfile.TemporaryDirectory(prefix="remesh-ccx-") as temporary:
        return _run(mesh, deck, total, Path(temporary), limit, threads, program)


def write_deck(path: os.PathLike[str] | str, mesh: Mesh, material: Elastic,
               supports: Mapping[str, Support], loads: Mapping[str, Load]) -> Path:
    """Writes the input file of `solve`; returns its path. Raises as `solve` does."""
    forces = np.zeros((len(mesh.all_points), 3))
    for name, load in loads.items():
        forces += _nodal_forces(mesh, named(mesh, name), load)
    target = Path(path)
    target.write_text(_deck(mesh, material, supports, forces), encoding="ascii")
    return target


def named(mesh: Mesh, name: str) -> NodeSet:
    """The group, or else the face, of a mesh. Raises KeyError."""
    if name in mesh.groups:
        return mesh.groups[name]
    if name in mesh.faces:
        return mesh.faces[name]
    known = ", ".join([*mesh.groups, *mesh.faces])
    raise KeyError(f"no group or face {name!r} on this mesh; there are: {known}")


def _nodal_forces(mesh: Mesh, facets: NodeSet, load: Load) -> Floats:
    if isinstance(load, Pressure):
        area = mesh.exact_areas.get(facets.name) if facets.name in mesh.groups else None
        return _loads.pressure(mesh, facets, load.value, area)
    if isinstance(load, Traction):
        return _loads.traction(mesh, facets, load.field)
    total = np.asarray(load, float)
    if total.shape != (3,) or not np.isfinite(total).all():
        raise ValueError(f"the load on {facets.name} is three finite numbers, a Pressure or a "
                         f"Traction, not {load!r}")
    return _loads.force(mesh, facets, total)


def _deck(mesh: Mesh, material: Elastic, supports: Mapping[str, Support],
          forces: Floats, solver: str = "") -> str:
    if not (material.young > 0 and -1 < material.poisson < 0.5):
        raise ValueError(f"{material}: young must be positive, poisson between -1 and 0.5")
    elements, kind = (mesh.tets, "C3D4") if mesh.order == 1 else (mesh.tets10, "C3D10")
    # ccx reads 20 characters of a number.
    lines = ["*NODE, NSET=all"]
    lines += [f"{k},{x:.13e},{y:.13e},{z:.13e}"
              for k, (x, y, z) in enumerate(mesh.all_points.tolist(), 1)]
    lines += [f"*ELEMENT, TYPE={kind}, ELSET=solid"]
    lines += [f"{k},{','.join(map(str, nodes))}"
              for k, nodes in enumerate((elements + 1).tolist(), 1)]
    lines += ["*MATERIAL, NAME=material", "*ELASTIC", f"{material.young:.12g},"
              f"{material.poisson:.12g}", "*SOLID SECTION, ELSET=solid, MATERIAL=material",
              "*STEP", f"*STATIC, SOLVER={solver}" if solver else "*STATIC",
              "*BOUNDARY", *_held(mesh, supports), "*CLOAD"]
    for node in np.flatnonzero(forces.any(axis=1)).tolist():
        lines += [f"{node + 1},{axis + 1},{value:.13e}"
                  for axis, value in enumerate(forces[node].tolist()) if value]
    return "\n".join([*lines, "*NODE FILE", "U", "*EL FILE", "S", "*END STEP", ""])


def _held(mesh: Mesh, supports: Mapping[str, Support]) -> list[str]:
    lines = []
    for name, support in supports.items():
        nodes = named(mesh, name).all_nodes
        moves: Mapping[str, Move] = (dict.fromkeys(support, 0.0) if isinstance(support, str)
                                     else support)
        if not len(nodes) or not moves or not set(moves) <= set(_AXES):
            raise ValueError(f"the support {name!r}: {support!r} on {len(nodes)} nodes; give "
                             "directions out of 'xyz' and a face or group with nodes")
        for axis, move in moves.items():
            values = _moved(name, move, mesh.all_points[nodes])
            lines += [f"{node},{_AXES[axis]},{_AXES[axis]},{value:.13e}"
                      for node, value in zip((nodes + 1).tolist(), values.tolist())]
    if not lines:
        raise ValueError("without a support nothing keeps the part where it is")
    return lines


def _moved(name: str, move: Move, points: Floats) -> Floats:
    """(k,) by how much each of the points is moved."""
    if not callable(move):
        return np.full(len(points), float(move))
    values = np.asarray(move(points), float)
    if values.shape != (len(points),) or not np.isfinite(values).all():
        raise ValueError(f"the support {name!r} must be finite and of the shape {(len(points),)}; "
                         f"it has {values.shape}")
    return values


def _run(mesh: Mesh, deck: str, forces: Floats, folder: Path, limit: float, threads: int,
         program: os.PathLike[str] | str) -> Solution:
    (folder / f"{_JOB}.inp").write_text(deck, encoding="ascii")
    environment = {**os.environ, "OMP_NUM_THREADS": str(threads)}
    try:
        run = subprocess.run([program, _JOB], cwd=folder, env=environment, timeout=limit,
                             stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
    except FileNotFoundError:
        raise CalculixError(f"there is no {os.fspath(program)}; Debian has it as calculix-ccx"
                            ) from None
    except subprocess.TimeoutExpired:
        raise CalculixError(f"ccx took longer than {limit:g} s") from None
    results = folder / f"{_JOB}.frd"
    if run.returncode != 0 or "*ERROR" in run.stdout or not results.exists():
        raise CalculixError(_said(run.stdout, run.returncode), run.stdout)
    fields = read_frd(results, len(mesh.all_points))
    if not {"DISP", "STRESS"} <= fields.keys():
        raise CalculixError(_said(run.stdout, run.returncode), run.stdout)
    if not all(np.isfinite(values).all() for values in fields.values()):
        raise CalculixError("ccx's result has numbers that are not finite: do the supports keep "
                            "the part where it is?", run.stdout)
    return Solution(fields["DISP"][:, :3], fields["STRESS"], forces,
                    tuple(_lines_with(run.stdout, "*WARNING")))


def _said(output: str, returncode: int) -> str:
    """Its errors, else its last line."""
    found = _lines_with(output, "*ERROR")
    last = output.strip().splitlines()[-1:] or ["no output"]
    return "ccx: " + ("; ".join(found[:3]) or last[0].strip()) + f" (exit code {returncode})"


def _lines_with(output: str, mark: str) -> list[str]:
    """The lines that have the mark, each with the one after it."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    return [" ".join(lines[k:k + 2]) for k, line in enumerate(lines) if mark in line]
