"""Design velocities, gradients, horizons; derivatives of solutions by the parameters of a model."""
import asyncio

import numpy as np
import pytest

import remesh_client as rc
from remesh_client import aio, calculix

STEEL = calculix.Elastic(210000, .3)
SUPPORTS = {"base.bottom": "xyz"}
LOADS = {"pipe_outer.top": (300.0, 0, -1000)}


@pytest.fixture(scope="module", params=[1, 2])
def part(request, daemon, cases):
    return daemon.mesh(cases / "tool2-a.json", nodes=800, order=request.param, hold=1)


@pytest.fixture(scope="module")
def solved(part):
    return calculix.solve(part.mesh(), STEEL, SUPPORTS, LOADS)


def moved(mesh, by):
    """The same mesh with nodes elsewhere, as far as derivatives look."""
    class Moved:
        tets, order, groups, faces = mesh.tets, mesh.order, mesh.groups, mesh.faces
        tets10 = mesh.tets10 if mesh.order == 2 else None
        exact_areas = mesh.exact_areas
        all_points = mesh.all_points + by
    return Moved()


def along(function, mesh, by, step=1e-5):
    """Central difference of a function of a mesh."""
    return (function(moved(mesh, step * by)) - function(moved(mesh, -step * by))) / (2 * step)


def test_velocities_come_for_every_node_and_parameter(part):
    found = part.velocities("pipe_x", "pipe_outer.radius")
    assert list(found) == ["pipe_x", "pipe_outer.radius"]
    assert found["pipe_x"].value == 15 and found["pipe_outer.radius"].value == 16
    for velocity in found.values():
        assert velocity.vectors.shape == part.mesh().all_points.shape
        assert not velocity.undefined.any()
    wall = part.mesh().faces["pipe_outer.wall"].nodes
    points = part.mesh().points[wall]
    normals = (points - [15, 0, 0]) / 16
    normals[:, 2] = 0
    speed = np.einsum("kc,kc->k", found["pipe_x"].vectors[wall], normals)
    assert np.allclose(speed, normals[:, 0], atol=1e-8)
    speed = np.einsum("kc,kc->k", found["pipe_outer.radius"].vectors[wall], normals)
    assert np.allclose(speed, 1, atol=1e-8)


def test_all_parameters_of_the_model_are_the_default(part):
    assert list(part.velocities()) == ["pipe_x"]
    assert list(part.gradient(np.zeros_like(part.mesh().all_points))) == ["pipe_x"]


def test_gradient_is_the_seed_times_the_velocities(part):
    seed = np.random.default_rng(1).normal(size=part.mesh().all_points.shape)
    gradient = part.gradient(seed, "pipe_x", "pipe_outer.radius")
    for name, velocity in part.velocities("pipe_x", "pipe_outer.radius").items():
        assert gradient[name] == pytest.approx((seed * velocity.vectors).sum(), rel=1e-6, abs=1e-6)
        assert gradient[name].undefined == 0


def test_nodes_where_faces_part_are_told(part):
    velocity = part.velocities("base.dz")["base.dz"]
    assert velocity.undefined.any()
    assert part.gradient(np.ones_like(velocity.vectors), "base.dz")["base.dz"].undefined > 0


def test_what_is_no_parameter_is_named(part):
    for name in ("nothing", "base.nothing", "nothing.dz"):
        with pytest.raises(rc.RemeshError, match="nothing"):
            part.velocities(name)
    with pytest.raises(rc.InvalidRequest, match="seed"):
        part.gradient(np.zeros((7, 3)))
    with pytest.raises(ValueError, match="seed"):
        part.gradient(np.zeros(7))
    with pytest.raises(rc.InvalidRequest, match="hold"):
        part.horizon("pipe_x", hold=11)


def test_horizon_tells_how_far_connectivity_goes(part):
    horizon = part.horizon("pipe_x")["pipe_x"]
    length = part.report.edge_length
    assert horizon.lower < 15 - .5 * length and horizon.upper > 15 + .5 * length
    assert horizon.lower_reason and horizon.upper_reason
    held = part.edit(pipe_x=horizon.upper)
    assert np.array_equal(held.mesh().tets, part.mesh().tets)
    assert not [warning for warning in held.warnings if warning.code == "HOLD_ENDED"]
    further = part.edit(pipe_x=15 + 1.5 * (horizon.upper - 15))
    assert [warning for warning in further.warnings if warning.code == "HOLD_ENDED"]
    short = part.horizon("pipe_x", hold=0)["pipe_x"]
    assert 15 < short.upper <= 15 + .011 * length


