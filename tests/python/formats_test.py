"""Meshes as other programs have them."""
import subprocess
import sys

import numpy as np
import pytest

meshio = pytest.importorskip("meshio")


@pytest.fixture(scope="module", params=[1, 2])
def mesh(request, daemon, cases):
    part = daemon.mesh(cases / "tool1-a.json", nodes=700, order=request.param)
    return part.edit(pin_radius=5).mesh()


def test_meshio_has_tets_facets_and_sets(mesh, tmp_path):
    made = mesh.to_meshio()
    assert [block.type for block in made.cells] == (
        ["tetra", "triangle"] if mesh.order == 1 else ["tetra10", "triangle6"])
    assert np.array_equal(made.points, mesh.all_points)
    wall = mesh.faces["pin1.wall"]
    assert np.array_equal(made.cell_sets["pin1.wall"][1], wall.facet_indices)
    assert np.array_equal(made.point_data["parent_node"][:len(mesh.points)], mesh.parent_nodes)
    made.write(tmp_path / "a.vtu")
    assert np.array_equal(meshio.read(tmp_path / "a.vtu").points, mesh.all_points)


def test_vtk_has_what_the_daemons_file_has(mesh, tmp_path):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(mesh.write(tmp_path / "a.vtu")))
    reader.Update()
    file, made = reader.GetOutput(), mesh.to_vtk()
    cells = len(mesh.tets) + len(mesh.facets)
    assert made.GetNumberOfCells() == file.GetNumberOfCells() == cells
    assert np.array_equal(vtk_to_numpy(made.GetPoints().GetData()), mesh.all_points)
    assert np.array_equal(vtk_to_numpy(made.GetCells().GetConnectivityArray()),
                          vtk_to_numpy(file.GetCells().GetConnectivityArray()))
    assert all(made.GetCellType(k) == file.GetCellType(k) for k in (0, cells - 1))
    for data in ("GetPointData", "GetCellData", "GetFieldData"):
        ours, theirs = getattr(made, data)(), getattr(file, data)()
        for k in range(ours.GetNumberOfArrays()):
            name = ours.GetArrayName(k)
            other = theirs.GetArray(name)
            assert other is not None, name
            a, b = vtk_to_numpy(ours.GetArray(k)), vtk_to_numpy(other)
            assert np.array_equal(np.sort(a) if data == "GetFieldData" else a, b), name


def test_vtk_meshio_and_scipy_are_imported_only_where_they_are_needed():
    program = ("import sys, remesh_client as rc; rc.aio, rc.calculix.solve; "
               "print([m for m in ('vtkmodules', 'meshio', 'scipy') if m in sys.modules])")
    out = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, check=True)
    assert out.stdout.strip() == "[]"
