"""Studies on a Dask cluster, whose workers are threads here; tests/cluster/doe.py has processes."""
import itertools
import pickle
import sys
from pathlib import Path

import pytest

import remesh_client as rc

pytest.importorskip("distributed")
from distributed import Client, LocalCluster

from remesh_client.dask import learn_shares, map_designs, open_part, plan_designs

sys.path.insert(0, str(Path(__file__).parent.parent / "cluster"))
from bed import Bed, FaultyTier

BASE = {"a": 0, "b": 0, "c": 0}
GRID = [dict(zip("abc", values)) for values in itertools.product(range(4), repeat=3)]
# Three parameters of different features of tool1-a.
VALUES = {"pin_radius": (4, 4.5), "hole_circle": (36, 35), "bore.radius": (9, 8.5)}
DESIGNS = [dict(zip(VALUES, values)) for values in itertools.product(*VALUES.values())]


@pytest.fixture(scope="module")
def bed(remeshd):
    with Bed(remeshd, FaultyTier, replicas=2) as started:
        yield started


@pytest.fixture(scope="module")
def base(bed, cases):
    with rc.connect(bed.addresses) as daemon:
        yield daemon.mesh(cases / "tool1-a.json", nodes=500, file=False)


@pytest.fixture(scope="module")
def client(bed):
    yield from cluster(bed, 2)


def cluster(bed, workers):
    with LocalCluster(n_workers=workers, threads_per_worker=1, processes=False,
                      dashboard_address=":0", local_directory=bed.folder) as started:
        with Client(started) as client:
            yield client


def test_an_edit_of_a_factorial_changes_one_parameter_mostly_the_one_that_changes_least():
    plan = plan_designs(BASE, GRID, shares={"a": .3, "b": .2, "c": .1})
    changed = [tuple(change) for change in plan.changes]
    assert {names: changed.count(names) for names in set(changed)} == {
        (): 1, ("a",): 3, ("b",): 12, ("c",): 48}
    assert plan.parents[0] == -1 and plan.costs[0] == 0  # it has the base's values
    assert max(plan.depths) == 3
    places = {design: place for place, design in enumerate(plan.order)}
    assert sorted(places) == list(range(64))
    assert all(parent < 0 or places[parent] < places[design]
               for design, parent in enumerate(plan.parents))


def test_no_design_is_further_from_the_base_than_asked_for():
    for depth in (1, 2, 3):
        plan = plan_designs(BASE, GRID, depth=depth)
        assert max(plan.depths) == depth
        assert all(plan.depths[design] == (plan.depths[parent] + 1 if parent >= 0 else 1)
                   for design, parent in enumerate(plan.parents) if plan.changes[design])
    assert plan_designs(BASE, GRID, depth=1).changes == plan.from_base
    with pytest.raises(ValueError, match="depth"):
        plan_designs(BASE, GRID, depth=0)


def test_designs_that_share_no_value_are_made_of_the_base():
    plan = plan_designs(BASE, [{"a": k, "b": 7 - k, "c": (3 * k) % 8 + 1} for k in range(1, 6)])
    assert plan.parents == (-1,) * 5


def test_what_a_design_leaves_out_is_the_bases():
    plan = plan_designs({"a": 1, "b": "2*a"}, [{"a": 5, "b": 3.0}, {"a": 5}, {"b": 3}, {"a": 5.0}])
    assert plan.from_base == ({"a": 5, "b": 3.0}, {"a": 5}, {"b": 3}, {"a": 5.0})
    made = [{}, {}, {}, {}]
    for design in plan.order:
        parent = plan.parents[design]
        made[design] = {**(made[parent] if parent >= 0 else {"a": 1, "b": "2*a"}),
                        **plan.changes[design]}
    assert made == [{"a": 5, "b": 3}, {"a": 5, "b": "2*a"}, {"a": 1, "b": 3}, {"a": 5, "b": "2*a"}]
    assert plan.changes[3] == {}  # as the second
    with pytest.raises(KeyError, match="no parameter 'd'"):
        plan_designs(BASE, [{"d": 1}])


