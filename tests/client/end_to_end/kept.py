"""What a mesh file says of the mesh before it, checked with numpy alone."""
import meshio
import numpy as np

KEPT, MOVED = 1, 2
IDENTITY = np.array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], float)


def apply(matrix, points):
    """The rows of [R | t], each from left to right in doubles; the identity copies bits."""
    if (matrix == IDENTITY).all():
        return points
    x, y, z = points.T
    rows = matrix.reshape(3, 4)
    return np.stack([((r[0] * x + r[1] * y) + r[2] * z) + r[3] for r in rows], axis=1)


def check_maps(original_file, modified_file):
    """Asserts every map of `modified_file` against `original_file`; returns (nodes kept, tets kept)."""
    original, modified = meshio.read(original_file), meshio.read(modified_file)
    point, cell = modified.point_data, {k: v[0] for k, v in modified.cell_data.items()}
    origin, source, transform = point["origin"], point["original_node"], point["transform"]
    assert ((origin == 0) == (source == -1)).all() and ((origin == 0) == (transform == -1)).all()

    back = np.full_like(modified.points, np.nan)
    for name, matrix in modified.field_data.items():
        if name.startswith("transform:"):
            users = transform == int(name.split(":")[1])
            back[users] = apply(np.ravel(matrix), original.points[source[users]])
    copied = origin != 0
    same = (back.view(np.uint64) == modified.points.view(np.uint64)).all(axis=1)
    assert (same[copied] == (origin[copied] == KEPT)).all(), "KEPT and MOVED are not as told"

    ids, old_ids = point["node_id"], original.point_data["node_id"]
    assert len(np.unique(ids)) == len(ids) and len(np.unique(cell["tet_id"])) == len(cell["tet_id"])
    assert (ids[copied] == old_ids[source[copied]]).all()
    assert not set(ids[~copied].tolist()) & set(old_ids.tolist()), "a new node took an old id"

    tets, old_tets = modified.cells[0].data, original.cells[0].data
    old = {tuple(sorted(t)): k for k, t in enumerate(old_tets.tolist())}
    kept_source = np.where(origin == KEPT, source, -1)[tets]
    wanted = [old.get(tuple(sorted(t)), -1) if min(t) >= 0 else -1 for t in kept_source.tolist()]
    assert (cell["original_tet"] == np.array(wanted)).all(), "a tet is kept that was none, or the reverse"
    kept = cell["original_tet"] >= 0
    old_tet_ids = original.cell_data["tet_id"][0]
    assert (cell["tet_id"][kept] == old_tet_ids[cell["original_tet"][kept]]).all()
    return int((origin == KEPT).sum()), int(kept.sum())


def check_mesh(file):
    """Asserts positive tets and a closed boundary whose every facet has a face group."""
    mesh = meshio.read(file)
    points, tets = mesh.points, mesh.cells[0].data
    a, b, c, d = (points[tets[:, k]] for k in range(4))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) > 0).all(), "an inverted tet"
    facets = np.sort(tets[:, [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]]].reshape(-1, 3), axis=1)
    _, place, count = np.unique(facets, axis=0, return_index=True, return_counts=True)
    assert count.max() <= 2
    boundary = place[count == 1]
    edges = facets[boundary][:, [[0, 1], [0, 2], [1, 2]]].reshape(-1, 2)
    _, count = np.unique(edges, axis=0, return_counts=True)
    assert (count == 2).all(), "the boundary is no closed manifold"
    groups = mesh.cell_data["facet_groups"][0].ravel()
    named = np.zeros(len(facets), bool)
    named[boundary] = True
    assert ((groups >= 0) == named).all(), "facets with a group are not the boundary"
