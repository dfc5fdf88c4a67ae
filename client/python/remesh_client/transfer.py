# SPDX-License-Identifier: Apache-2.0
"""Nodal fields from one mesh to another."""
from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from remesh_client._shapes import curved_weights, tet10_values

if TYPE_CHECKING:
    from scipy.sparse import csr_matrix

    from remesh_client.mesh import Mesh

_BULGE = -1e-9  # least coordinate of a point that counts as inside a curved tet
_FAR = 0.2  # a coordinate below -_FAR: Newton's method left the tet; use the straight coordinates


def transfer(old: Mesh, new: Mesh, *, follow_features: bool = False) -> csr_matrix:
    """The operator that takes nodal values of `old` to `new`: `values_new = operator @ values_old`.

    Shape (len(new.all_points), len(old.all_points)): corner nodes, then mid-nodes. A node of `new`
    takes
    - where a node of `old` stands, to the bit, that node's value;
    - elsewhere within `old` the value interpolated in its tet, linearly, or quadratically where
      `old` is of second order;
    - outside of `old` the value at the closest point of its boundary (clamped: nothing is
      extrapolated).
    So linear fields come over exactly, but for rounding, wherever both meshes are; quadratic ones
    too from a mesh of second order with straight edges.

    follow_features: nodes that `new` copied from `old`, kept or moved, bring their values along
    with the feature that they belong to, wherever it went; the others as above. `new` must be
    made of `old` by one edit, else ValueError.
    """
    from scipy.sparse import csr_matrix
    points = new.all_points
    same = _copied(old, new) if follow_features else _in_place(old, points)
    stays = same >= 0
    rows, columns = [np.flatnonzero(stays)], [same[stays]]
    values = [np.ones(len(rows[0]))]
    others = np.flatnonzero(~stays)
    if len(others):
        nodes, weights = _interpolation(old, points[others])
        rows.append(np.repeat(others, nodes.shape[1]))
        columns.append(nodes.ravel().astype(np.int64))
        values.append(weights.ravel())
    return csr_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
                      shape=(len(points), len(old.all_points)))


def _in_place(old: Mesh, points: npt.NDArray[np.float64]) -> npt.NDArray[np.int64]:
    """The node of `old` that stands at each point, to the bit; -1 for none."""
    from scipy.spatial import cKDTree
    _, nearest = cKDTree(old.all_points).query(points)
    there = (old.all_points[nearest] == points).all(axis=1)
    return np.where(there, nearest, -1)


def _copied(old: Mesh, new: Mesh) -> npt.NDArray[np.int64]:
    """The node of `old` that each node of `new` is; -1 where new."""
    if new.parent != old.revision:
        raise ValueError("follow_features: the new mesh is not made of the old one by one edit "
                         f"(its parent is {new.parent[:12] or 'none'})")
    parents = new.parent_nodes.astype(np.int64)
    if new.order == 1:
        return parents
    mids = new.parent_mids.astype(np.int64)
    if old.order == 1:
        mids = np.full(len(new.mids), -1, np.int64)
    return np.concatenate([parents, np.where(mids >= 0, mids + len(old.points), -1)])


def _interpolation(old: Mesh, points: npt.NDArray[np.float64]
                   ) -> tuple[npt.NDArray[np.int32], npt.NDArray[np.float64]]:
    """Nodes of `old` and their weights for each point: (k, 4), or (k, 10) of second order."""
    from remesh_client._locate import TetLocator, to_simplex
    places = TetLocator(old.points, old.tets).locate(points)
    if old.order == 1:
        return old.tets[places.tets], places.weights
    nodes = old.tets10[places.tets]
    curved = curved_weights(points, old.all_points[nodes], places.weights)
    lost = ~np.isfinite(curved).all(axis=1) | (curved.min(axis=1) < -_FAR)
    curved[lost] = places.weights[lost]
    # Beyond the straight tets, and not in what a curved edge adds to them either.
    beyond = lost | (places.outside & (curved.min(axis=1) < _BULGE))
    curved[beyond] = to_simplex(curved[beyond])
    return nodes, tet10_values(curved)
