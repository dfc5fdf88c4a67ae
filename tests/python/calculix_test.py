"""Solving with CalculiX."""
import shutil

import numpy as np
import pytest

from remesh_client import _loads, calculix
from remesh_client._frd import read_frd

STEEL = calculix.Elastic(210000, .3)
needs_ccx = pytest.mark.skipif(shutil.which("ccx") is None, reason="there is no ccx")
BLOCK = {"features": [{"id": "a", "nature": "ADDITIVE", "type": "block",
                       "parameters": {"dx": 10, "dy": 4, "dz": 3}}]}


@pytest.fixture(scope="module", params=[1, 2])
def block(request, daemon):
    return daemon.mesh(BLOCK, nodes=400, order=request.param).mesh()


@pytest.fixture(scope="module", params=[1, 2])
def drilled(request, daemon, cases):
    return daemon.mesh(cases / "tool1-a.json", nodes=1500, order=request.param).mesh()


def side(mesh, axis, upper):
    """The name of the block's face there."""
    place = mesh.points[:, axis].max() if upper else mesh.points[:, axis].min()
    return next(name for name, face in mesh.faces.items()
                if np.allclose(mesh.points[face.nodes][:, axis], place))


@needs_ccx
def test_a_bar_in_tension_is_as_the_theory_has_it(block):
    symmetry = {side(block, axis, False): "xyz"[axis] for axis in range(3)}
    solution = calculix.solve(block, STEEL, symmetry, {side(block, 0, True): (1200, 0, 0)})
    low = block.points.min(axis=0)
    stress = 1200 / 12
    expected = (block.all_points - low) * stress / 210000 * [1, -.3, -.3]
    assert np.allclose(solution.displacements, expected, atol=1e-4 * expected.max())
    assert np.allclose(solution.stresses, [stress, 0, 0, 0, 0, 0], atol=1e-3 * stress)
    assert np.allclose(solution.von_mises, stress, rtol=1e-3)
    assert np.isclose(solution.work, 1200 * stress / 210000 * 10, rtol=1e-4)


@needs_ccx
def test_pressure_all_round_squeezes_evenly(block):
    symmetry = {side(block, axis, False): "xyz"[axis] for axis in range(3)}
    pressed = {side(block, axis, True): calculix.Pressure(50) for axis in range(3)}
    solution = calculix.solve(block, STEEL, symmetry, pressed)
    assert np.allclose(solution.stresses[:, :3], -50, rtol=1e-3)


@needs_ccx
def test_a_support_may_be_moved(block):
    left, right = side(block, 0, False), side(block, 0, True)
    solution = calculix.solve(block, STEEL, {left: "xyz", right: {"x": .01}}, {})
    held = block.faces[left].all_nodes
    assert np.allclose(solution.displacements[block.faces[right].all_nodes][:, 0], .01)
    assert np.allclose(solution.displacements[held], 0)


@needs_ccx
def test_pure_bending_is_exact_in_second_order(block):
    """Tractions at one end, the exact displacement at the other; both functions of the place."""
    left, right = side(block, 0, False), side(block, 0, True)
    low, curvature, poisson = block.points.min(axis=0), 1e-4, .3

    def bent(points):
        x, y, z = (points - low).T
        cross = x**2 + poisson * (z**2 - y**2)
        return curvature * np.column_stack([x * z, -poisson * y * z, -cross / 2])

    solution = calculix.solve(
        block, STEEL, {left: {"xyz"[k]: lambda p, k=k: bent(p)[:, k] for k in range(3)}},
        {right: calculix.Traction(lambda p, n: 210000 * curvature * (p - low)[:, 2:] * n)})
    expected = bent(block.all_points)
    error = np.abs(solution.displacements - expected).max() / np.abs(expected).max()
    assert error < (1e-5 if block.order == 2 else .2)


def test_a_traction_along_the_normal_is_a_pressure(drilled):
    for name in ("pin1.top", "pin1.wall"):
        facets = drilled.faces[name]
        forces = _loads.traction(drilled, facets, lambda p, n: -7 * n)
        assert np.allclose(forces, _loads.pressure(drilled, facets, 7.), atol=1e-12)


def test_a_traction_that_grows_has_its_resultant_and_moment(block):
    facets = block.faces[side(block, 0, True)]
    forces = _loads.traction(block, facets, lambda p, n: p[:, 1:2]**2 * n)
    low, high = block.points[:, 1].min(), block.points[:, 1].max()
    assert np.isclose(forces[:, 0].sum(), 3 * (high**3 - low**3) / 3)
    assert np.isclose(forces[:, 0] @ block.all_points[:, 1], 3 * (high**4 - low**4) / 4)
    with pytest.raises(ValueError, match="must be finite and of the shape"):
        _loads.traction(block, facets, lambda p, n: p[:, 0])


