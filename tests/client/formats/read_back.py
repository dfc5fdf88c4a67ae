#!/usr/bin/env python3
"""read_back.py MESH RAW: reads MESH with libraries that know nothing of remeshd and compares it,
bit for bit, with the arrays that the test wrote raw into the folder RAW. Exit 0 where all agree."""
import json
import sys
from pathlib import Path

import meshio
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader


def raw(folder, name, dtype, width=None):
    values = np.fromfile(folder / name, dtype)
    return values.reshape(-1, width) if width else values


def same(what, got, wanted):
    got, wanted = np.ascontiguousarray(got), np.ascontiguousarray(wanted)
    assert got.shape == wanted.shape, f"{what}: {got.shape} instead of {wanted.shape}"
    if got.dtype.kind == "f":
        got, wanted = got.view(np.uint64), wanted.view(np.uint64)
    assert (got == wanted).all(), f"{what} differs"


def facets_of(nodes):
    return sorted(tuple(sorted(int(n) for n in f)) for f in nodes)


def check_sizes(mesh, want):
    """Edge lengths aimed at, of a mesh that is not even."""
    if len(want["size"]):
        same("size", mesh.point_data["size"].ravel(), want["size"])
    else:
        assert "size" not in mesh.point_data


def check_vtu_groups(mesh, want):
    """Of tets and facets, 1 where they are in the group; none of a group that has nothing."""
    for name in want["groups"]:
        for k, block in enumerate(("tets", "facets")):
            members = want["members"](name)[block]
            got = np.flatnonzero(mesh.cell_data["group:" + name][k])
            same(name, got, np.array(members, got.dtype))


def check_vtu(file, mesh, want):
    assert [c.type for c in mesh.cells] == [want["tet_type"], want["facet_type"]]
    data = {name: arrays[0] for name, arrays in mesh.cell_data.items()}
    same("tets", mesh.cells[0].data, want["tets"])
    facets = mesh.cells[1].data
    same("facets", facets[:, :3], want["facets"][:, :3])
    if facets.shape[1] == 6:
        check_facet_mids(facets, want)
    same("face", mesh.cell_data["face"][1], want["facets"][:, 4])
    assert (mesh.cell_data["face"][0] == -1).all()
    check_vtu_groups(mesh, want)
    same("origin", mesh.point_data["origin"], want["origin"])
    same("original_node", mesh.point_data["original_node"], want["original_node"])
    same("node_id", mesh.point_data["node_id"], want["node_id"])
    check_sizes(mesh, want)
    same("original_tet", data["original_tet"], want["original_tet"])
    same("kept", data["kept"], (want["original_tet"] >= 0).astype(np.uint8))
    same("tet_id", data["tet_id"], want["tet_id"])
    same("cell", data["cell"], want["cell"])
    for owner in {o for owners in want["cell_owners"] for o in owners}:
        owned = [owner in want["cell_owners"][c] for c in want["cell"]]
        same(owner, data["owner:" + owner], np.array(owned, np.uint8))
    names = {n for group in want["facet_groups"] for n in group}
    for name in names:
        groups = set(int(g) for g in mesh.field_data["face:" + name])
        got = [np.delete(tet, corner)
               for tet, sides in zip(mesh.cells[0].data[:, :4], data["facet_groups"])
               for corner in range(4) if int(sides[corner]) in groups]
        assert facets_of(got) == want["facets_on"](name), name
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    grid = reader.GetOutput()
    tets = len(want["tets"])
    assert grid.GetNumberOfCells() == tets + len(facets)
    same("VTK points", vtk_to_numpy(grid.GetPoints().GetData()), want["points"])
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    same("VTK tets", connectivity[:want["tets"].size].reshape(want["tets"].shape), want["tets"])
    same("VTK facets", connectivity[want["tets"].size:].reshape(facets.shape), facets)
    types = {"tetra": 10, "tetra10": 24, "triangle": 5, "triangle6": 22}
    assert vtk_to_numpy(grid.GetCellTypesArray()).tolist() == \
        [types[want["tet_type"]]] * tets + [types[want["facet_type"]]] * len(facets)
    same("VTK tet_id", vtk_to_numpy(grid.GetCellData().GetArray("tet_id"))[:tets], want["tet_id"])


