#!/usr/bin/env python3
"""check_step.py REMESH: the exact model as a STEP file, as Gmsh reads it.

Exit 0 where all is well.
"""
import json
import re
import sys
import tempfile
from pathlib import Path

import gmsh
import meshio
import numpy as np

from commands import mesh_bracket, run

CLI = Path(sys.argv[1])


def by_gmsh(file):
    """Volume and box of the one solid, and its number of faces."""
    gmsh.clear()
    gmsh.model.occ.importShapes(str(file))
    gmsh.model.occ.synchronize()
    solids = gmsh.model.getEntities(3)
    assert len(solids) == 1, solids
    return (gmsh.model.occ.getMass(*solids[0]),
            np.reshape(gmsh.model.getBoundingBox(*solids[0]), (2, 3)),
            len(gmsh.model.getEntities(2)))


def check(step, report, mesh):
    volume, box, faces = by_gmsh(step)
    exact = json.loads(report.read_text())
    assert abs(volume / exact["exact_volume"] - 1) < 1e-9, volume
    points = meshio.read(mesh).points
    assert np.abs(box - [points.min(axis=0), points.max(axis=0)]).max() < 1e-3, box
    names = re.findall(r"ADVANCED_FACE\('([^']+)'", step.read_text())
    assert len(names) == faces, names
    return set(names)


def check_commands(folder):
    mesh_bracket(CLI, folder, "--size", "8", "-o", "part.msh", "-o", "part.step", "--json",
                 "part.report", "--design", "part")
    names = check(folder / "part.step", folder / "part.report", folder / "part.msh")
    assert len(names) > 10 and all("." in name for name in names), names
    # Of the stored revision, under the other ending, to stdout: the same bytes.
    run(CLI, folder, "remesh", "get", "part", "-o", "again.stp")
    text = (folder / "part.step").read_text()
    assert (folder / "again.stp").read_text() == text
    assert run(CLI, folder, "remesh", "get", "part", "-o", "-", "--format", "step") == text
    run(CLI, folder, "remesh", "example", "bracket.edit", "-o", "bracket.edit.json")
    run(CLI, folder, "remesh", "edit", "part", "bracket.edit.json", "-o", "edited.step", "-o",
        "edited.vtu", "--json", "edited.report")
    check(folder / "edited.step", folder / "edited.report", folder / "edited.vtu")
    edited = (folder / "edited.step").read_text()
    assert edited != text
    ids = re.search(r"revision ([0-9a-f]{64})','edited from ([0-9a-f]{64})'", edited).groups()
    assert ids[1] in text.split("DATA;")[0] and f"FILE_NAME('{ids[0]}.step'" in edited


def main():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    with tempfile.TemporaryDirectory() as name:
        check_commands(Path(name))
    gmsh.finalize()


main()
