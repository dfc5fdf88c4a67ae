# SPDX-License-Identifier: Apache-2.0
"""Quadratic shape functions of tets and triangles, in VTK's order of nodes."""
from __future__ import annotations

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
TET_EDGES = np.array([[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]])
_NEWTON_STEPS = 12
_CONVERGED = 1e-13  # change of a barycentric coordinate


def tet10_values(weights: Floats) -> Floats:
    """(k, 10) shape functions at barycentric coordinates (k, 4)."""
    corners = weights * (2 * weights - 1)
    mids = 4 * weights[:, TET_EDGES[:, 0]] * weights[:, TET_EDGES[:, 1]]
    return np.hstack([corners, mids])


def tet10_derivatives(weights: Floats) -> Floats:
    """(k, 10, 4) derivatives by each barycentric coordinate, as if they were independent."""
    out = np.zeros((len(weights), 10, 4))
    for corner in range(4):
        out[:, corner, corner] = 4 * weights[:, corner] - 1
    for mid, (a, b) in enumerate(TET_EDGES):
        out[:, 4 + mid, a] = 4 * weights[:, b]
        out[:, 4 + mid, b] = 4 * weights[:, a]
    return out


def curved_weights(points: Floats, nodes: Floats, start: Floats) -> Floats:
    """Barycentric coordinates (k, 4) at which tets of second order, nodes (k, 10, 3), pass
    through points (k, 3), by Newton's method from `start`, those in the straight tets."""
    weights = start.copy()
    for _ in range(_NEWTON_STEPS):
        error = points - np.einsum("ki,kij->kj", tet10_values(weights), nodes)
        by_weight = np.einsum("kiw,kij->kjw", tet10_derivatives(weights), nodes)
        jacobian = by_weight[:, :, 1:] - by_weight[:, :, :1]
        step = np.linalg.solve(jacobian, error[:, :, None])[:, :, 0]
        weights[:, 1:] += step
        weights[:, 0] = 1 - weights[:, 1:].sum(axis=1)
        if np.abs(step).max(initial=0.0) < _CONVERGED:
            break
    return weights
