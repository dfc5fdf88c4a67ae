#!/usr/bin/env python3
"""check_gmsh.py REMESH: Gmsh reads our .msh whole, without a complaint, in both orders.

Exit 0 where all is well.
"""
import json
import sys
import tempfile
from pathlib import Path

import gmsh
import numpy as np

from commands import mesh_bracket

CLI = Path(sys.argv[1])
ORDERS = {1: (2, 4), 2: (9, 11)}  # types of triangles and tets
SIDES = [(0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)]


def elements(kind):
    tags, nodes = gmsh.model.mesh.getElementsByType(kind)
    return tags, nodes.reshape(len(tags), -1)


def sides_of(tets):
    """All sides of tets, as rows of three node tags that ascend."""
    return np.sort(np.vstack([tets[:, side] for side in SIDES]), axis=1)


def check(folder, order):
    report = folder / "report.json"
    mesh_bracket(CLI, folder, "--size", 6, "--order", order, "-o", "part.msh", "--json", report)
    report = json.loads(report.read_text())
    gmsh.logger.start()
    gmsh.open(str(folder / "part.msh"))
    complaints = [line for line in gmsh.logger.get() if not line.startswith("Info")]
    gmsh.logger.stop()
    assert not complaints, complaints
    triangle, tet = ORDERS[order]
    assert set(gmsh.model.mesh.getElementTypes()) == {triangle, tet}
    node_tags = gmsh.model.mesh.getNodes()[0]
    assert len(node_tags) == len(set(node_tags)) == report["nodes"] + report["mid_nodes"]
    tags, tets = elements(tet)
    facet_tags, facets = elements(triangle)
    assert len(tags) == report["tets"] and not set(tags) & set(facet_tags)
    assert set(np.concatenate([tets.ravel(), facets.ravel()])) == set(node_tags)
    places, weights = gmsh.model.mesh.getIntegrationPoints(tet, "Gauss4")
    determinants = gmsh.model.mesh.getJacobians(tet, places)[1].reshape(len(tags), len(weights))
    assert (determinants > 0).all()
    volume = (determinants @ weights).sum()
    # Report.volume is that of the corners.
    wanted, most = (report["volume"], 1e-9) if order == 1 else (report["exact_volume"], 1e-5)
    assert abs(volume / wanted - 1) < most, (volume, wanted)
    # The triangles are the sides that one tet alone has.
    sides, counts = np.unique(sides_of(tets[:, :4]), axis=0, return_counts=True)
    boundary = np.unique(np.sort(facets[:, :3], axis=1), axis=0)
    assert (sides[counts == 1] == boundary).all() and counts.max() == 2
    check_groups(facet_tags, tags)


def check_groups(facet_tags, tet_tags):
    """Physical groups: each has a name of its own, and every element is in one of them."""
    groups = gmsh.model.getPhysicalGroups()
    names = [gmsh.model.getPhysicalName(*group) for group in groups]
    assert len(set(names)) == len(names) == 27
    assert {"hole.wall", "rib.side2", "pipe", "load", "supports"} <= set(names)
    covered = {2: set(), 3: set()}
    for dim, group in groups:
        for entity in gmsh.model.getEntitiesForPhysicalGroup(dim, group):
            for found in gmsh.model.mesh.getElements(dim, entity)[1]:
                covered[dim].update(found)
    assert covered == {2: set(facet_tags), 3: set(tet_tags)}


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    with tempfile.TemporaryDirectory() as name:
        for order in ORDERS:
            check(Path(name), order)
    gmsh.finalize()


main()
