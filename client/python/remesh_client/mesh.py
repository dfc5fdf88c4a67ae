# SPDX-License-Identifier: Apache-2.0
"""A mesh as numpy arrays."""
from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Iterator, Mapping, TypeVar

import numpy as np
import numpy.typing as npt

from remesh_client._arrays import Array, KNOWN
from remesh_client._assembler import Content
from remesh_client.v1 import mesh_pb2

if TYPE_CHECKING:
    import meshio
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid

_T = mesh_pb2
Ints = npt.NDArray[np.int32]
Floats = npt.NDArray[np.float64]
Ids = npt.NDArray[np.uint64]
Bytes = npt.NDArray[np.uint8]
A = TypeVar("A", bound=npt.NDArray[Any])
WriteFile = Callable[[str, "os.PathLike[str] | str"], Path]
NEW, KEPT, MOVED = 0, 1, 2  # of `Mesh.origins`


class NodeSet:
    """Facets and tets under one name, and their nodes.

    Attributes:
        name: of the face (`hole1.wall`), the group or the feature.
        facet_indices: (k,) rows of `mesh.facets`, ascending.
        tets: (k,) rows of `mesh.tets`, ascending; empty for faces and groups of faces.
    """

    def __init__(self, mesh: Mesh, name: str, facet_indices: Ints, tets: Ints) -> None:
        self.name = name
        self.facet_indices = facet_indices
        self.tets = tets
        self._mesh = mesh

    @cached_property
    def facets(self) -> Ints:
        """(k, 3) corner nodes of each facet, turning outward."""
        return _fixed(self._mesh.facets[self.facet_indices])

    @cached_property
    def facets6(self) -> Ints:
        """(k, 6) nodes of each facet of second order, in VTK's order, indices of `all_points`."""
        return _fixed(self._mesh.facets6[self.facet_indices])

    @cached_property
    def nodes(self) -> Ints:
        """(k,) corner nodes, ascending, indices of `mesh.points`."""
        members = np.concatenate([self.facets.ravel(), self._mesh.tets[self.tets].ravel()])
        return _fixed(np.unique(members))

    @cached_property
    def all_nodes(self) -> Ints:
        """(k,) nodes with the mid-nodes, ascending, indices of `mesh.all_points`."""
        if self._mesh.order == 1:
            return self.nodes
        members = [self.facets6.ravel(), self._mesh.tets10[self.tets].ravel()]
        return _fixed(np.unique(np.concatenate(members)))

    def __repr__(self) -> str:
        return (f"<NodeSet {self.name}: {len(self.nodes)} nodes, {len(self.facet_indices)} facets, "
                f"{len(self.tets)} tets>")


class _Sets(Mapping[str, NodeSet]):
    """Sets by name, each made when it is asked for."""

    def __init__(self, make: Callable[[str], NodeSet], names: list[str], what: str) -> None:
        self._make = make
        self._names = dict.fromkeys(names)
        self._what = what
        self._made: dict[str, NodeSet] = {}

    def __getitem__(self, name: str) -> NodeSet:
        if name not in self._names:
            known = ", ".join(self._names) or "none"
            raise KeyError(f"no {self._what} {name!r} on this mesh; there are: {known}")
        if name not in self._made:
            self._made[name] = self._make(name)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