def test_consistent_forces_add_up_to_the_load(drilled):
    total = np.array([3, -1, 2.])
    for name in ("pin1.top", "pin1.wall"):
        forces = _loads.force(drilled, drilled.faces[name], total)
        assert np.allclose(forces.sum(axis=0), total)
        loaded = np.flatnonzero(forces.any(axis=1))
        assert set(loaded) <= set(drilled.faces[name].all_nodes)
    # A pressure on all of the boundary has no resultant and no moment.
    forces = sum(_loads.pressure(drilled, _Group(drilled, k), 7.)
                 for k in range(len(drilled.facet_groups)))
    assert np.allclose(forces.sum(axis=0), 0, atol=1e-8)
    assert np.allclose(np.cross(drilled.all_points, forces).sum(axis=0), 0, atol=1e-6)


class _Group:
    """The facets of one group, of which each facet has one."""

    def __init__(self, mesh, group):
        self.name = str(group)
        self.facet_indices = np.flatnonzero(mesh.facet_group == group)
        self.facets = mesh.facets[self.facet_indices]
        self.facets6 = mesh.facets6[self.facet_indices] if mesh.order == 2 else None


def test_corners_of_plane_facets_of_second_order_bear_nothing(block):
    name = side(block, 0, True)
    forces = _loads.force(block, block.faces[name], np.array([1., 0, 0]))
    corners = forces[:len(block.points), 0]
    if block.order == 2:
        assert np.abs(corners).max() < 1e-14
    else:
        assert np.isclose(corners.sum(), 1)


@needs_ccx
def test_what_ccx_says_is_told(block, tmp_path):
    left, right = side(block, 0, False), side(block, 0, True)
    with pytest.raises(calculix.CalculixError, match="longer than"):
        calculix.solve(block, STEEL, {left: "xyz"}, {right: (1, 0, 0)}, limit=.001)
    refusing = tmp_path / "ccx"
    refusing.write_text("#!/bin/sh\necho '*ERROR in e_c3d: nonpositive jacobian'\n"
                        "echo '       determinant in element 7'\nexit 201\n")
    refusing.chmod(0o755)
    with pytest.raises(calculix.CalculixError, match="jacobian determinant in element 7") as told:
        calculix.solve(block, STEEL, {left: "xyz"}, {right: (1, 0, 0)}, program=refusing)
    assert "nonpositive" in told.value.output


def test_bad_input_is_told_before_anything_runs(block):
    left, right = side(block, 0, False), side(block, 0, True)
    with pytest.raises(KeyError, match="no group or face 'top'.*there are: a"):
        calculix.solve(block, STEEL, {"top": "xyz"}, {})
    with pytest.raises(ValueError, match="three finite numbers, a Pressure or a Traction"):
        calculix.solve(block, STEEL, {left: "xyz"}, {right: (1, 2)})
    with pytest.raises(ValueError, match="directions out of 'xyz'"):
        calculix.solve(block, STEEL, {left: "abc"}, {})
    with pytest.raises(ValueError, match="finite and of the shape"):
        calculix.solve(block, STEEL, {left: {"x": lambda points: points}}, {})
    with pytest.raises(ValueError, match="poisson between"):
        calculix.solve(block, calculix.Elastic(1, .5), {left: "xyz"}, {})
    with pytest.raises(ValueError, match="without a support"):
        calculix.solve(block, STEEL, {}, {right: (1, 0, 0)})
    with pytest.raises(calculix.CalculixError, match="calculix-ccx"):
        calculix.solve(block, STEEL, {left: "xyz"}, {}, program="/nonexistent/ccx")


def test_a_file_of_results_is_read(tmp_path):
    file = tmp_path / "a.frd"
    file.write_text(" -4  DISP        4    1\n -5  D1          1    2    1    0\n"
                    " -1         1 1.00000E+00-2.50000E-01 3.00000-101\n"
                    " -1         3 0.00000E+00 0.00000E+00 0.00000E+00\n -3\n"
                    " -4  OTHER       4    1\n -1         1 1.00000E+00\n -3\n")
    fields = read_frd(file, 3)
    assert list(fields) == ["DISP"]
    assert fields["DISP"][0].tolist() == [1, -.25, 3e-101]
    assert np.isnan(fields["DISP"][1]).all() and (fields["DISP"][2] == 0).all()
