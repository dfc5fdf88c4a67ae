#!/usr/bin/env python3
"""write_by_others.py RAW: writes the mesh whose arrays lie raw in the folder RAW there, in each way
that meshio and VTK have of doing so, each in a file named after the way."""
import sys
from pathlib import Path

import meshio
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkCellArray, vtkUnstructuredGrid
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridWriter


def write_by_meshio(folder, points, tets):
    only_tets = meshio.Mesh(points, [("tetra", tets)])
    # Triangles too, which a reader of tets passes over; meshio does not write them for Gmsh.
    mixed = meshio.Mesh(points, [("triangle", tets[:5, :3]), ("tetra", tets)])
    for name, options in {
        "meshio-ascii.vtu": {"binary": False},
        "meshio-base64.vtu": {"compression": None},
        "meshio-base64-zlib.vtu": {"compression": "zlib"},
        "meshio-base64-wide.vtu": {"compression": "zlib", "header_type": "UInt64"},
        "meshio-ascii.msh": {"binary": False, "float_fmt": ".17g"},
        "meshio-binary.msh": {"binary": True},
        "meshio.inp": {"float_fmt": ".17g"},
    }.items():
        if name.endswith(".msh"):
            meshio.write(folder / name, only_tets, file_format="gmsh", **options)
        else:
            meshio.write(folder / name, mixed, **options)


def write_by_vtk(folder, points, tets):
    grid, places, cells = vtkUnstructuredGrid(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(points, deep=True))
    grid.SetPoints(places)
    for tet in tets.tolist():
        cells.InsertNextCell(4, tet)
    grid.SetCells(VTK_TETRA, cells)

    def write(name, *settings, pieces=1):
        writer = vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid)
        writer.SetFileName(str(folder / name))
        writer.SetBlockSize(1000)  # so that compressed arrays have several, and a shorter last one
        # VTK writes the whole grid in each piece.
        writer.SetNumberOfPieces(pieces)
        for setting in settings:
            setting(writer)
        assert writer.Write() == 1, name

    kind = vtkXMLUnstructuredGridWriter
    modes = {
        "ascii": [kind.SetDataModeToAscii],
        "inline": [kind.SetDataModeToBinary],
        "base64": [kind.SetDataModeToAppended, kind.EncodeAppendedDataOn],
        "raw": [kind.SetDataModeToAppended, kind.EncodeAppendedDataOff],
    }
    for mode, settings in modes.items():
        write(f"vtk-{mode}.vtu", *settings, kind.SetCompressorTypeToNone)
        write(f"vtk-{mode}-wide.vtu", *settings, kind.SetCompressorTypeToNone,
              kind.SetHeaderTypeToUInt64)
        write(f"vtk-{mode}-pieces.vtu", *settings, kind.SetCompressorTypeToNone, pieces=2)
        if mode != "ascii":
            write(f"vtk-{mode}-zlib.vtu", *settings, kind.SetCompressorTypeToZLib)
            write(f"vtk-{mode}-zlib-pieces.vtu", *settings, kind.SetCompressorTypeToZLib, pieces=2)


def main():
    folder = Path(sys.argv[1])
    points = np.fromfile(folder / "points", "<f8").reshape(-1, 3)
    tets = np.fromfile(folder / "tets", "<i4").reshape(-1, 4)
    write_by_meshio(folder, points, tets)
    write_by_vtk(folder, points, tets)


main()
