# SPDX-License-Identifier: Apache-2.0
"""Checks that every index of a received mesh is in range."""
from __future__ import annotations

from typing import Mapping

import numpy as np

from remesh_client._arrays import Array, I32, name_of
from remesh_client.errors import mesh_damaged
from remesh_client.v1 import mesh_pb2

_T = mesh_pb2
# Array, least index, and what it counts: a field of the header, an array of numbers or of text.
_INDICES: tuple[tuple[int, int, str | int], ...] = (
    (_T.MESH_ARRAY_TETS, 0, "nodes"),
    (_T.MESH_ARRAY_FACETS, 0, "nodes"),
    (_T.MESH_ARRAY_FACET_TETS, 0, "tets"),
    (_T.MESH_ARRAY_FACET_GROUP, 0, _T.MESH_ARRAY_FACET_GROUPS),
    (_T.MESH_ARRAY_TET_CELLS, 0, _T.MESH_ARRAY_CELL_OWNERS),
    (_T.MESH_ARRAY_NODE_TRANSFORMS, -1, _T.MESH_ARRAY_TRANSFORMS),
    (_T.MESH_ARRAY_EDGE_MIDS, 0, "nodes"),
    (_T.MESH_ARRAY_TET_MIDS, 0, "mid_nodes"),
    (_T.MESH_ARRAY_FACET_MIDS, 0, "mid_nodes"),
    (_T.MESH_ARRAY_MID_NODE_TRANSFORMS, -1, _T.MESH_ARRAY_TRANSFORMS),
)
_ORIGINS = (_T.MESH_ARRAY_NODE_ORIGINS, _T.MESH_ARRAY_MID_NODE_ORIGINS)
_MEMBERS = ((_T.MESH_ARRAY_GROUP_FACETS, "facets"), (_T.MESH_ARRAY_GROUP_TETS, "tets"))


def check_indices(header: mesh_pb2.MeshHeader, numbers: Mapping[int, Array],
                  texts: Mapping[int, bytes]) -> None:
    """Raises MeshDamaged. Looks at what there is: not all arrays have to have been asked for."""
    lines = {array: text.count(b"\n") for array, text in texts.items()}
    for array, least, counted in _INDICES:
        if array not in numbers:
            continue
        if isinstance(counted, str):
            _check(numbers[array], least, getattr(header, counted), array)
        elif counted in numbers or counted in lines:
            size = lines[counted] if counted in lines else len(numbers[counted])
            _check(numbers[array], least, size, array)
    for array in _ORIGINS:
        if array in numbers:
            _check(numbers[array], 0, 3, array)
    for array, counted in _MEMBERS:
        if array in numbers and _T.MESH_ARRAY_GROUP_NAMES in lines:
            _check(numbers[array][:, 0], 0, lines[_T.MESH_ARRAY_GROUP_NAMES], array)
            _check(numbers[array][:, 1], 0, getattr(header, counted), array)
    _check_facets(numbers)
    features = lines.get(_T.MESH_ARRAY_TRANSFORM_FEATURES)
    transforms = numbers.get(_T.MESH_ARRAY_TRANSFORMS)
    if features is not None and transforms is not None and features != len(transforms):
        raise mesh_damaged("TRANSFORM_FEATURES has the wrong count")


def _check(indices: Array, least: int, size: int, array: int) -> None:
    if not indices.size:
        return
    if least == 0 and indices.dtype == I32 and indices.flags.c_contiguous:
        indices = indices.view(np.uint32)  # what is negative is large: one look at each
    elif int(indices.min()) < least:
        raise mesh_damaged(f"{name_of(array)} has an index out of range")
    if int(indices.max()) >= size:
        raise mesh_damaged(f"{name_of(array)} has an index out of range")


def _check_facets(numbers: Mapping[int, Array]) -> None:
    """Exactly one corner of a facet's tet is not the facet's."""
    needed = (_T.MESH_ARRAY_FACETS, _T.MESH_ARRAY_FACET_TETS, _T.MESH_ARRAY_TETS)
    if not all(array in numbers for array in needed):
        return
    facets, facet_tets, tets = (numbers[array] for array in needed)
    corners = np.ascontiguousarray(tets[facet_tets].T)  # compared column by column
    nodes = np.ascontiguousarray(facets.T)
    shared = np.zeros(len(facets), dtype=np.int8)
    for corner in corners:
        for node in nodes:
            shared += corner == node
    if (shared != 3).any():
        raise mesh_damaged("a facet is not one of its tet")