def test_asyncio_has_the_same(remeshd, cases):
    async def ask():
        async with aio.local(remeshd) as daemon:
            part = await daemon.mesh(cases / "tool2-a.json", nodes=400)
            velocity = (await part.velocities("pipe_x"))["pipe_x"]
            seed = np.ones_like(velocity.vectors)
            gradient = await part.gradient(seed, "pipe_x")
            assert gradient["pipe_x"] == pytest.approx(velocity.vectors.sum(), rel=1e-6)
            assert (await part.horizon("pipe_x", hold=.1))["pipe_x"].upper > 15
    asyncio.run(ask())


def test_volume_follows_the_nodes(part):
    mesh = part.mesh()
    by = np.random.default_rng(2).normal(size=mesh.all_points.shape)
    volume, gradient = rc.adjoint.volume(mesh)
    assert volume == pytest.approx(part.report.exact_volume, rel=.02)
    found = along(lambda m: rc.adjoint.volume(m)[0], mesh, by)
    assert (gradient * by).sum() == pytest.approx(found, rel=1e-5)


def test_strain_energy_is_half_the_work_and_follows_the_nodes(part, solved):
    mesh = part.mesh()
    by = np.random.default_rng(3).normal(size=mesh.all_points.shape)
    energy, gradient = rc.adjoint.strain_energy(mesh, solved.displacements, STEEL)
    assert 2 * energy == pytest.approx(solved.work, rel=1e-5)
    found = along(lambda m: rc.adjoint.strain_energy(m, solved.displacements, STEEL)[0], mesh, by)
    assert (gradient * by).sum() == pytest.approx(found, rel=1e-4)


def test_stress_norm_follows_displacements_nodes_and_weights(part, solved):
    mesh, u = part.mesh(), solved.displacements
    random = np.random.default_rng(4)
    weights = random.uniform(.5, 1, len(mesh.tets))

    def norm(m, displacements=u, by_tet=weights):
        return rc.adjoint.stress_norm(m, displacements, STEEL, 8, by_tet)
    stress = norm(mesh)
    assert .3 * solved.von_mises.max() < stress.value < solved.von_mises.max() * 1.5
    by = random.normal(size=u.shape)
    assert (stress.by_node * by).sum() == pytest.approx(
        along(lambda m: norm(m).value, mesh, by), rel=1e-4)
    turn = 1e-2 * np.abs(u).max() * by
    found = (norm(mesh, u + 1e-3 * turn).value - norm(mesh, u - 1e-3 * turn).value) / 2e-3
    assert (stress.by_displacement * turn).sum() == pytest.approx(found, rel=1e-4)
    more = 1e-4 * random.normal(size=len(mesh.tets))
    found = (norm(mesh, u, weights + more).value - norm(mesh, u, weights - more).value) / 2
    assert stress.by_weight @ more == pytest.approx(found, rel=1e-4)


@pytest.mark.parametrize("parameter, value", [("pipe_x", 15), ("pipe_outer.radius", 16)])
def test_gradients_of_solutions_are_those_of_held_meshes(part, solved, parameter, value):
    mesh = part.mesh()
    _, compliance = rc.adjoint.compliance(mesh, solved, STEEL, LOADS)
    stress = rc.adjoint.stress_norm(mesh, solved.displacements, STEEL, 8)
    adjoint = calculix.solve(mesh, STEEL, SUPPORTS, {}, forces=stress.by_displacement)
    by_node = rc.adjoint.sensitivity(mesh, solved, adjoint, STEEL, LOADS, stress.by_node)
    step = .02 * part.report.edge_length
    work, norms = [], []
    for side in (-1, 1):
        held = part.edit({parameter: value + side * step}).mesh()
        assert np.array_equal(held.tets, mesh.tets)
        solution = calculix.solve(held, STEEL, SUPPORTS, LOADS)
        work.append(solution.work)
        norms.append(rc.adjoint.stress_norm(held, solution.displacements, STEEL, 8).value)
    found = (work[1] - work[0]) / (2 * step)
    assert part.gradient(compliance, parameter)[parameter] == pytest.approx(found, rel=.01)
    found = (norms[1] - norms[0]) / (2 * step)
    scale = .01 * norms[0] / 16
    assert part.gradient(by_node, parameter)[parameter] == pytest.approx(found, rel=.01, abs=scale)
