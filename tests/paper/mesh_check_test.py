#!/usr/bin/python3
"""The evaluator accepts a right mesh of simple-b, made here of cubes, and sees every fault put in."""
import itertools
import unittest

import numpy as np

import mesh_check
from cases import CASES

SIMPLE = CASES[0]


def cubes():
    """simple-b in cubes of 5 mm with six tets each, one for every way along the axes."""
    index, nodes, tets = {}, [], []

    def node(p):
        if p not in index:
            index[p] = len(nodes)
            nodes.append([5.0 * c for c in p])
        return index[p]

    for lo, hi in (((-10, -6, 0), (10, 6, 8)), ((1, -3, 8), (7, 3, 12))):
        for corner in itertools.product(*(range(a, b) for a, b in zip(lo, hi))):
            for order in itertools.permutations(range(3)):
                path = [list(corner)]
                for axis in order:
                    path.append(path[-1].copy())
                    path[-1][axis] += 1
                a, b, c, d = (node(tuple(p)) for p in path)
                even = order in ((0, 1, 2), (1, 2, 0), (2, 0, 1))
                tets.append([a, b, c, d] if even else [b, a, c, d])
    mesh = mesh_check.Mesh.__new__(mesh_check.Mesh)
    mesh.nodes, mesh.tets = np.array(nodes), np.array(tets)
    return mesh


def node_at(mesh, *p):
    return int(np.linalg.norm(mesh.nodes - p, axis=1).argmin())


class Evaluator(unittest.TestCase):
    def setUp(self):
        self.mesh = cubes()

    def faults(self):
        return mesh_check.faults(self.mesh, SIMPLE.path(SIMPLE.modified), SIMPLE.exact_volume)

    def assert_fault(self, text):
        self.assertTrue(any(text in f for f in self.faults()), self.faults())

    def test_accepts_a_right_mesh(self):
        self.assertEqual([], self.faults())

    def test_sees_an_inverted_tet(self):
        self.mesh.tets[100] = self.mesh.tets[100][[1, 0, 2, 3]]
        self.assert_fault("1 tets are inverted")

    def test_sees_a_cavity_that_touches_itself_along_an_edge(self):
        # Two tets of one cube that share its diagonal and no more.
        self.mesh.tets = np.delete(self.mesh.tets, [5000, 5003], axis=0)
        self.assert_fault("1 boundary edges do not have two facets")

    def test_sees_a_doubled_tet(self):
        self.mesh.tets = np.vstack([self.mesh.tets, self.mesh.tets[:1]])
        self.assert_fault("facets")

    def test_sees_sheets_that_join_in_a_node(self):
        far = len(self.mesh.nodes)
        corner = node_at(self.mesh, 50, 30, 40)
        self.mesh.nodes = np.vstack([self.mesh.nodes, [[51, 30, 40], [51, 31, 40], [51, 30, 41]]])
        self.mesh.tets = np.vstack([self.mesh.tets, [[corner, far, far + 1, far + 2]]])
        self.assert_fault("join separate sheets")

    def test_sees_a_missing_vertex_and_its_edges(self):
        self.mesh.nodes[node_at(self.mesh, 50, 30, 40)] += [-.4, -.3, -.2]
        self.assert_fault("1 model vertices have no node")
        self.assert_fault("points of model edges are not on the mesh")

    def test_sees_an_edge_node_that_slid_off_its_edge(self):
        self.mesh.nodes[node_at(self.mesh, 5, 15, 40)] += [0, .5, 0]
        self.assert_fault("points of model edges are not on the mesh")

    def test_sees_a_wrong_volume(self):
        self.mesh.nodes[:, 2] *= 1.003
        self.assert_fault("volume is off by 0.3")

    def test_sees_a_node_without_tets(self):
        self.mesh.nodes = np.vstack([self.mesh.nodes, [[0, 0, 20.5]]])
        self.assert_fault("1 nodes belong to no tet")


class Kept(unittest.TestCase):
    """Two tets on five nodes, the second model moved by 0.1 along x."""

    def meshes(self):
        parent, child = (mesh_check.Mesh.__new__(mesh_check.Mesh) for _ in range(2))
        parent.nodes = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [.7, .7, .7]])
        parent.tets = np.array([[0, 1, 2, 3], [1, 2, 3, 4]])
        child.nodes, child.tets = parent.nodes + [0.1, 0, 0], parent.tets.copy()
        child.transforms = {0: np.array([1, 0, 0, .1, 0, 1, 0, 0, 0, 0, 1, 0.])}
        child.point = {"original_node": np.arange(5), "transform": np.zeros(5, int)}
        return parent, child

    def test_counts_nodes_and_tets_moved_by_their_transformation(self):
        parent, child = self.meshes()
        self.assertEqual((5, 2), mesh_check.kept(child, parent))

    def test_counts_bits_not_distances(self):
        parent, child = self.meshes()
        child.nodes[4, 0] = np.nextafter(child.nodes[4, 0], 2)
        self.assertEqual((4, 1), mesh_check.kept(child, parent))

    def test_asks_for_the_same_tet(self):
        parent, child = self.meshes()
        parent.tets = parent.tets[:1]
        self.assertEqual((5, 1), mesh_check.kept(child, parent))


if __name__ == "__main__":
    unittest.main()