def check_facet_mids(facets, want):
    """Mid-nodes stand on the edges 01 12 20 of their facet."""
    for facet in facets:
        for k in range(3):
            edge = sorted((facet[k], facet[(k + 1) % 3]))
            assert list(want["edge_mids"][facet[3 + k] - want["corners"]]) == edge


def check_msh_groups(mesh, want):
    """By their nodes, for entities that groups have cut in parts come one after the other."""
    groups = {name: want["members"](name) for name in want["groups"]}
    for name, members in groups.items():
        for block, type_, width in (("facets", want["facet_type"], 3), ("tets", want["tet_type"], 4)):
            wanted = facets_of(want[block][k][:width] for k in members[block])
            sets = mesh.cell_sets.get(name, [[]] * len(mesh.cells))
            got = facets_of(row[:width] for cells, chosen in zip(mesh.cells, sets)
                            if cells.type == type_ for row in cells.data[chosen])
            # Of a name that facets and tets have, meshio knows one.
            if not wanted or mesh.field_data[name][1] == width - 1:
                assert got == wanted, name


def check_msh(file, mesh, want):
    check_sizes(mesh, want)
    if not want["groups"]:
        tets = [c for c in mesh.cells if c.type == want["tet_type"]]
        assert len(tets) == len(want["cell_owners"])
        for cell, block in enumerate(tets):
            same("tets of a cell", block.data, want["tets"][want["cell"] == cell])
    check_msh_groups(mesh, want)
    for dimension, type_, groups in ((2, want["facet_type"], want["facet_groups"]),
                                     (3, want["tet_type"], want["cell_owners"])):
        for name in {n for group in groups for n in group} | {"+".join(g) for g in groups}:
            tag, dim = mesh.field_data[name]
            assert dim == dimension
            got = [block.data[members] for block, members in zip(mesh.cells, mesh.cell_sets[name])
                   if block.type == type_ and len(members)]
            if dimension == 2 and type_ == "triangle6":
                check_facet_mids(np.vstack(got), want)
            got = facets_of(np.vstack(got)[:, :dimension + 1])
            if dimension == 2:
                wanted = want["facets_on"](name)
            else:
                wanted = facets_of(t[:4] for t, c in zip(want["tets"], want["cell"])
                                   if set(name.split("+")) <= set(want["cell_owners"][c]))
            assert got == wanted, name


def abaqus_sides(tet):
    """Node sets of S1..S4 of a C3D4, Abaqus Elements Guide 28.1.4."""
    a, b, c, d = (int(n) for n in tet)
    return {"S1": (a, b, c), "S2": (a, d, b), "S3": (b, d, c), "S4": (c, d, a)}


def check_inp(file, mesh, want):
    assert len(mesh.cells) == 1 and mesh.cells[0].type == want["tet_type"]
    same("tets", mesh.cells[0].data, want["tets"])
    p = want["points"]
    a, b, c, d = (p[want["tets"][:, k]] for k in range(4))
    assert (np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) > 0).all()
    for owner in {o for owners in want["cell_owners"] for o in owners}:
        owned = [t for t, c in enumerate(want["cell"]) if owner in want["cell_owners"][c]]
        same(owner, mesh.cell_sets[owner][0], np.array(owned, np.int32))
    # meshio passes surfaces over: read them here.
    surfaces, name = {}, None
    for line in file.read_text().splitlines():
        if line.startswith("*SURFACE"):
            fields = dict(f.strip().split("=") for f in line.split(",")[1:])
            assert fields["TYPE"] == "ELEMENT"
            name = fields["NAME"]
        elif line.startswith("*"):
            name = None
        elif name:
            element, side = (f.strip() for f in line.split(","))
            nodes = abaqus_sides(want["tets"][int(element) - 1, :4])[side]
            surfaces.setdefault(name, []).append(nodes)
    same("remesh_all", mesh.cell_sets["remesh_all"][0], np.arange(len(want["tets"]), dtype=np.int32))
    same("remesh_all", mesh.point_sets["remesh_all"], np.arange(len(p), dtype=np.int32))
    for group in want["groups"]:
        members = want["members"](group)
        if members["tets"]:
            same(group, mesh.cell_sets[group][0], np.array(members["tets"], np.int32))
        assert (group in surfaces) == bool(members["facets"])
    wanted_on = {n: want["facets_on"](n) for group in want["facet_groups"] for n in group}
    wanted_on |= {n: facets_of(want["facets"][f][:3] for f in want["members"](n)["facets"])
                  for n in want["groups"] if want["members"](n)["facets"]}
    for face, wanted in wanted_on.items():
        label = face.replace(".", "_")
        assert facets_of(surfaces[label]) == wanted, face
        nodes = np.unique(np.array(wanted)).astype(np.int32)
        assert set(nodes) <= set(mesh.point_sets[label])
        # Of the mid-nodes those whose edge has both ends there, and is one of a facet.
        edges = {tuple(sorted((f[k], f[(k + 1) % 3]))) for f in wanted for k in range(3)}
        mids = [m + want["corners"] for m, e in enumerate(want["edge_mids"]) if tuple(e) in edges]
        same(label, mesh.point_sets[label], np.concatenate([nodes, mids]).astype(np.int32))