class Mesh:
    """A mesh as the daemon delivers it, checked: digests, counts and indices.

    Arrays are read-only, since the next mesh of the stream is made of them; change a copy. Lengths
    are in the model's unit, indices from 0, every tet (a, b, c, d) has positive volume,
    dot(cross(b - a, c - a), d - a) > 0. n nodes, m tets, k facets, p mid-nodes.
    """

    def __init__(self, content: Content, write_file: WriteFile | None = None,
                 exact_areas: Mapping[str, float] | None = None) -> None:
        self.content = content
        self._write_file = write_file
        # Of what the groups of the model select, and of faces, by name, where they are known.
        self.exact_areas: Mapping[str, float] = exact_areas or {}
        header = content.header
        self.revision: str = header.revision  # id
        self.parent: str = header.parent  # id of the parent's revision; empty for a first mesh
        self.order: int = header.order or 1
        self.unit: str = header.unit  # a label
        self.model_name: str = header.model_name

    # Geometry ---------------------------------------------------------------------------------

    @property
    def points(self) -> Floats:
        """(n, 3) corner nodes."""
        return self._floats(_T.MESH_ARRAY_NODES)

    @property
    def tets(self) -> Ints:
        """(m, 4) corner nodes of each tet."""
        return self._ints(_T.MESH_ARRAY_TETS)

    @property
    def facets(self) -> Ints:
        """(k, 3) corner nodes of each boundary facet, turning outward."""
        return self._ints(_T.MESH_ARRAY_FACETS)

    @property
    def facet_tets(self) -> Ints:
        """(k,) the tet behind each facet."""
        return self._ints(_T.MESH_ARRAY_FACET_TETS)

    @property
    def sizes(self) -> Floats | None:
        """(n,) edge length aimed at by node; None where it is the same everywhere."""
        return self.content.numbers.get(_T.MESH_ARRAY_NODE_SIZES)

    @property
    def mids(self) -> Floats:
        """(p, 3) mid-nodes; p is 0 in a mesh of first order."""
        return self._floats(_T.MESH_ARRAY_MID_NODES)

    @property
    def edge_mids(self) -> Ints:
        """(p, 2) corner nodes of each mid-node's edge."""
        return self._ints(_T.MESH_ARRAY_EDGE_MIDS)

    @property
    def tet_mids(self) -> Ints:
        """(m, 6) mid-nodes, from 0, of the edges 01 12 20 03 13 23 of each tet."""
        return self._ints(_T.MESH_ARRAY_TET_MIDS)

    @property
    def facet_mids(self) -> Ints:
        """(k, 3) mid-nodes, from 0, of the edges 01 12 20 of each facet."""
        return self._ints(_T.MESH_ARRAY_FACET_MIDS)

    @cached_property
    def all_points(self) -> Floats:
        """(n + p, 3) corner nodes, then mid-nodes."""
        return self.points if self.order == 1 else _fixed(np.concatenate([self.points, self.mids]))

    @cached_property
    def tets10(self) -> Ints:
        """(m, 10) nodes of each tet of second order, in VTK's order, indices of `all_points`.

        Raises ValueError for a mesh of first order.
        """
        return self._with_mids(self.tets, self.tet_mids)

    @cached_property
    def facets6(self) -> Ints:
        """(k, 6) likewise, of each facet."""
        return self._with_mids(self.facets, self.facet_mids)

    # Names ------------------------------------------------------------------------------------

    @cached_property
    def facet_groups(self) -> list[tuple[str, ...]]:
        """Of each group of facets the model faces that it lies on, the latest owner first."""
        return [tuple(line.split()) for line in self._lines(_T.MESH_ARRAY_FACET_GROUPS)]

    @property
    def facet_group(self) -> Ints:
        """(k,) the group of each facet, an index of `facet_groups`."""
        return self._ints(_T.MESH_ARRAY_FACET_GROUP)

    @cached_property
    def cell_owners(self) -> list[tuple[str, ...]]:
        """Of each cell the features that own it, in history order."""
        return [tuple(line.split()) for line in self._lines(_T.MESH_ARRAY_CELL_OWNERS)]

    @property
    def tet_cells(self) -> Ints:
        """(m,) the cell of each tet, an index of `cell_owners`."""
        return self._ints(_T.MESH_ARRAY_TET_CELLS)

    @cached_property
    def faces(self) -> Mapping[str, NodeSet]:
        """The model's faces on the boundary, `mesh.faces["hole1.wall"].nodes`."""
        names = [name for group in self.facet_groups for name in group]
        return _Sets(self._face, names, "face")

    @cached_property
    def features(self) -> Mapping[str, NodeSet]:
        """The material that each feature owns, `mesh.features["rib"].tets`."""
        names = [name for owners in self.cell_owners for name in owners]
        return _Sets(self._feature, names, "feature with material")

    @cached_property
    def groups(self) -> Mapping[str, NodeSet]:
        """The groups of the model, `mesh.groups["load"].facets`; empty where it has none."""
        return _Sets(self._group, self._lines(_T.MESH_ARRAY_GROUP_NAMES), "group")

    # Where nodes and tets come from -------------------------------------------------------------

    @property
    def ids(self) -> Ids:
        """(n,) permanent ids of the nodes: a kept node keeps its own through edits."""
        return self._ids(_T.MESH_ARRAY_NODE_IDS)

    @property
    def tet_ids(self) -> Ids:
        """(m,) permanent ids of the tets."""
        return self._ids(_T.MESH_ARRAY_TET_IDS)

    @property
    def parent_nodes(self) -> Ints:
        """(n,) the parent's node that each node is; -1 where new."""
        return self._ints(_T.MESH_ARRAY_ORIGINAL_NODES)

    @property
    def origins(self) -> Bytes:
        """(n,) 0 new, 1 kept, 2 copied and then moved."""
        return self._bytes(_T.MESH_ARRAY_NODE_ORIGINS)

    @property
    def parent_tets(self) -> Ints:
        """(m,) the parent's tet that each tet is; -1 where not kept."""
        return self._ints(_T.MESH_ARRAY_ORIGINAL_TETS)

    @property
    def node_transforms(self) -> Ints:
        """(n,) row of `transforms` that took each node from its parent's place; -1 where new."""
        return self._ints(_T.MESH_ARRAY_NODE_TRANSFORMS)

    @property
    def transforms(self) -> Floats:
        """(t, 12) the rows of [R | t] of each transformation."""
        return self._floats(_T.MESH_ARRAY_TRANSFORMS)

    @property
    def mid_ids(self) -> Ids:
        """(p,) permanent ids of the mid-nodes."""
        return self._ids(_T.MESH_ARRAY_MID_NODE_IDS)

    @property
    def parent_mids(self) -> Ints:
        """(p,) the parent's mid-node, counted from 0, that each mid-node is; -1 where new."""
        return self._ints(_T.MESH_ARRAY_ORIGINAL_MID_NODES)

    @property
    def mid_origins(self) -> Bytes:
        """(p,) 0 new, 1 kept, 2 moved."""
        return self._bytes(_T.MESH_ARRAY_MID_NODE_ORIGINS)

    # Elsewhere ----------------------------------------------------------------------------------

    def write(self, path: os.PathLike[str] | str) -> Path:
        """Has the daemon write the mesh, or its exact model; the file appears whole or not at all.

        path: ends in `.vtu`, `.msh` or `.inp`, or in `.step` or `.stp` for the model. Returns the
        path. Raises ValueError for another ending, RemeshError, OSError, and RuntimeError where
        the mesh has no daemon: one that was unpickled, or of `remesh_client.aio` (there use
        `await part.write(path)`).
        """
        if self._write_file is None:
            raise RuntimeError("this mesh has no daemon at hand to write it; "
                               "of remesh_client.aio: await part.write(path)")
        return self._write_file(self.revision, path)

    def to_meshio(self) -> meshio.Mesh:
        """A meshio.Mesh: tets, boundary facets, and sets of both by face, group and feature."""
        from remesh_client._meshio import to_meshio
        return to_meshio(self)

    def to_vtk(self) -> vtkUnstructuredGrid:
        """A vtkUnstructuredGrid of tets and facets with their data, as in the file `.vtu`."""
        from remesh_client._vtk import to_vtk
        return to_vtk(self)

    def __getstate__(self) -> dict[str, Any]:
        """For pickling: the arrays and attributes, without the connection to the daemon."""
        state = ("content", "exact_areas", "revision", "parent", "order", "unit", "model_name")
        return {"_write_file": None, **{name: self.__dict__[name] for name in state}}

    def __repr__(self) -> str:
        mids = f", {len(self.mids)} mid-nodes" if self.order == 2 else ""
        return f"<Mesh {self.revision[:12]}: {len(self.points)} nodes{mids}, {len(self.tets)} tets>"

    # ------------------------------------------------------------------------------------------

    def _floats(self, array: int) -> Floats:
        return self._numbers(array)

    def _ints(self, array: int) -> Ints:
        return self._numbers(array)

    def _ids(self, array: int) -> Ids:
        return self._numbers(array)

    def _bytes(self, array: int) -> Bytes:
        return self._numbers(array)

    def _numbers(self, array: int) -> Array:
        found = self.content.numbers.get(array)
        if found is None:
            kind = KNOWN[array]
            shape = (0, kind.components) if kind.components > 1 else (0,)
            return np.empty(shape, kind.dtype)
        return found

    def _lines(self, array: int) -> list[str]:
        return self.content.texts.get(array, b"").decode("utf-8").splitlines()

    def _with_mids(self, corners: Ints, mids: Ints) -> Ints:
        if self.order == 1:
            raise ValueError("the mesh is of first order; ask for one with order=2")
        joined: Ints = np.hstack([corners, mids + np.int32(len(self.points))])
        return _fixed(joined)

    def _face(self, name: str) -> NodeSet:
        lies_on = np.array([name in group for group in self.facet_groups])
        return NodeSet(self, name, _where(lies_on[self.facet_group]), _NONE)

    def _feature(self, name: str) -> NodeSet:
        owns = np.array([name in owners for owners in self.cell_owners])
        return NodeSet(self, name, _NONE, _where(owns[self.tet_cells]))

    def _group(self, name: str) -> NodeSet:
        row = self._lines(_T.MESH_ARRAY_GROUP_NAMES).index(name)
        facets, tets = (self._members(array, row) for array in
                        (_T.MESH_ARRAY_GROUP_FACETS, _T.MESH_ARRAY_GROUP_TETS))
        return NodeSet(self, name, facets, tets)

    def _members(self, array: int, row: int) -> Ints:
        members: Array = self._numbers(array)
        return _fixed(np.ascontiguousarray(members[members[:, 0] == row, 1]))


def _where(mask: npt.NDArray[np.bool_]) -> Ints:
    return _fixed(np.flatnonzero(mask).astype(np.int32))


def _fixed(array: A) -> A:
    array.flags.writeable = False
    return array


_NONE: Ints = _fixed(np.empty(0, np.int32))
