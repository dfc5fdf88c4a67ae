#!/usr/bin/env python3
"""check_conversions.py REMESH FORMATS.md: runs the commands of the page; its table holds.

Exit 0 where all is well.
"""
import re
import sys
import tempfile
from pathlib import Path

import gmsh
import meshio
import numpy as np

from commands import run

CLI, PAGE = (Path(p) for p in sys.argv[1:3])
TETS = {4, 11}  # types of Gmsh


def by_gmsh(file):
    """Points in the order of their tags, numbers of tets and their nodes, names of groups."""
    gmsh.open(str(file))
    tags, points, _ = gmsh.model.mesh.getNodes()
    points = points.reshape(-1, 3)[np.argsort(tags)]
    tets = {kind: len(elements) for kind, elements, _ in zip(*gmsh.model.mesh.getElements())
            if kind in TETS}
    names = {gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()}
    return points, tets, names - {""}


def by_meshio(file):
    mesh = meshio.read(file)
    return mesh.points, {block.type: len(block.data) for block in mesh.cells}, mesh


def difference(points, others):
    assert points.shape == others.shape
    return np.abs(points - others).max()


def check_gmsh_formats(folder):
    for stem in ("part", "second"):
        points, tets, names = by_gmsh(folder / f"{stem}.msh")
        assert len(names) == 27 and {"load", "supports"} <= names, names
        for name, most in ((f"{stem}.unv", 0), (f"{stem}-22.msh", 1.5e-14)):
            others, other_tets, other_names = by_gmsh(folder / name)
            assert difference(points, others) <= most, name
            assert (other_tets, other_names) == (tets, names), name
    points, tets, _ = by_gmsh(folder / "part.msh")
    others, other_tets, names = by_gmsh(folder / "part.bdf")
    assert 1e-9 < difference(points, others) <= 5.1e-8 and other_tets == tets and not names
    # Nastran's ten nodes stand in the file; Gmsh reads four.
    text = (folder / "second.bdf").read_text()
    _, tets, _ = by_gmsh(folder / "second.msh")
    assert len(re.findall(r"^CTETRA .*\n {8}\S.*$", text, re.M)) == tets[11]
    assert by_gmsh(folder / "second.bdf")[1] == {4: tets[11]}
    # Features by the number of the property.
    properties = set(re.findall(r"^CTETRA  \d+ +(\d+)", (folder / "part.bdf").read_text(), re.M))
    assert len(properties) == 4, properties


def check_meshio_formats(folder):
    for stem, kind in (("part", "tetra"), ("second", "tetra10")):
        points, cells, _ = by_meshio(folder / f"{stem}.inp")
        others, other_cells, med = by_meshio(folder / f"{stem}.med")
        assert difference(points, others) == 0 and other_cells == cells and set(cells) == {kind}
        assert not med.cell_tags and not med.point_tags
    points, cells, _ = by_meshio(folder / "part.inp")
    others, other_cells, _ = by_meshio(folder / "bulk.bdf")
    assert 1e-6 < difference(points, others) <= 1e-4 and other_cells == cells
    _, _, named = by_meshio(folder / "named.med")
    _, _, names = by_gmsh(folder / "part.msh")
    assert {name for family in named.cell_tags.values() for name in family} == names
    tags = {block.type: np.unique(tags) for block, tags in
            zip(named.cells, named.cell_data["cell_tags"])}
    assert (len(tags["triangle"]), len(tags["tetra"])) == (23, 4), tags


def main():
    commands = "".join(re.findall(r"^```sh\n(.*?)^```$", PAGE.read_text(), re.M | re.S))
    assert commands.count("\n") > 20
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 2)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run(CLI, folder, "bash", "-euo", "pipefail", "-c", commands)
        check_gmsh_formats(folder)
        check_meshio_formats(folder)
    gmsh.finalize()


main()
