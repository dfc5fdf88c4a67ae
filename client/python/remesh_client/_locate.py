# SPDX-License-Identifier: Apache-2.0
"""Where points lie in a tetrahedral mesh: the tet, and barycentric coordinates in it."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
_FACES = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])  # opposite each corner
_INSIDE = -1e-10  # least barycentric coordinate that counts as inside
_STEPS = 100  # of a walk
_CANDIDATES = 48  # tets or facets looked at where a walk has left the mesh


class Places(NamedTuple):
    """For each point the tet, (k,), and barycentric coordinates in its corners, (k, 4).

    outside: (k,) where no tet contains the point: the coordinates are those of the closest point
    of the boundary, in the tet behind it.
    """

    tets: Ints
    weights: Floats
    outside: npt.NDArray[np.bool_]


class TetLocator:
    """Finds points in a mesh of straight tets: corner nodes (n, 3), tets (m, 4)."""

    def __init__(self, points: Floats, tets: npt.NDArray[np.int32]) -> None:
        self._points = points
        self._tets = tets.astype(np.int64)
        corners = points[self._tets]
        self._origin = corners[:, 0]
        self._inverse = np.linalg.inv((corners[:, 1:] - corners[:, :1]).transpose(0, 2, 1))
        self._centres = cKDTree(corners.mean(axis=1))
        self._neighbours = _neighbours(self._tets, len(points))
        tet, face = np.nonzero(self._neighbours < 0)
        self._facet_tets = tet
        self._facets = points[np.take_along_axis(self._tets[tet], _FACES[face], axis=1)]
        self._facet_centres = cKDTree(self._facets.mean(axis=1))

    def locate(self, points: Floats) -> Places:
        """points: (k, 3)."""
        tets = np.asarray(self._centres.query(points)[1], np.int64)
        left = self._walk(points, tets)
        self._search(points, tets, left)
        weights = self.weights(points, tets)
        outside = np.zeros(len(points), np.bool_)
        outside[left] = weights[left].min(axis=1) < _INSIDE
        lost = np.flatnonzero(outside)
        if len(lost):
            tets[lost], closest = self._closest(points[lost])
            weights[lost] = to_simplex(self.weights(closest, tets[lost]))
        return Places(tets, weights, outside)

    def weights(self, points: Floats, tets: Ints) -> Floats:
        """(k, 4) barycentric coordinates of each point in its tet."""
        others = np.einsum("kij,kj->ki", self._inverse[tets], points - self._origin[tets])
        return np.column_stack([1 - others.sum(axis=1), others])

    def _walk(self, points: Floats, tets: Ints) -> Ints:
        """Steps from tet to tet towards each point; returns those that it did not reach."""
        going, left = np.arange(len(points)), []
        for _ in range(_STEPS):
            weights = self.weights(points[going], tets[going])
            worst = weights.argmin(axis=1)
            on = weights[np.arange(len(going)), worst] < _INSIDE
            going, worst = going[on], worst[on]
            if not len(going):
                break
            following = self._neighbours[tets[going], worst]
            left.append(going[following < 0])
            going, following = going[following >= 0], following[following >= 0]
            tets[going] = following
        missed: Ints = np.concatenate([*left, going]).astype(np.int64)
        return missed

    def _search(self, points: Floats, tets: Ints, left: Ints) -> None:
        """Among the tets whose centres are near: a walk cannot pass a hole."""
        if not len(left):
            return
        count = min(_CANDIDATES, len(self._tets))
        near = self._centres.query(points[left], k=count)[1].reshape(len(left), count)
        for k in range(count):
            candidates = near[:, k].astype(np.int64)
            inside = self.weights(points[left], candidates).min(axis=1) >= _INSIDE
            tets[left[inside]] = candidates[inside]
            left, near = left[~inside], near[~inside]

    def _closest(self, points: Floats) -> tuple[Ints, Floats]:
        """The tet behind the boundary facet next to each point, and the facet's closest point."""
        count = min(_CANDIDATES, len(self._facets))
        near = self._facet_centres.query(points, k=count)[1].reshape(len(points), count)
        best = np.full(len(points), np.inf)
        facet = np.zeros(len(points), np.int64)
        closest = np.zeros_like(points)
        for column in near.T:
            found = closest_of_triangle(points, self._facets[column])
            distance = np.linalg.norm(found - points, axis=1)
            nearer = distance < best
            best[nearer], facet[nearer] = distance[nearer], column[nearer]
            closest[nearer] = found[nearer]
        return self._facet_tets[facet].astype(np.int64), closest


def _neighbours(tets: Ints, nodes: int) -> Ints:
    """(m, 4) the tet across the facet opposite each corner; -1 on the boundary."""
    faces = np.sort(tets[:, _FACES].reshape(-1, 3), axis=1)
    pair = faces[:, 0] * nodes + faces[:, 1]
    order = np.lexsort((faces[:, 2], pair))
    same = (pair[order[1:]] == pair[order[:-1]]) & (faces[order[1:], 2] == faces[order[:-1], 2])
    first, second = order[:-1][same], order[1:][same]
    neighbours = np.full(len(faces), -1, np.int64)
    neighbours[first], neighbours[second] = second // 4, first // 4
    return neighbours.reshape(-1, 4)


def to_simplex(weights: Floats) -> Floats:
    """Coordinates without what is negative, of sum 1."""
    weights = np.maximum(weights, 0)
    clamped: Floats = weights / weights.sum(axis=1, keepdims=True)
    return clamped


def closest_of_triangle(points: Floats, triangles: Floats) -> Floats:
    """(k, 3) the closest point of each triangle, (k, 3, 3), to its point."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    normal = np.cross(b - a, c - a)
    square = np.maximum((normal * normal).sum(axis=1), np.finfo(float).tiny)
    best: Floats = points - (((points - a) * normal).sum(axis=1) / square)[:, None] * normal
    inside = np.ones(len(points), np.bool_)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= (np.cross(q - p, best - p) * normal).sum(axis=1) >= 0
    distance = np.where(inside, 0.0, np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        along = q - p
        share = ((points - p) * along).sum(axis=1) / np.maximum((along * along).sum(axis=1),
                                                                np.finfo(float).tiny)
        on_edge = p + np.clip(share, 0, 1)[:, None] * along
        far = ((on_edge - points) ** 2).sum(axis=1)
        nearer = far < distance
        best[nearer], distance[nearer] = on_edge[nearer], far[nearer]
    return best
