"""Nodal fields from one mesh to the next."""
import numpy as np
import pytest

import remesh_client as rc
from remesh_client._locate import TetLocator, closest_of_triangle
from remesh_client._shapes import curved_weights, tet10_derivatives, tet10_values


def linear(points):
    return 3 + points @ np.array([.5, -2, .25])


def quadratic(points):
    x, y, z = points.T
    return 1 + x * y - .5 * z * z + 2 * x


@pytest.fixture(scope="module", params=[1, 2])
def pair(request, daemon, cases):
    """A mesh and that of an edit by which the solid shrinks: new nodes lie in the old mesh."""
    old = daemon.mesh(cases / "tool1-a.json", nodes=3000, order=request.param)
    return old.mesh(), old.edit(pin_radius=3.5).mesh()


def test_linear_fields_come_over_exactly_within_both(pair):
    old, new = pair
    operator = rc.transfer(old, new)
    assert operator.shape == (len(new.all_points), len(old.all_points))
    scale = np.abs(linear(old.all_points)).max()
    error = np.abs(operator @ linear(old.all_points) - linear(new.all_points)) / scale
    inside = ~TetLocator(old.points, old.tets).locate(new.all_points).outside
    assert inside.mean() > .9  # mid-nodes on round walls lie outside of straight tets
    assert error[inside].max() < 1e-11
    assert np.abs(operator.sum(axis=1) - 1).max() < 1e-12


def test_nodes_that_stayed_keep_their_values_to_the_bit(pair):
    old, new = pair
    values = np.random.default_rng(1).random(len(old.all_points))
    moved = rc.transfer(old, new) @ values
    parents = new.parent_nodes
    stayed = np.flatnonzero(parents >= 0)
    stayed = stayed[(new.points[stayed] == old.points[parents[stayed]]).all(axis=1)]
    assert len(stayed) > .5 * len(new.points)
    assert np.array_equal(moved[stayed], values[parents[stayed]])


def test_what_lies_outside_takes_the_closest_value_of_the_boundary(daemon, cases):
    old = daemon.mesh(cases / "tool1-a.json", nodes=1500)
    new = old.edit(pin_radius=5.5).mesh()
    old = old.mesh()
    found = rc.transfer(old, new) @ linear(old.points)
    assert found.min() >= linear(old.points).min() and found.max() <= linear(old.points).max()
    outside = TetLocator(old.points, old.tets).locate(new.points).outside
    assert outside.any()
    far = np.abs(found - linear(new.points))[outside].max()
    assert 0 < far < 3 * np.linalg.norm([.5, -2, .25])  # no further than the wall has moved


def test_quadratic_fields_come_over_by_second_order(daemon, cases):
    model = {"features": [{"id": "a", "nature": "ADDITIVE", "type": "block",
                           "parameters": {"dx": 4, "dy": 3, "dz": 2}}]}
    old = daemon.mesh(model, nodes=300, order=2, seed=1).mesh()
    new = daemon.mesh(model, nodes=500, order=2, seed=2).mesh()
    error = rc.transfer(old, new) @ quadratic(old.all_points) - quadratic(new.all_points)
    assert np.abs(error).max() < 1e-11 * np.abs(quadratic(old.all_points)).max()
    coarse = daemon.mesh(model, nodes=300, seed=1).mesh()
    assert rc.transfer(old, coarse).shape == (len(coarse.points), len(old.all_points))
    assert rc.transfer(coarse, new).shape == (len(new.all_points), len(coarse.points))


@pytest.mark.parametrize("order", [1, 2])
def test_values_follow_features_that_move(daemon, cases, order):
    first = daemon.mesh(cases / "simple-a.json", nodes=1500, order=order)
    new, old = first.edit(top_x=20).mesh(), first.mesh()
    values = np.random.default_rng(2).random(len(old.all_points))
    followed = rc.transfer(old, new, follow_features=True) @ values
    if order == 2:
        mids = new.parent_mids >= 0
        assert mids.any() and np.array_equal(followed[len(new.points):][mids],
                                             values[len(old.points) + new.parent_mids[mids]])
    followed = followed[:len(new.points)]
    copied = new.origins > 0
    assert np.array_equal(followed[copied], values[new.parent_nodes[copied]])
    went = (new.points[copied] != old.points[new.parent_nodes[copied]]).any(axis=1)
    assert went.any()
    with pytest.raises(ValueError, match="not made of the old one"):
        rc.transfer(new, old, follow_features=True)


def test_points_are_found_behind_holes_and_on_facets():
    grid = np.array(np.meshgrid(*[np.arange(6.)] * 3, indexing="ij")).reshape(3, -1).T
    cubes = [(i, j, k) for i in range(5) for j in range(5) for k in range(5)
             if not (1 <= i < 4 and 1 <= j < 4)]  # a square ring
    at = {tuple(p): n for n, p in enumerate(grid)}
    tets = []
    for i, j, k in cubes:
        c = [at[(i + a, j + b, k + d)] for a in (0, 1) for b in (0, 1) for d in (0, 1)]
        for path in ((1, 3), (1, 5), (2, 3), (2, 6), (4, 5), (4, 6)):
            tets.append([c[0], c[path[0]], c[path[1]], c[7]])
    tets = np.array(tets, np.int32)
    volumes = np.linalg.det(grid[tets[:, 1:]] - grid[tets[:, :1]])
    tets[volumes < 0] = tets[volumes < 0][:, [0, 2, 1, 3]]
    locator = TetLocator(grid, tets)
    points = np.random.default_rng(4).random((4000, 3)) * 5
    in_ring = ~((points[:, :2] > 1) & (points[:, :2] < 4)).all(axis=1)
    found = locator.locate(points)
    assert np.array_equal(~found.outside, in_ring)
    back = np.einsum("ki,kij->kj", found.weights, grid[tets[found.tets]])
    assert np.allclose(back[in_ring], points[in_ring], atol=1e-12)
    to_wall = np.minimum(points[:, :2] - 1, 4 - points[:, :2]).min(axis=1)
    assert np.allclose(np.linalg.norm(back - points, axis=1)[~in_ring], to_wall[~in_ring])


def test_the_closest_point_of_a_triangle():
    triangle = np.array([[[0., 0, 0], [1, 0, 0], [0, 1, 0]]])
    for point, expected in (([.2, .2, 5], [.2, .2, 0]), ([-1, -1, 0], [0, 0, 0]),
                            ([.5, -2, 1], [.5, 0, 0]), ([1, 1, 0], [.5, .5, 0]),
                            ([9, 0, 0], [1, 0, 0])):
        assert np.allclose(closest_of_triangle(np.array([point], float), triangle), [expected])


def test_shape_functions_and_the_way_back_through_curved_tets():
    random = np.random.default_rng(5)
    weights = random.dirichlet(np.ones(4), 50)
    assert np.allclose(tet10_values(weights).sum(axis=1), 1)
    step = 1e-6
    for w in range(4):
        more = weights.copy()
        more[:, w] += step
        slope = (tet10_values(more) - tet10_values(weights)) / step
        assert np.allclose(slope, tet10_derivatives(weights)[:, :, w], atol=1e-5)
    corners = np.array([[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    mids = np.array([(corners[a] + corners[b]) / 2 for a, b in
                     ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))])
    nodes = np.vstack([corners, mids + .05 * random.random((6, 3))])[None].repeat(50, axis=0)
    points = np.einsum("ki,kij->kj", tet10_values(weights), nodes)
    start = np.column_stack([1 - points.sum(axis=1), points])
    assert np.allclose(curved_weights(points, nodes, start), weights, atol=1e-10)
