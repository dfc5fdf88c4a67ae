# SPDX-License-Identifier: Apache-2.0
"""Derivatives of functions of a mesh by its nodes, the connectivity held.

With `Part.gradient` they become derivatives by the model's parameters:

    compliance, seed = rc.adjoint.compliance(mesh, solution, material, loads)
    print(part.gradient(seed)["radius"])

Linear elasticity is its own adjoint, so that no further solution is needed for compliance.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Mapping

import numpy as np
import numpy.typing as npt

from remesh_client import _loads
from remesh_client._shapes import tet10_derivatives
from remesh_client.calculix import Elastic, Load, Pressure, Solution, Traction, named
from remesh_client.mesh import Mesh

Floats = npt.NDArray[np.float64]

# Of a tet, exact to degree 2: the rule of ccx's C3D10.
_FAR, _NEAR = 0.5854101966249685, 0.1381966011250105
_POINTS = np.full((4, 4), _NEAR) + (_FAR - _NEAR) * np.eye(4)
_CHUNK = 20000  # tets at a time


def volume(mesh: Mesh) -> tuple[float, Floats]:
    """Volume of a mesh, and its derivative by `mesh.all_points`, (n, 3)."""
    total, gradient = 0.0, np.zeros_like(mesh.all_points)
    for nodes in _chunks(mesh):
        slopes, weights = _slopes(mesh, nodes)
        total += float(weights.sum())
        np.add.at(gradient, nodes, np.einsum("kq,kqia->kia", weights, slopes))
    return total, gradient


def strain_energy(mesh: Mesh, displacements: Floats, material: Elastic) -> tuple[float, Floats]:
    """Strain energy of displacements (n, 3) of `mesh.all_points`, and its derivative by these
    points, (n, 3), with the displacements held fixed.

    By nodes i, with the strain energy's density W, stress s and gradient H of the displacements:
    the integral of W dN_i/dx_b - s_ca H_cb dN_i/dx_a (Eshelby's tensor).
    """
    shear = material.young / (2 * (1 + material.poisson))
    bulk = 2 * shear * material.poisson / (1 - 2 * material.poisson)
    energy, gradient = 0.0, np.zeros_like(mesh.all_points)
    for nodes in _chunks(mesh):
        slopes, weights = _slopes(mesh, nodes)
        h = np.einsum("kic,kqia->kqca", displacements[nodes], slopes)
        strain = 0.5 * (h + h.transpose(0, 1, 3, 2))
        stress = 2 * shear * strain
        trace = bulk * np.einsum("kqaa->kq", strain)
        for a in range(3):
            stress[:, :, a, a] += trace
        density = 0.5 * np.einsum("kqab,kqab->kq", stress, strain)
        energy += float((weights * density).sum())
        tensor = -np.einsum("kqca,kqcb->kqab", stress, h)
        for a in range(3):
            tensor[:, :, a, a] += density
        np.add.at(gradient, nodes, np.einsum("kq,kqab,kqia->kib", weights, tensor, slopes))
    return energy, gradient


def compliance(mesh: Mesh, solution: Solution, material: Elastic,
               loads: Mapping[str, Load]) -> tuple[float, Floats]:
    """Work of the loads on the displacements that they cause, and its derivative by the nodes.

    solution: of `calculix.solve` with the same material and loads, supports held at nought. A total
    force is spread by area, so it depends on the nodes too; what scales a Pressure to the exact
    area of its group is taken as fixed. Raises KeyError for a name that is not on the mesh,
    ValueError for a Traction, whose field may be any function.
    """
    _, held = strain_energy(mesh, solution.displacements, material)
    gradient = -2 * held
    for name, load in loads.items():
        gradient += 2 * _work_gradient(mesh, name, load, solution.displacements)
    return solution.work, gradient


@dataclass(frozen=True)
class StressNorm:
    """A smooth maximum of the stress with its partial derivatives."""

    value: float
    by_displacement: Floats  # (n, 3)
    by_node: Floats  # (n, 3), while displacements and weights stay
    by_weight: Floats  # (tets,)


def stress_norm(mesh: Mesh, displacements: Floats, material: Elastic, power: float = 12,
                weights: npt.ArrayLike | None = None) -> StressNorm:
    """A smooth maximum of the von Mises stress: (integral of w s^p / integral of w)^(1/p).

    displacements: (n, 3) of `mesh.all_points`. weights: w by tet, default 1. `sensitivity` makes the
    whole derivative of the partial ones.
    """
    shear = material.young / (2 * (1 + material.poisson))
    by_tet = np.ones(len(mesh.tets)) if weights is None else np.asarray(weights, float)
    sums, whole = 0.0, 0.0
    by_u, by_x = np.zeros_like(mesh.all_points), np.zeros_like(mesh.all_points)
    whole_by_x = np.zeros_like(mesh.all_points)
    of_tets = []  # sum and volume
    scale = _largest_von_mises(mesh, displacements, shear)  # else powers leave the range of numbers
    first = 0
    for nodes in _chunks(mesh):
        slopes, volumes = _slopes(mesh, nodes)
        plain = volumes
        volumes = volumes * by_tet[first:first + len(nodes), None]
        first += len(nodes)
        h = np.einsum("kic,kqia->kqca", displacements[nodes], slopes)
        deviator, von_mises = _von_mises(h, shear)
        density = (von_mises / scale) ** power
        # d(density)/dH, from d(von Mises)/d(strain) = 3 shear deviator / von Mises.
        rate = power * density / np.maximum(von_mises, 1e-300) ** 2 * 3 * shear
        by_h = rate[:, :, None, None] * deviator
        of_tets.append(np.stack([(plain * density).sum(axis=1), plain.sum(axis=1)]))
        sums += float((volumes * density).sum())
        whole += float(volumes.sum())
        np.add.at(by_u, nodes, np.einsum("kq,kqca,kqia->kic", volumes, by_h, slopes))
        tensor = -np.einsum("kqca,kqcb->kqab", by_h, h)
        for a in range(3):
            tensor[:, :, a, a] += density
        np.add.at(by_x, nodes, np.einsum("kq,kqab,kqia->kib", volumes, tensor, slopes))
        np.add.at(whole_by_x, nodes, np.einsum("kq,kqia->kia", volumes, slopes))
    mean = sums / whole
    value = scale * mean ** (1 / power)
    factor = value / (power * sums)
    tet_sums, tet_volumes = np.concatenate(of_tets, axis=1)
    return StressNorm(value, factor * by_u, factor * (by_x - mean * whole_by_x),
                      factor * (tet_sums - mean * tet_volumes))


def sensitivity(mesh: Mesh, solution: Solution, adjoint: Solution, material: Elastic,
                loads: Mapping[str, Load], by_node: Floats) -> Floats:
    """d(J)/d(node), (n, 3), of a function J of displacements and nodes.

    solution: as of `compliance`. adjoint: `calculix.solve` of the same mesh and supports, without
    loads, with `forces` d(J)/d(displacements). by_node: d(J)/d(node) while the displacements stay.
    Raises as `compliance`.
    """
    size = np.abs(adjoint.displacements).max()
    if size == 0:
        return by_node
    scale = np.abs(solution.displacements).max() / size  # both of one size: little is lost
    other = scale * adjoint.displacements
    _, plus = strain_energy(mesh, solution.displacements + other, material)
    _, minus = strain_energy(mesh, solution.displacements - other, material)
    out: Floats = by_node - (plus - minus) / (2 * scale)
    for name, load in loads.items():
        out += _work_gradient(mesh, name, load, adjoint.displacements)
    return out


def _work_gradient(mesh: Mesh, name: str, load: Load, displacements: Floats) -> Floats:
    """d(work of a load)/d(node) while the displacements stay."""
    facets = named(mesh, name)
    if isinstance(load, Traction):
        raise ValueError(f"the traction on {name} has no derivative here")
    if isinstance(load, Pressure):
        area = mesh.exact_areas.get(facets.name) if facets.name in mesh.groups else None
        return _loads.pressure_work_gradient(mesh, facets, load.value, area, displacements)
    return _loads.force_work_gradient(mesh, facets, np.asarray(load, float), displacements)


def _von_mises(h: Floats, shear: float) -> tuple[Floats, Floats]:
    """Deviator of the stress and von Mises stress of gradients of displacements (k, q, 3, 3)."""
    deviator = shear * (h + h.transpose(0, 1, 3, 2))
    mean = np.einsum("kqaa->kq", deviator) / 3
    for a in range(3):
        deviator[:, :, a, a] -= mean
    return deviator, np.sqrt(1.5 * np.einsum("kqab,kqab->kq", deviator, deviator))


def _largest_von_mises(mesh: Mesh, displacements: Floats, shear: float) -> float:
    largest = 0.0
    for nodes in _chunks(mesh):
        h = np.einsum("kic,kqia->kqca", displacements[nodes], _slopes(mesh, nodes)[0])
        largest = max(largest, float(_von_mises(h, shear)[1].max(initial=0.0)))
    return largest or 1.0


def _chunks(mesh: Mesh) -> list[npt.NDArray[np.int32]]:
    nodes = mesh.tets if mesh.order == 1 else mesh.tets10
    return [nodes[k:k + _CHUNK] for k in range(0, len(nodes), _CHUNK)]


def _slopes(mesh: Mesh, nodes: npt.NDArray[np.int32]) -> tuple[Floats, Floats]:
    """Of each tet at each point of the quadrature dN/dx, (k, q, i, 3), and its share of the volume,
    (k, q)."""
    if mesh.order == 1:
        by_weight = np.eye(4)[None]
        share = 1.0
    else:
        by_weight = tet10_derivatives(_POINTS)
        share = 0.25
    local = by_weight[:, :, 1:] - by_weight[:, :, :1]
    jacobian = np.einsum("kia,qij->kqaj", mesh.all_points[nodes], local)
    slopes = np.einsum("qij,kqja->kqia", local, np.linalg.inv(jacobian))
    return slopes, share / 6 * np.linalg.det(jacobian)
