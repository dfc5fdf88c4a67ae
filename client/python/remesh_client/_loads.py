# SPDX-License-Identifier: Apache-2.0
"""Nodal forces that do the work of a load on facets: consistent loads of T3 and T6."""
from __future__ import annotations

from typing import TYPE_CHECKING, Callable

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from remesh_client.mesh import Mesh, NodeSet

Floats = npt.NDArray[np.float64]
Field = Callable[[Floats, Floats], Floats]  # of points and outward normals, (k, 3) each

# Quadrature of a triangle, exact to degree 5 (Dunavant 1985): barycentric coordinates, weights.
_A, _B = 0.059715871789770, 0.470142064105115
_C, _D = 0.797426985353087, 0.101286507323456
_POINTS = np.array([[1 / 3, 1 / 3, 1 / 3], [_A, _B, _B], [_B, _A, _B], [_B, _B, _A],
                    [_C, _D, _D], [_D, _C, _D], [_D, _D, _C]])
_WEIGHTS = np.array([0.225] + 3 * [0.132394152788506] + 3 * [0.125939180544827])


def force(mesh: Mesh, facets: NodeSet, total: Floats) -> Floats:
    """(len(mesh.all_points), 3) nodal forces of a total force (3,), spread evenly by area.

    Raises ValueError where there are no facets.
    """
    nodes, values, area_vectors = _surface(mesh, facets)
    shares = np.einsum("q,qi,kq->ki", _WEIGHTS, values, np.linalg.norm(area_vectors, axis=2))
    shares /= shares.sum()
    return _sum(mesh, nodes, shares[:, :, None] * np.asarray(total, float))


def pressure(mesh: Mesh, facets: NodeSet, value: float, area: float | None = None) -> Floats:
    """Likewise of a pressure, force by area, that acts against the outward normal.

    area: exact area of what the facets stand for; the forces are scaled by it beside the facets'
    own, so that the load does not jump with the mesh.
    """
    nodes, values, area_vectors = _surface(mesh, facets)
    if area is not None:
        value *= area / float((_WEIGHTS * np.linalg.norm(area_vectors, axis=2)).sum())
    return _sum(mesh, nodes, -value * np.einsum("q,qi,kqc->kic", _WEIGHTS, values, area_vectors))


def traction(mesh: Mesh, facets: NodeSet, field: Field) -> Floats:
    """Likewise of a force by area that differs from point to point: field(points (k, 3), outward
    unit normals (k, 3)) gives it, (k, 3). Exact on plane facets where it is a polynomial of degree
    3 or less (4 in meshes of first order). Raises ValueError for another shape and for numbers
    that are not finite."""
    nodes, values, area_vectors = _surface(mesh, facets)
    places = np.einsum("qi,kic->kqc", values, mesh.all_points[nodes]).reshape(-1, 3)
    areas = np.linalg.norm(area_vectors, axis=2)
    forces = np.asarray(field(places, (area_vectors / areas[:, :, None]).reshape(-1, 3)), float)
    if forces.shape != places.shape or not np.isfinite(forces).all():
        raise ValueError(f"the traction on {facets.name} must be finite and of the shape "
                         f"{places.shape}; it has {forces.shape}")
    by_area = areas[:, :, None] * forces.reshape(area_vectors.shape)
    return _sum(mesh, nodes, np.einsum("q,qi,kqc->kic", _WEIGHTS, values, by_area))


def force_work_gradient(mesh: Mesh, facets: NodeSet, total: Floats, u: Floats) -> Floats:
    """d(work of `force`)/d(node), (n, 3), where the nodes' displacements u (n, 3) stay."""
    nodes, values, area_vectors = _surface(mesh, facets)
    areas = np.linalg.norm(area_vectors, axis=2)
    along = np.einsum("qi,kic,c->kq", values, u[nodes], total)  # of the force, by point
    whole = float((_WEIGHTS * areas).sum())
    mean = float((_WEIGHTS * areas * along).sum()) / whole
    by_area = _WEIGHTS * (along - mean) / whole
    return _sum(mesh, nodes, _area_gradient(
        mesh, nodes, by_area[:, :, None] * area_vectors / areas[:, :, None]))


def pressure_work_gradient(mesh: Mesh, facets: NodeSet, value: float, area: float | None,
                           u: Floats) -> Floats:
    """Likewise of `pressure`; its scale to the exact area stays."""
    nodes, values, area_vectors = _surface(mesh, facets)
    if area is not None:
        value *= area / float((_WEIGHTS * np.linalg.norm(area_vectors, axis=2)).sum())
    moved = np.einsum("qi,kic->kqc", values, u[nodes])
    return _sum(mesh, nodes, _area_gradient(mesh, nodes, -value * _WEIGHTS[:, None] * moved))


def _area_gradient(mesh: Mesh, nodes: npt.NDArray[np.int32], by_vector: Floats) -> Floats:
    """(k, i, 3): from d(work)/d(area vector), (k, q, 3), to d(work)/d(node)."""
    _, derivatives = _shapes6() if mesh.order == 2 else _shapes3()
    along = np.einsum("qiw,kic->kqwc", derivatives, mesh.all_points[nodes])
    first = 0.5 * np.cross(along[:, :, 1], by_vector)  # the area vector is half the cross product
    second = 0.5 * np.cross(by_vector, along[:, :, 0])
    out: Floats = (np.einsum("qi,kqc->kic", derivatives[:, :, 0], first)
                   + np.einsum("qi,kqc->kic", derivatives[:, :, 1], second))
    return out


def _surface(mesh: Mesh, facets: NodeSet) -> tuple[npt.NDArray[np.int32], Floats, Floats]:
    """Nodes of each facet (k, i), shape functions (q, i) and, at each point of the quadrature,
    the outward normal times the area (k, q, 3)."""
    if not len(facets.facet_indices):
        raise ValueError(f"{facets.name} has no facets for a load to act on")
    second = mesh.order == 2
    nodes = facets.facets6 if second else facets.facets
    values, derivatives = _shapes6() if second else _shapes3()
    places = mesh.all_points[nodes]
    along = np.einsum("qiw,kic->kqwc", derivatives, places)
    return nodes, values, 0.5 * np.cross(along[:, :, 0], along[:, :, 1])


def _shapes3() -> tuple[Floats, Floats]:
    """Values (q, 3) and derivatives (q, 3, 2) by the second and third coordinate."""
    slopes = np.array([[-1.0, -1], [1, 0], [0, 1]])
    return _POINTS, np.broadcast_to(slopes, (len(_POINTS), 3, 2))


def _shapes6() -> tuple[Floats, Floats]:
    """The same of a triangle with mid-nodes of the edges 01 12 20."""
    a, b, c = _POINTS.T
    values = np.column_stack([a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b,
                              4 * b * c, 4 * c * a])
    zero = np.zeros_like(a)
    by_b = np.column_stack([1 - 4 * a, 4 * b - 1, zero, 4 * (a - b), 4 * c, -4 * c])
    by_c = np.column_stack([1 - 4 * a, zero, 4 * c - 1, -4 * b, 4 * b, 4 * (a - c)])
    return values, np.stack([by_b, by_c], axis=2)


def _sum(mesh: Mesh, nodes: npt.NDArray[np.int32], forces: Floats) -> Floats:
    out = np.zeros((len(mesh.all_points), 3))
    np.add.at(out, nodes, forces)
    return out