def test_results_are_what_one_daemon_makes_of_the_plan(client, bed, base, remeshd, cases):
    futures = map_designs(client, base, DESIGNS, addresses=bed.addresses)
    results = client.gather(futures)
    shares = learn_shares(client, base, DESIGNS, addresses=bed.addresses)
    assert set(shares) == set(VALUES) and all(0 < share < .5 for share in shares.values())
    seconds = learn_shares(client, base, DESIGNS, measure="seconds", addresses=bed.addresses)
    assert seconds == {name: made.seconds for name, made in zip(
        ("bore.radius", "hole_circle", "pin_radius"), (results[1], results[2], results[4]))}
    plan = plan_designs(DESIGNS[0], DESIGNS, shares=shares)
    assert max(plan.depths) > 1
    with rc.local(remeshd) as daemon, rc.connect(bed.addresses) as farm:
        parts = {-1: daemon.mesh(cases / "tool1-a.json", nodes=500, file=False)}
        for design in plan.order:
            parent = parts[plan.parents[design]]
            parts[design] = (parent.edit(plan.changes[design], file=False)
                             if plan.changes[design] else parent)
            made, part = results[design], parts[design]
            assert (made.revision, made.parent) == (part.revision, part.parent)
            assert (made.seconds > 0) == bool(plan.changes[design])
            assert made.figures["nodes_kept"] == part.report.nodes_kept
            assert made.figures["quality.dihedral_min"] == part.report.quality.dihedral_min
        mesh, right = farm.open(results[-1].revision).mesh(), parts[len(DESIGNS) - 1].mesh()
        assert mesh.points.tobytes() == right.points.tobytes()
        assert mesh.tets.tobytes() == right.tets.tobytes()
    assert {made.replica for made in results} <= set(bed.addresses)
    assert len(pickle.dumps(results[-1])) < 5000


def test_ids_are_the_same_whatever_the_number_of_workers(client, bed, base):
    designs = [{"pin_radius": 4 + k / 10, "hole_circle": 36 - k % 2} for k in range(6)]
    several = client.gather(map_designs(client, base, designs, addresses=bed.addresses))
    for alone in cluster(bed, 1):
        one = alone.gather(map_designs(alone, base.revision, designs, addresses=bed.addresses))
        assert [made.revision for made in one] == [made.revision for made in several]


def test_what_was_to_be_made_of_a_model_that_fails_is_made_of_the_base(client, bed, base):
    designs = [{"pin_radius": radius, "hole_circle": 34, "bore.radius": 8}
               for radius in ("-1", "4 + .2")]
    assert plan_designs({**DESIGNS[0]}, designs).parents == (-1, 0)
    fails, goes_well = map_designs(client, base, designs, addresses=bed.addresses, shares={})
    with pytest.raises(rc.InvalidRequest, match="radius"):
        fails.result()
    assert goes_well.result().parent == base.revision


def count_nodes(made, addresses):
    return len(open_part(made, addresses=addresses).mesh().points)


def test_a_task_may_have_the_mesh(client, bed, base):
    futures = map_designs(client, base, [{"pin_radius": 5}], addresses=bed.addresses)
    nodes = client.map(count_nodes, futures, addresses=bed.addresses)
    assert client.gather(nodes) == [futures[0].result().figures["nodes"]]


def test_another_replica_takes_over_and_each_worker_asks_its_own_first(client, bed, base,
                                                                      monkeypatch):
    monkeypatch.setenv("REMESH_ADDRESS", bed.addresses[1])
    designs = [{"pin_radius": 4.6 + k / 10} for k in range(4)]
    futures = map_designs(client, base, designs, addresses=bed.addresses)
    assert {made.replica for made in client.gather(futures)} == {bed.addresses[1]}
    bed.replicas[1].kill()
    designs = [{"pin_radius": 5.1 + k / 10} for k in range(4)]
    futures = map_designs(client, base, designs, addresses=bed.addresses)
    assert {made.replica for made in client.gather(futures)} == {bed.addresses[0]}
    bed.replicas[1].start()


def test_faults_of_the_caller_are_told(client, bed, base):
    with pytest.raises(KeyError, match="no parameter 'pin_radus'"):
        map_designs(client, base, [{"pin_radus": 5}], addresses=bed.addresses)
    with pytest.raises(rc.NotFound):
        map_designs(client, "0" * 64, [{"pin_radius": 5}], addresses=bed.addresses, retries=0)
    assert map_designs(client, base, [], addresses=bed.addresses) == []
