"""Validity of a delivered mesh, judged from its file and its model's document alone."""
import functools

import meshio
import numpy as np

from model_geometry import Model
from quality import quality

FACETS = np.array([[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]])


class Mesh:
    """Nodes, tets and the maps of a `.vtu` file."""

    def __init__(self, path):
        data = meshio.read(path)
        self.nodes = np.asarray(data.points, float)
        self.tets = np.vstack([c.data for c in data.cells if c.type == "tetra"]).astype(np.int64)
        self.point = {k: np.asarray(v) for k, v in data.point_data.items()}
        self.cell = {k: np.asarray(v[0]) for k, v in data.cell_data.items()}
        self.transforms = {int(k.split(":")[1]): np.asarray(v, float).ravel()
                           for k, v in data.field_data.items() if k.startswith("transform:")}

    def quality(self, exact_volume):
        return quality(self.nodes, self.tets, exact_volume)

    def boundary_facets(self):
        """Facets of one tet only, and how many facets have more than two."""
        facets = np.sort(self.tets[:, FACETS].reshape(-1, 3), axis=1)
        unique, count = np.unique(facets, axis=0, return_counts=True)
        return unique[count == 1], int((count > 2).sum())


def boundary_faults(facets):
    """Edges of the boundary that do not have exactly two facets, and nodes whose facets form more
    than one fan: both 0 for a closed manifold."""
    edges = np.sort(facets[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    unique, index, count = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    open_edges = int((count != 2).sum())
    if open_edges:
        return open_edges, 0
    # Facets that share an edge belong to the same fan at both of its ends.
    order = np.argsort(index.ravel(), kind="stable").reshape(-1, 2) // 3
    parent = {(n, f): (n, f) for f, triangle in enumerate(facets.tolist()) for n in triangle}

    def root(k):
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    for (f, g), ends in zip(order.tolist(), unique.tolist()):
        for n in ends:
            parent[root((n, f))] = root((n, g))
    fans = sum(1 for k in parent if parent[k] == k)
    return 0, fans - len(np.unique(facets))


def missing_edges(mesh, edges, near, probe, facets):
    """How many of the points spread over the model's edges have no mesh edge beside them that runs
    along the same two surfaces. A point may lie beyond an edge's end by the radius of the probe that
    found it."""
    ends = np.unique(np.sort(facets[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1), axis=0)
    missing = 0
    for a, b, points in edges:
        on = (abs(a.distance(mesh.nodes)) < near) & (abs(b.distance(mesh.nodes)) < near)
        segments = ends[on[ends].all(1)]
        p, q = mesh.nodes[segments[:, 0]], mesh.nodes[segments[:, 1]]
        d = q - p
        size = np.linalg.norm(d, axis=1)
        for x in points:
            s = ((x - p) * d).sum(1) / size ** 2
            off = np.linalg.norm(x - p - s[:, None] * d, axis=1)
            beyond = np.maximum(-s, s - 1) * size
            missing += not ((beyond < 2 * probe) & (off < .25 * size)).any()
    return missing


def missing_vertices(mesh, vertices, near):
    """How many vertices of the model have no node."""
    return sum(np.linalg.norm(mesh.nodes - v, axis=1).min() > near for v in vertices)


@functools.cache
def expected(model_path):
    """The model's edges as points about 1/300 of its size apart, its vertices, how near counts and
    the radius of the probe that found the edges."""
    model = Model(model_path)
    return list(model.edges(model.diagonal / 300)), model.vertices(), 1e-6 * model.diagonal, model.probe


def faults(mesh, model_path, exact_volume):
    """What is wrong with the mesh, as a list of sentences; empty for a valid one."""
    edges, vertices, near, probe = expected(model_path)
    measured = mesh.quality(exact_volume)
    facets, crowded = mesh.boundary_facets()
    open_edges, extra_fans = boundary_faults(facets)
    found = []
    a, b, c, d = (mesh.nodes[mesh.tets[:, i]] for i in range(4))
    inverted = int((np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) <= 0).sum())
    for count, what in ((inverted, "tets are inverted or flat"),
                        (crowded, "facets have more than two tets"),
                        (open_edges, "boundary edges do not have two facets"),
                        (extra_fans, "boundary nodes join separate sheets"),
                        (len(mesh.nodes) - measured["nodes"], "nodes belong to no tet"),
                        (missing_edges(mesh, edges, near, probe, facets), "points of model edges are not on the mesh"),
                        (missing_vertices(mesh, vertices, near), "model vertices have no node")):
        if count:
            found.append(f"{count} {what}")
    if abs(measured["vol_err"]) > 0.002:
        found.append(f"volume is off by {100 * measured['vol_err']:.3f} %")
    return found


def kept(mesh, parent):
    """Nodes and tets kept, counted from coordinates: a node whose bits are those of its original
    under its transformation, a tet of four such nodes that formed a tet there. The transformation
    is applied as the protocol says: row by row, left to right, without fused operations."""
    original, index = mesh.point["original_node"].ravel(), mesh.point["transform"].ravel()
    same = np.zeros(len(mesh.nodes), bool)
    for k in np.unique(index[index >= 0]):
        m = mesh.transforms[k]
        nodes = np.flatnonzero(index == k)
        p = parent.nodes[original[nodes]]
        if not np.array_equal(m, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]):
            p = np.stack([m[r] * p[:, 0] + m[r + 1] * p[:, 1] + m[r + 2] * p[:, 2] + m[r + 3]
                          for r in (0, 4, 8)], axis=1)
        same[nodes] = (p == mesh.nodes[nodes]).all(1)
    there = {tuple(t) for t in np.sort(parent.tets, axis=1).tolist()}
    whole = mesh.tets[same[mesh.tets].all(1)]
    tets = sum(tuple(t) in there for t in np.sort(original[whole], axis=1).tolist())
    return int(same.sum()), tets
