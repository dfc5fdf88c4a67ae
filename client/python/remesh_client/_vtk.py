# SPDX-License-Identifier: Apache-2.0
"""A mesh as VTK has it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

    from remesh_client.mesh import Mesh

# VTK's types of cells.
_TETRA, _QUADRATIC_TETRA, _TRIANGLE, _QUADRATIC_TRIANGLE = 10, 24, 5, 22


def to_vtk(mesh: Mesh) -> vtkUnstructuredGrid:
    """The tets, then the facets, with data as the daemon's `.vtu` has them, under the same names.

    Point data: `origin`, `original_node` (of mid-nodes the parent's mid-node), `node_id`, and
    `size` where edge lengths differ. Cell data: `face` (of a facet: its set of model faces, -1 of
    tets), `group:G` (1 in group G of the model), and of tets `kept`, `original_tet`, `tet_id`,
    `cell`, `owner:F` (1 where feature F owns the tet's cell). Field data: `face:F.f`, the sets
    that lie on that face.
    """
    from vtkmodules.util import numpy_support
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkUnstructuredGrid

    second = mesh.order == 2
    tets, facets = (mesh.tets10, mesh.facets6) if second else (mesh.tets, mesh.facets)
    corners = np.concatenate([tets.ravel(), facets.ravel()]).astype(np.int64)
    sizes = np.repeat([tets.shape[1], facets.shape[1]], [len(tets), len(facets)])
    types = np.repeat([_QUADRATIC_TETRA, _QUADRATIC_TRIANGLE] if second else [_TETRA, _TRIANGLE],
                      [len(tets), len(facets)]).astype(np.uint8)
    points, cells, grid = vtkPoints(), vtkCellArray(), vtkUnstructuredGrid()
    points.SetData(numpy_support.numpy_to_vtk(mesh.all_points, deep=1))
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(offsets, deep=1),
                  numpy_support.numpy_to_vtkIdTypeArray(corners, deep=1))
    grid.SetPoints(points)
    grid.SetCells(numpy_support.numpy_to_vtk(types, deep=1), cells)

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
    tets, facets = len(mesh.tets), len(mesh.facets)

    def of_tets(values: Any, of_facets: int) -> Any:
        return np.concatenate([values, np.full(facets, of_facets, values.dtype)])

    def flags(in_tets: Any, in_facets: Any) -> Any:
        flagged = np.zeros(tets + facets, np.uint8)
        flagged[in_tets] = 1
        flagged[tets + np.asarray(in_facets, int)] = 1
        return flagged

    data: dict[str, Any] = {
        "kept": of_tets((mesh.parent_tets >= 0).astype(np.uint8), 0),
        "original_tet": of_tets(mesh.parent_tets, -1), "tet_id": of_tets(mesh.tet_ids, 0),
        "cell": of_tets(mesh.tet_cells, -1),
        "face": np.concatenate([np.full(tets, -1, np.int32), mesh.facet_group])}
    for feature, material in mesh.features.items():
        data[f"owner:{feature}"] = flags(material.tets, [])
    for name, group in mesh.groups.items():
        data[f"group:{name}"] = flags(group.tets, group.facet_indices)
    return data