def add_mids(folder, want):
    """Mid-nodes come after all corners; there are none in a mesh of first order."""
    want["corners"] = len(want["points"])
    want["edge_mids"] = raw(folder, "edge_mids", "<i4", 2)
    second = len(want["edge_mids"]) > 0
    want["tet_type"] = "tetra10" if second else "tetra"
    want["facet_type"] = "triangle6" if second else "triangle"
    if not second:
        return
    mids = raw(folder, "tet_mids", "<i4", 6) + want["corners"]
    want["tets"] = np.hstack([want["tets"], mids.astype("<i4")])
    if len(want["size"]):
        ends = want["size"][want["edge_mids"]]
        want["size"] = np.concatenate([want["size"], 0.5 * (ends[:, 0] + ends[:, 1])])
    want["points"] = np.vstack([want["points"], raw(folder, "mid_points", "<f8", 3)])
    for name, dtype in (("origin", "u1"), ("node_id", "<u8")):
        want[name] = np.concatenate([want[name], raw(folder, "mid_" + name, dtype)])
    originals = raw(folder, "original_mid_node", "<i4")
    want["original_node"] = np.concatenate([want["original_node"], originals])


def main():
    file, folder = Path(sys.argv[1]), Path(sys.argv[2])
    want = {
        "points": raw(folder, "points", "<f8", 3),
        "tets": raw(folder, "tets", "<i4", 4),
        "origin": raw(folder, "origin", "u1"),
        "original_node": raw(folder, "original_node", "<i4"),
        "node_id": raw(folder, "node_id", "<u8"),
        "size": raw(folder, "size", "<f8"),
        "original_tet": raw(folder, "original_tet", "<i4"),
        "tet_id": raw(folder, "tet_id", "<u8"),
        "cell": raw(folder, "cell", "<i4"),
    }
    add_mids(folder, want)
    want.update(json.loads((folder / "names.json").read_text()))
    facets = want["facets"] = raw(folder, "facets", "<i4", 8)
    want["groups"] = want["groups"][0]
    in_group = {block: raw(folder, "group_" + block, "<i4", 2) for block in ("facets", "tets")}

    def members(name):
        """Facets and tets of a group of the model."""
        index = want["groups"].index(name)
        return {block: [int(k) for g, k in pairs if g == index] for block, pairs in in_group.items()}

    want["members"] = members

    def facets_on(name):
        """The facets that lie on all the faces that are joined in `name`."""
        on = [set(name.split("+")) <= set(g) for g in want["facet_groups"]]
        return facets_of(f[:3] for f in facets if on[f[4]])

    want["facets_on"] = facets_on
    mesh = meshio.read(file)
    same("points", mesh.points, want["points"])
    {".vtu": check_vtu, ".msh": check_msh, ".inp": check_inp}[file.suffix](file, mesh, want)


main()
