# SPDX-License-Identifier: Apache-2.0
"""What the bracket is judged by, and the derivatives of it by the nodes of its mesh."""
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

import remesh_client as rc

STEEL = rc.calculix.Elastic(210000, .3)  # MPa
DENSITY = 7.85e-6  # kg/mm^3
SUPPORTS = {"supports": "xyz"}
LOADS = {"load": (3000, 0, -2000)}  # N, on the pipe's top
FORCE = np.linalg.norm(LOADS["load"])
POWER = 12  # of the stress measure
NEAR, FAR = 6.0, 12.0  # mm from what is left out: no weight, full weight


@dataclass
class Measures:
    """Mass, kg; displacement of the load along itself, mm; a smooth maximum of the stress, MPa."""

    mass: float
    displacement: float
    stress: float


def sharp_edges(mesh):
    """Corner nodes (k, 2) of mesh edges near which the stress measure does not look: re-entrant
    ones, where stress has no limit, and those of what is held."""
    facets, points = mesh.facets, mesh.points
    corners = points[facets]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    edges = np.sort(np.concatenate([facets[:, [0, 1]], facets[:, [1, 2]], facets[:, [2, 0]]]), axis=1)
    others = np.concatenate([facets[:, 2], facets[:, 0], facets[:, 1]])
    owners = np.tile(np.arange(len(facets)), 3)
    order = np.lexsort((edges[:, 1], edges[:, 0]))
    first, second = order[0::2], order[1::2]  # the two facets of each edge
    beyond = points[others[second]] - points[edges[first, 0]]
    rise = np.einsum("kc,kc->k", beyond, normals[owners[first]]) / np.linalg.norm(beyond, axis=1)
    face_of = np.zeros(len(facets), int)
    for number, face in enumerate(mesh.faces.values()):
        face_of[face.facet_indices] = number
    sharp = (rise > .3) & (face_of[owners[first]] != face_of[owners[second]])
    held = mesh.groups["supports"].facets
    return np.concatenate([edges[first[sharp]], held[:, [0, 1]], held[:, [1, 2]],
                           held[:, [2, 0]]])


class Weights:
    """Of each tet in the stress measure, by the distance of its centre from sharp edges."""

    def __init__(self, mesh):
        self._mesh = mesh
        edges = sharp_edges(mesh)
        shares = np.repeat(np.linspace(0, 1, 9), len(edges))
        self._edges = np.tile(edges, (9, 1))
        self._shares = np.stack([1 - shares, shares])
        sharp = np.einsum("sk,ksc->kc", self._shares, mesh.points[self._edges])
        centres = mesh.points[mesh.tets].mean(axis=1)
        distance, self._nearest = cKDTree(sharp).query(centres)
        self._away = (centres - sharp[self._nearest]) / np.maximum(distance, 1e-12)[:, None]
        share = np.clip((distance - NEAR) / (FAR - NEAR), 0, 1)
        self.values = share * share * (3 - 2 * share)
        self._slopes = 6 * share * (1 - share) / (FAR - NEAR)

    def by_node(self, by_weight):
        """From d(J)/d(weights) to d(J)/d(node), (n, 3)."""
        out = np.zeros_like(self._mesh.all_points)
        pull = (by_weight * self._slopes)[:, None] * self._away
        np.add.at(out, self._mesh.tets, np.repeat(pull[:, None] / 4, 4, axis=1))
        for side in range(2):
            np.add.at(out, self._edges[self._nearest, side],
                      -self._shares[side, self._nearest][:, None] * pull)
        return out


class Solved:
    """A part with its solution."""

    def __init__(self, part):
        self.part = part
        self.mesh = part.mesh()
        self.solution = rc.calculix.solve(self.mesh, STEEL, SUPPORTS, LOADS)
        self._weights = Weights(self.mesh)
        volume, self._volume_seed = rc.adjoint.volume(self.mesh)
        self._stress = rc.adjoint.stress_norm(self.mesh, self.solution.displacements, STEEL, POWER,
                                              self._weights.values)
        self.measures = Measures(DENSITY * volume, self.solution.work / FORCE, self._stress.value)

    def gradients(self, *parameters):
        """Of mass, displacement and stress by the parameters; a row each. One further solution."""
        mesh, solution = self.mesh, self.solution
        _, compliance = rc.adjoint.compliance(mesh, solution, STEEL, LOADS)
        partial = self._stress
        adjoint = rc.calculix.solve(mesh, STEEL, SUPPORTS, {}, forces=partial.by_displacement)
        stress = rc.adjoint.sensitivity(
            mesh, solution, adjoint, STEEL, LOADS,
            partial.by_node + self._weights.by_node(partial.by_weight))
        rows = [self.part.gradient(seed, *parameters)
                for seed in (DENSITY * self._volume_seed, compliance / FORCE, stress)]
        return np.array([[row[name] for name in parameters] for row in rows])
