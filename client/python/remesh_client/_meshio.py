# SPDX-License-Identifier: Apache-2.0
"""A mesh as meshio has it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import meshio

    from remesh_client.mesh import Mesh


def to_meshio(mesh: Mesh) -> meshio.Mesh:
    """Two blocks of cells, tets and boundary facets, and sets of each by name.

    `point_data` has `origin`, `parent_node` (-1 of mid-nodes) and `id`; `cell_data` the `cell` of
    tets and the `facet_group` of facets. `cell_sets` has the faces and groups in the block of
    facets, features and groups in that of tets.
    """
    import meshio
    second = mesh.order == 2
    cells = [("tetra10" if second else "tetra", mesh.tets10 if second else mesh.tets),
             ("triangle6" if second else "triangle", mesh.facets6 if second else mesh.facets)]
    mids = len(mesh.mids)
    point_data = {"origin": np.concatenate([mesh.origins, mesh.mid_origins]),
                  "parent_node": np.concatenate([mesh.parent_nodes, np.full(mids, -1, np.int32)]),
                  "id": np.concatenate([mesh.ids, mesh.mid_ids])}
    cell_data = {"cell": [mesh.tet_cells, np.full(len(mesh.facets), -1, np.int32)],
                 "facet_group": [np.full(len(mesh.tets), -1, np.int32), mesh.facet_group]}
    sets: dict[str, list[Any]] = {}
    for named in (mesh.faces, mesh.features, mesh.groups):
        for name, members in named.items():
            sets[name] = [members.tets, members.facet_indices]
    return meshio.Mesh(mesh.all_points, cells, point_data=point_data, cell_data=cell_data,
                       cell_sets=sets)
