# SPDX-License-Identifier: Apache-2.0
"""A mesh as VTK has it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

    from remesh_client.mesh import Mesh

_TETRA, _QUADRATIC_TETRA = 10, 24  # VTK's types of cells


def to_vtk(mesh: Mesh) -> vtkUnstructuredGrid:
    """The tets, with data as the daemon's `.vtu` has them, under the same names.

    Point data: `origin`, `original_node` (of mid-nodes the parent's mid-node), `node_id`, and
    `size` where edge lengths differ. Cell data: `kept`, `original_tet`, `tet_id`, `cell`,
    `owner:F` (1 where feature F owns the tet's cell), `face_group` (the group of one of its
    boundary facets, -1 inside). Field data: `face:F.f`, the groups that lie on that face.
    """
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid

    second = mesh.order == 2
    corners = np.ascontiguousarray(mesh.tets10 if second else mesh.tets, np.int64)
    points, cells, grid = vtkPoints(), vtkCellArray(), vtkUnstructuredGrid()
    points.SetData(numpy_support.numpy_to_vtk(mesh.all_points, deep=1))
    offsets = np.arange(0, corners.size + 1, corners.shape[1], dtype=np.int64)
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=1),
                  numpy_support.numpy_to_vtkIdTypeArray(corners.ravel(), deep=1))
    grid.SetPoints(points)
    grid.SetCells(_QUADRATIC_TETRA if second else _TETRA, cells)

    def put(data: Any, name: str, values: Any) -> None:
        array = numpy_support.numpy_to_vtk(np.ascontiguousarray(values), deep=1)
        array.SetName(name)
        data.AddArray(array)

    for name, values in _point_data(mesh).items():
        put(grid.GetPointData(), name, values)
    for name, values in _cell_data(mesh).items():
        put(grid.GetCellData(), name, values)
    for face in mesh.faces:
        groups = [k for k, names in enumerate(mesh.facet_groups) if face in names]
        put(grid.GetFieldData(), f"face:{face}", np.array(groups, np.int32))
    return grid


def _point_data(mesh: Mesh) -> dict[str, Any]:
    data: dict[str, Any] = {
        "origin": np.concatenate([mesh.origins, mesh.mid_origins]),
        "original_node": np.concatenate([mesh.parent_nodes, mesh.parent_mids]),
        "node_id": np.concatenate([mesh.ids, mesh.mid_ids])}
    if mesh.sizes is not None:
        of_mids = mesh.sizes[mesh.edge_mids].mean(axis=1)
        data["size"] = np.concatenate([mesh.sizes, of_mids])
    return data


def _cell_data(mesh: Mesh) -> dict[str, Any]:
    face_group = np.full(len(mesh.tets), -1, np.int32)
    face_group[mesh.facet_tets[::-1]] = mesh.facet_group[::-1]  # the first of several counts
    data: dict[str, Any] = {"kept": (mesh.parent_tets >= 0).astype(np.uint8),
                            "original_tet": mesh.parent_tets, "tet_id": mesh.tet_ids,
                            "cell": mesh.tet_cells, "face_group": face_group}
    for feature, material in mesh.features.items():
        owned = np.zeros(len(mesh.tets), np.uint8)
        owned[material.tets] = 1
        data[f"owner:{feature}"] = owned
    return data
