# SPDX-License-Identifier: Apache-2.0
"""The arrays of a mesh: their numbers in the protocol, types and rows."""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from remesh_client.v1 import mesh_pb2

Array = npt.NDArray[Any]

F64, I32, U64, U8 = (np.dtype(name) for name in ("<f8", "<i4", "<u8", "u1"))
DTYPES: dict[int, np.dtype[Any]] = {mesh_pb2.ARRAY_TYPE_F64: F64, mesh_pb2.ARRAY_TYPE_I32: I32,
          mesh_pb2.ARRAY_TYPE_U64: U64, mesh_pb2.ARRAY_TYPE_U8: U8}


class Kind(NamedTuple):
    """What a row of an array consists of, and what there is a row for."""

    type: int  # ArrayType
    components: int
    rows: str  # field of MeshHeader that counts them; "" where none does

    @property
    def is_text(self) -> bool:
        return self.type == mesh_pb2.ARRAY_TYPE_TEXT

    @property
    def dtype(self) -> np.dtype[Any]:
        return DTYPES[self.type]


def _kind(array_type: int, components: int = 1, rows: str = "") -> Kind:
    return Kind(array_type, components, rows)


_T = mesh_pb2
KNOWN: dict[int, Kind] = {
    _T.MESH_ARRAY_NODES: _kind(_T.ARRAY_TYPE_F64, 3, "nodes"),
    _T.MESH_ARRAY_TETS: _kind(_T.ARRAY_TYPE_I32, 4, "tets"),
    _T.MESH_ARRAY_NODE_IDS: _kind(_T.ARRAY_TYPE_U64, 1, "nodes"),
    _T.MESH_ARRAY_TET_IDS: _kind(_T.ARRAY_TYPE_U64, 1, "tets"),
    _T.MESH_ARRAY_FACETS: _kind(_T.ARRAY_TYPE_I32, 3, "facets"),
    _T.MESH_ARRAY_FACET_TETS: _kind(_T.ARRAY_TYPE_I32, 1, "facets"),
    _T.MESH_ARRAY_FACET_GROUP: _kind(_T.ARRAY_TYPE_I32, 1, "facets"),
    _T.MESH_ARRAY_FACET_GROUPS: _kind(_T.ARRAY_TYPE_TEXT),
    _T.MESH_ARRAY_TET_CELLS: _kind(_T.ARRAY_TYPE_I32, 1, "tets"),
    _T.MESH_ARRAY_CELL_OWNERS: _kind(_T.ARRAY_TYPE_TEXT),
    _T.MESH_ARRAY_NODE_ORIGINS: _kind(_T.ARRAY_TYPE_U8, 1, "nodes"),
    _T.MESH_ARRAY_ORIGINAL_NODES: _kind(_T.ARRAY_TYPE_I32, 1, "nodes"),
    _T.MESH_ARRAY_NODE_TRANSFORMS: _kind(_T.ARRAY_TYPE_I32, 1, "nodes"),
    _T.MESH_ARRAY_TRANSFORMS: _kind(_T.ARRAY_TYPE_F64, 12),
    _T.MESH_ARRAY_TRANSFORM_FEATURES: _kind(_T.ARRAY_TYPE_TEXT),
    _T.MESH_ARRAY_ORIGINAL_TETS: _kind(_T.ARRAY_TYPE_I32, 1, "tets"),
    _T.MESH_ARRAY_GROUP_NAMES: _kind(_T.ARRAY_TYPE_TEXT),
    _T.MESH_ARRAY_GROUP_FACETS: _kind(_T.ARRAY_TYPE_I32, 2),
    _T.MESH_ARRAY_GROUP_TETS: _kind(_T.ARRAY_TYPE_I32, 2),
    _T.MESH_ARRAY_NODE_SIZES: _kind(_T.ARRAY_TYPE_F64, 1, "nodes"),
    _T.MESH_ARRAY_MID_NODES: _kind(_T.ARRAY_TYPE_F64, 3, "mid_nodes"),
    _T.MESH_ARRAY_EDGE_MIDS: _kind(_T.ARRAY_TYPE_I32, 2, "mid_nodes"),
    _T.MESH_ARRAY_TET_MIDS: _kind(_T.ARRAY_TYPE_I32, 6, "tets"),
    _T.MESH_ARRAY_FACET_MIDS: _kind(_T.ARRAY_TYPE_I32, 3, "facets"),
    _T.MESH_ARRAY_MID_NODE_IDS: _kind(_T.ARRAY_TYPE_U64, 1, "mid_nodes"),
    _T.MESH_ARRAY_MID_NODE_ORIGINS: _kind(_T.ARRAY_TYPE_U8, 1, "mid_nodes"),
    _T.MESH_ARRAY_ORIGINAL_MID_NODES: _kind(_T.ARRAY_TYPE_I32, 1, "mid_nodes"),
    _T.MESH_ARRAY_MID_NODE_TRANSFORMS: _kind(_T.ARRAY_TYPE_I32, 1, "mid_nodes"),
}
# An even mesh has no sizes; a model may have no groups; mid-nodes are those of second order.
OPTIONAL = {_T.MESH_ARRAY_NODE_SIZES, _T.MESH_ARRAY_GROUP_NAMES, _T.MESH_ARRAY_GROUP_FACETS,
            _T.MESH_ARRAY_GROUP_TETS}
SECOND_ORDER = {array for array in KNOWN if array >= _T.MESH_ARRAY_MID_NODES}


def name_of(array: int) -> str:
    """`NODES`, for messages."""
    try:
        name: str = mesh_pb2.MeshArray.Name(array)
    except ValueError:
        return f"array {array}"
    return name.removeprefix("MESH_ARRAY_")
